// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_SCOTCH_PARTITIONER_H
#define CGAL_DISTRIBUTED_COMPLEXES_SCOTCH_PARTITIONER_H

#include <CGAL/Distributed_complexes/Communicator.h>
#include <CGAL/Distributed_complexes/Distributed_graph.h>

#include <mpi.h>

#include <cstdio>
#include <limits>
#include <ptscotch.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDistributedComplexesRef

Partitioner that minimizes the number of edges between ranks, by PT-Scotch (C. Chevalier,
F. Pellegrini, *PT-Scotch: a tool for efficient parallel graph ordering*, 2008). The header needs
the component `Mpi` of the package, built with PT-Scotch. The partition is the same in each run.
*/
class Scotch_partitioner
{
public:
  /// Constructs a partitioner for the ranks of an MPI communicator.
  explicit Scotch_partitioner(MPI_Comm communicator = MPI_COMM_WORLD)
      : m_communicator(communicator) {}

  /// Returns the new owner of each own vertex. Collective.
  /// \param communicator a communicator with the ranks of the MPI communicator, in the same order
  /// \param graph the graph
  /// \throws Error on all ranks if PT-Scotch fails
  template <int d>
  std::vector<int> operator()(Communicator& communicator, const Distributed_graph<d>& graph) const {
    constexpr auto most = std::int64_t((std::numeric_limits<SCOTCH_Num>::max)());
    communicator.agree_on_error(graph.first.back() > most || graph.begin.back() > most
                                    ? "the complex is too large for the integers of PT-Scotch: use "
                                      "another partitioner"
                                    : "");
    const auto n = SCOTCH_Num(graph.weights.size());
    std::vector<SCOTCH_Num> begin(graph.begin.begin(), graph.begin.end()),
        neighbors(graph.neighbors.begin(), graph.neighbors.end()),
        weights(graph.weights.begin(), graph.weights.end()), parts(std::size_t(n) + 1, 0);
    neighbors.push_back(0); // no null pointers for empty ranks
    weights.push_back(0);
    // One thread: with several threads, PT-Scotch can wait forever unless MPI permits calls from
    // all threads.
    SCOTCH_Context context;
    SCOTCH_contextInit(&context);
    SCOTCH_contextThreadSpawn(&context, 1, nullptr);
    SCOTCH_Dgraph scotch, bound;
    SCOTCH_Strat strategy;
    bool has_failed = SCOTCH_dgraphInit(&scotch, m_communicator) != 0 ||
                      SCOTCH_dgraphInit(&bound, m_communicator) != 0;
    SCOTCH_stratInit(&strategy);
    SCOTCH_randomReset(); // the same partition in each run
    has_failed = has_failed ||
                 SCOTCH_dgraphBuild(&scotch, 0, n, n, begin.data(), begin.data() + 1,
                                    weights.data(), nullptr, begin.back(), begin.back(),
                                    neighbors.data(), nullptr, nullptr) != 0 ||
                 SCOTCH_contextBindDgraph(&context, &scotch, &bound) != 0;
    has_failed = communicator.reduced(Communicator::Operation::maximum, has_failed ? 1 : 0) != 0 ||
                 SCOTCH_dgraphPart(&bound, communicator.size(), &strategy, parts.data()) != 0;
    SCOTCH_stratExit(&strategy);
    SCOTCH_dgraphExit(&bound);
    SCOTCH_dgraphExit(&scotch);
    SCOTCH_contextExit(&context);
    communicator.agree_on_error(
        has_failed ? "PT-Scotch cannot divide the complex: use another partitioner" : "");
    return {parts.begin(), parts.begin() + n};
  }

private:
  MPI_Comm m_communicator;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DISTRIBUTED_COMPLEXES_SCOTCH_PARTITIONER_H
