// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_MPI_COMMUNICATOR_H
#define CGAL_DISTRIBUTED_COMPLEXES_MPI_COMMUNICATOR_H

#include <CGAL/Distributed_complexes/Communicator.h>
#include <CGAL/Mesh_support/Error.h>

#include <mpi.h>

#include <algorithm>
#include <climits>
#include <numeric>
#include <thread>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDistributedComplexesRef

Messages between processes through MPI. The header needs the component `Mpi` of the package.

Messages of `exchange()` can have any size; they are sent in blocks of at most 2^30 bytes.
`all_gather()` throws `Error` for more than 2^31 - 1 bytes of all ranks together. Errors of MPI end
the program. The receivers of an exchange are not known beforehand: the ranks agree by a nonblocking
barrier that all messages arrived (Hoefler, Siebert, Lumsdaine: *Scalable communication protocols
for dynamic sparse data exchange*, 2010). So the time of an exchange does not grow linearly with the
number of ranks.
*/
class Mpi_communicator : public Communicator
{
public:
  /// Constructs a communicator with the ranks of an MPI communicator, which is duplicated.
  /// Collective.
  /// \pre MPI is initialized, and is finalized after the destruction
  explicit Mpi_communicator(MPI_Comm communicator = MPI_COMM_WORLD) {
    MPI_Comm_dup(communicator, &m_communicator);
    MPI_Comm_rank(m_communicator, &m_rank);
    MPI_Comm_size(m_communicator, &m_size);
  }

  /// Frees the duplicate. Collective.
  ~Mpi_communicator() override { MPI_Comm_free(&m_communicator); }

  int rank() const override { return m_rank; }
  int size() const override { return m_size; }

private:
  static constexpr std::size_t block = std::size_t(1) << 30; // bytes; MPI counts are ints
  static constexpr int largest_tag = 32767;                  // that each MPI permits

  std::vector<Message> do_exchange(std::vector<Message> messages) override {
    // Other exchanges have other tags: a rank can begin the next one while others wait in this one.
    m_tag = m_tag < largest_tag - 1 ? m_tag + 1 : 0;
    std::vector<Message> result;
    std::vector<MPI_Request> requests;
    for (Message& message : messages) {
      if (message.rank == m_rank) {
        result.push_back(std::move(message));
        continue;
      }
      // A message of several blocks ends with a block that is not full.
      for (std::size_t begin = 0;; begin += block) {
        const std::size_t size = (std::min)(block, message.bytes.size() - begin);
        requests.emplace_back();
        MPI_Issend(message.bytes.data() + begin, int(size), MPI_BYTE, message.rank, m_tag,
                   m_communicator, &requests.back());
        if (size < block)
          break;
      }
    }
    MPI_Request barrier = MPI_REQUEST_NULL;
    for (bool is_waiting = false;;) {
      receive_one(result);
      std::this_thread::yield(); // processes may share cores
      int is_done = 0;
      if (is_waiting) {
        MPI_Test(&barrier, &is_done, MPI_STATUS_IGNORE);
        if (is_done != 0)
          break;
      } else {
        MPI_Testall(int(requests.size()), requests.data(), &is_done, MPI_STATUSES_IGNORE);
        if (is_done != 0) {
          MPI_Ibarrier(m_communicator, &barrier);
          is_waiting = true;
        }
      }
    }
    std::sort(result.begin(), result.end(),
              [](const Message& a, const Message& b) { return a.rank < b.rank; });
    return result;
  }

  // Receives a block if one has arrived.
  void receive_one(std::vector<Message>& result) {
    int has_arrived = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, m_tag, m_communicator, &has_arrived, &status);
    if (has_arrived == 0)
      return;
    int size = 0;
    MPI_Get_count(&status, MPI_BYTE, &size);
    auto it = std::find_if(result.begin(), result.end(), [&](const Message& message) {
      return message.rank == status.MPI_SOURCE;
    });
    if (it == result.end())
      it = result.insert(it, {status.MPI_SOURCE, {}});
    const std::size_t begin = it->bytes.size();
    it->bytes.resize(begin + std::size_t(size));
    MPI_Recv(it->bytes.data() + begin, size, MPI_BYTE, status.MPI_SOURCE, m_tag, m_communicator,
             MPI_STATUS_IGNORE);
  }

  std::vector<Bytes> do_all_gather(const Bytes& bytes) override {
    std::vector<std::int64_t> long_sizes(m_size);
    const auto long_size = std::int64_t(bytes.size());
    MPI_Allgather(&long_size, 1, MPI_INT64_T, long_sizes.data(), 1, MPI_INT64_T, m_communicator);
    if (std::accumulate(long_sizes.begin(), long_sizes.end(), std::int64_t(0)) > INT_MAX)
      throw Error(
          "the ranks exchange more than 2^31 - 1 bytes at once: there are too many components "
          "of labels"); // on all ranks
    const std::vector<int> sizes(long_sizes.begin(), long_sizes.end());
    std::vector<int> first(m_size, 0);
    const int size = int(long_size);
    std::partial_sum(sizes.begin(), sizes.end() - 1, first.begin() + 1);
    Bytes all(std::size_t(first.back()) + std::size_t(sizes.back()));
    MPI_Allgatherv(bytes.data(), size, MPI_BYTE, all.data(), sizes.data(), first.data(), MPI_BYTE,
                   m_communicator);
    std::vector<Bytes> result;
    for (int r = 0; r < m_size; ++r)
      result.emplace_back(all.begin() + first[r], all.begin() + first[r] + sizes[r]);
    return result;
  }

  void do_reduce(Operation operation, std::vector<std::int64_t>& numbers) override {
    MPI_Allreduce(MPI_IN_PLACE, numbers.data(), int(numbers.size()), MPI_INT64_T,
                  operation == Operation::sum       ? MPI_SUM
                  : operation == Operation::minimum ? MPI_MIN
                                                    : MPI_MAX,
                  m_communicator);
  }

  MPI_Comm m_communicator = MPI_COMM_NULL;
  int m_rank = 0, m_size = 1, m_tag = 0;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DISTRIBUTED_COMPLEXES_MPI_COMMUNICATOR_H
