// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Tests of the communicator and the partitioner that need MPI, on any number of processes. They run
// with mpirun only.

#include "small_meshes.h"
#include "test.h"

#include <CGAL/Distributed_complexes/Distributed_complex.h>
#include <CGAL/Distributed_complexes/Mpi_communicator.h>
#include <CGAL/Distributed_complexes/advect_distributed_interface.h>
#include <CGAL/Distributed_complexes/run_in_threads.h>
#ifdef DSC_WITH_SCOTCH
#include <CGAL/Distributed_complexes/Scotch_partitioner.h>
#endif

#include <mpi.h>

namespace test_mpi {

using small_meshes::Complex;
using Distributed = DSC::Distributed_complex<Complex>;

class Mpi : public testing::Test
{
protected:
  static void SetUpTestSuite() { MPI_Init(nullptr, nullptr); }
  static void TearDownTestSuite() { MPI_Finalize(); }
};

// A step in a field with strong shear, which makes many bad cells.
void move(Distributed& dsc, int step) {
  const auto velocity = [](const Complex::Point& p, double t) {
    return Complex::Vector(std::sin(7 * p.y() + t), std::sin(9 * p.z() - t), std::cos(8 * p.x()));
  };
  advect_interface(dsc, velocity, .1 * step, .05);
}

constexpr int steps = 3;

Complex ball() { return small_meshes::make_complex(small_meshes::grid(8, small_meshes::ball)); }

// Returns the checksums after each step on one rank.
std::vector<std::uint64_t> expected_checksums() {
  std::vector<std::uint64_t> result;
  DSC::run_in_threads(1, [&](DSC::Communicator& communicator) {
    Distributed dsc(communicator);
    dsc.distribute(ball());
    for (int step = 0; step < steps; ++step) {
      move(dsc, step);
      result.push_back(dsc.checksum());
    }
  });
  return result;
}

// All work is on the last process at first, so the first call divides the complex.
template <class Partitioner> void test_partitioner(const Partitioner& partitioner) {
  DSC::Mpi_communicator communicator;
  Distributed dsc(communicator);
  const int last = communicator.size() - 1;
  dsc.distribute(ball(), [last](std::size_t) { return last; });
  EXPECT_EQ(dsc.rebalance(partitioner), last > 0);
  EXPECT_LT(dsc.imbalance(), 1.2);
  const auto expected = expected_checksums();
  for (int step = 0; step < steps; ++step) {
    move(dsc, step);
    EXPECT_EQ(dsc.checksum(), expected[step]) << step;
    EXPECT_EQ(dsc.rebalance(partitioner, 1), last > 0);
    EXPECT_LT(dsc.imbalance(), 1.2);
    EXPECT_EQ(dsc.checksum(), expected[step]) << step;
  }
}

TEST_F(Mpi, Divides_the_work_along_a_curve) { test_partitioner(DSC::Curve_partitioner()); }

#ifdef DSC_WITH_SCOTCH
TEST_F(Mpi, Divides_the_work_with_Scotch) { test_partitioner(DSC::Scotch_partitioner()); }
#endif

// All processes get the message of the process that failed.
TEST_F(Mpi, Throws_the_error_of_one_process_on_all) {
  DSC::Mpi_communicator communicator;
  const int last = communicator.size() - 1;
  const auto error = thrown_by<DSC::Error>([&] {
    communicator.call_together([&] {
      if (communicator.rank() == last)
        throw DSC::Error("the last process fails");
    });
  });
  EXPECT_STREQ(error.what(), "the last process fails");
}

} // namespace test_mpi
