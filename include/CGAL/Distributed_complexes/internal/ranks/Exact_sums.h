// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_RANKS_EXACT_SUMS_H
#define CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_RANKS_EXACT_SUMS_H

#include <CGAL/Distributed_complexes/Communicator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the maximum of a number of all ranks.
// \pre The number is finite and not negative.
inline double maximum_of_ranks(Communicator& communicator, double number) {
  std::int64_t bits; // nonnegative doubles are ordered as their bits
  std::memcpy(&bits, &number, sizeof(bits));
  bits = communicator.reduced(Communicator::Operation::maximum, bits);
  std::memcpy(&number, &bits, sizeof(bits));
  return number;
}

/*
Sums of lists of numbers that do not depend on how the numbers are distributed among ranks. The
numbers are rounded to integers in units of 2^-60 of the power of two above the largest absolute
value of all ranks. The integers are summed exactly.
*/
template <int n> class Exact_sums
{
public:
  using Numbers = std::array<double, n>;

  explicit Exact_sums(Communicator& communicator) : m_communicator(communicator) {}

  // Returns the n sums of all numbers that the ranks give. A sum is NaN if one of its numbers is
  // not finite.
  Numbers operator()(const std::vector<Numbers>& numbers) {
    using Operation = Communicator::Operation;
    static constexpr int bits = 60;       // of the largest number
    static constexpr int limb = 40;       // bits of a part of a sum; 2^23 ranks can add parts
    static constexpr int infinite = 5000; // larger than the exponents of all finite numbers
    std::vector<std::int64_t> exponents(n, -infinite);
    for (const Numbers& x : numbers)
      for (int i = 0; i < n; ++i)
        if (x[i] != 0)
          exponents[i] = (std::max)(
              exponents[i], std::int64_t(std::isfinite(x[i]) ? std::ilogb(x[i]) + 1 : infinite));
    m_communicator.reduce(Operation::maximum, exponents);
    std::array<__int128, n> sums = {};
    for (const Numbers& x : numbers)
      for (int i = 0; i < n; ++i)
        if (x[i] != 0 && exponents[i] < infinite)
          sums[i] += std::llrint(std::ldexp(x[i], bits - int(exponents[i])));
    std::vector<std::int64_t> limbs;
    for (__int128 sum : sums)
      for (int k = 0; k < limbs_of_sum; ++k) {
        // All limbs but the last one are not negative.
        const std::int64_t part =
            std::int64_t(k + 1 < limbs_of_sum ? sum & ((__int128(1) << limb) - 1) : sum);
        limbs.push_back(part);
        sum >>= limb;
      }
    m_communicator.reduce(Operation::sum, limbs);
    Numbers result;
    for (int i = 0; i < n; ++i) {
      __int128 sum = 0;
      for (int k = limbs_of_sum; k-- > 0;)
        sum = sum * (__int128(1) << limb) + limbs[std::size_t(limbs_of_sum * i + k)];
      result[i] = exponents[i] < infinite ? std::ldexp(double(sum), int(exponents[i]) - bits)
                                          : std::nan("");
    }
    return result;
  }

private:
  static constexpr int limbs_of_sum = 3;

  Communicator& m_communicator;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_RANKS_EXACT_SUMS_H
