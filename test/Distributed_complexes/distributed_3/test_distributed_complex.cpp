// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Tests that a distributed complex is the same complex for any number of ranks and any partition.
// The ranks are threads. The gathered complex is validated by `Labeled_complex`, which shares no
// code with the distributed one.

#include "all_cases.h"
#include "small_meshes.h"
#include "temporary_folder.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/State.h>
#include <CGAL/Distributed_complexes/PVTU.h>
#include <CGAL/Distributed_complexes/adapt_distributed_interface.h>
#include <CGAL/Distributed_complexes/advect_distributed_adaptively.h>
#include <CGAL/Distributed_complexes/advect_distributed_interface.h>
#include <CGAL/Distributed_complexes/assign_distributed_cells.h>
#include <CGAL/Distributed_complexes/distributed_checkpoint.h>
#include <CGAL/Distributed_complexes/refine_distributed_complex_3.h>
#include <CGAL/Distributed_complexes/run_in_threads.h>
#include <CGAL/Interface_flows/Normal_offset.h>
#include <CGAL/Interface_flows/advect_adaptively.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/interface_flows_3.h>
#include <CGAL/Interface_flows/velocity_fields_3.h>
#include <CGAL/Mesh_files/VTU_3.h>
#include <CGAL/Mesh_files/checkpoint.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <CGAL/number_utils.h>

#include <mutex>

namespace {

using small_meshes::Complex;
using small_meshes::grid;
using small_meshes::make_complex;
using Distributed = DSC::Distributed_complex<Complex>;
using Report = DSC::Distributed_report<Complex>;
using Point = Complex::Point;
using Vector = Complex::Vector;

// A field with strong shear, which makes many bad cells.
Vector abuse(const Point& p, double t) {
  return {std::sin(7 * p.y() + t) + .5 * std::cos(11 * p.z()), std::sin(9 * p.z() - t),
          std::cos(8 * p.x() + 3 * p.y())};
}

// Calls f(dsc, rank) on ranks that are threads, with an empty complex.
template <class Function> void on_ranks(int ranks, const Function& f) {
  DSC::run_in_threads(ranks, [&](DSC::Communicator& communicator) {
    Distributed dsc(communicator);
    f(dsc, communicator.rank());
  });
}

// The same with a complex that is distributed before.
template <class Function> void on_ranks(int ranks, const Complex& start, const Function& f) {
  on_ranks(ranks, [&](Distributed& dsc, int rank) {
    dsc.distribute(start);
    f(dsc, rank);
  });
}

// A step of a motion.
using Step = std::function<Report(Distributed&, int step)>;

struct Case
{
  std::string name;
  Complex start;
  Step step;
  int steps;
};

Report offset(Distributed& dsc, double distance) {
  return advect_interface(dsc, DSC::Normal_offset{distance}, 0, 1);
}

std::vector<Case> cases() {
  std::vector<Case> result;
  result.push_back({"rotation", make_complex(grid(8, small_meshes::ball)),
                    [](Distributed& dsc, int) {
                      const DSC::Rigid_rotation_3 rotation(Point(0, 0, 0), Vector(1, 2, 3), .1);
                      return advect_interface(dsc, rotation, 0, 1);
                    },
                    4});
  result.push_back({"two balls that merge", make_complex(grid(8, small_meshes::two_balls)),
                    [](Distributed& dsc, int) { return offset(dsc, .05); }, 9});
  result.push_back({"eight phases that shrink", make_complex(grid(8, small_meshes::eight_phases)),
                    [](Distributed& dsc, int) { return offset(dsc, -.06); }, 5});
  result.push_back(
      {"abuse", make_complex(grid(8, small_meshes::ball)),
       [](Distributed& dsc, int step) { return advect_interface(dsc, abuse, .1 * step, .06); }, 5});
  result.push_back({"mean curvature", make_complex(grid(8, small_meshes::eight_phases)),
                    [](Distributed& dsc, int) {
                      return advect_interface(dsc, DSC::Mean_curvature_flow(), 0, .005);
                    },
                    4});
  Complex unit_cube;
  {
    auto mesh = grid(8, [](const auto& p) {
      return (p - Complex::Point_3(-.3, -.3, -.3)).squared_length() < .16;
    });
    for (auto& p : mesh.points)
      p = Complex::Point_3((1 + p.x()) / 2, (1 + p.y()) / 2, (1 + p.z()) / 2);
    unit_cube = make_complex(mesh);
  }
  result.push_back({"Enright", unit_cube,
                    [](Distributed& dsc, int step) {
                      return advect_interface(dsc, DSC::Enright_velocity_3(3), .1 * step, .1,
                                              DSC::Distributed_options<Distributed>(),
                                              DSC::Integration_scheme::rk4);
                    },
                    5});
  result.push_back({"Enright, adapted", unit_cube,
                    [](Distributed& dsc, int step) {
                      return advect_adaptively(dsc, DSC::Enright_velocity_3(3), .1 * step, .1);
                    },
                    9});
  result.push_back({"mean curvature, adapted", make_complex(grid(8, small_meshes::eight_phases)),
                    [](Distributed& dsc, int step) {
                      return advect_adaptively(dsc, DSC::Mean_curvature_flow(), .005 * step, .005);
                    },
                    4});
  return result;
}

// A partition among a number of ranks.
struct Partition
{
  std::string name;
  int ranks;
  std::function<int(std::size_t i, const Point& p)> owner; // empty for the default
};

std::vector<Partition> partitions() {
  std::vector<Partition> result;
  for (int ranks : {2, 7})
    result.push_back({"curve, " + std::to_string(ranks), ranks, {}});
  result.push_back(
      {"random", 3, [](std::size_t i, const Point&) { return int(DSC::internal::mixed(i) % 3); }});
  result.push_back({"across the interface", 4, [](std::size_t, const Point& p) {
                      return (p.x() < .1 ? 0 : 1) + (p.y() < .1 ? 0 : 2);
                    }});
  result.push_back({"empty ranks", 4, [](std::size_t, const Point&) { return 2; }});
  return result;
}

// What a run leaves: the checksums and the sums of the reports after each step.
struct Result
{
  std::vector<std::uint64_t> checksums;
  std::vector<std::int64_t> numbers;
  std::vector<double> volumes;
  Complex complex; // at the end

  void add(const Report& r) {
    for (std::int64_t n : {r.unfinished, r.flat, r.vanished, r.stopped_at_boundary,
                           std::int64_t(r.passes), r.rounds, r.patches, r.split, r.collapsed,
                           r.flipped, r.smoothed, r.inserted, r.relocated, r.relabeled})
      numbers.push_back(n);
    for (const auto& change : r.labels) {
      for (std::size_t n : {change.before, change.after, change.merged, change.split,
                            change.vanished, change.appeared})
        numbers.push_back(std::int64_t(n));
      volumes.push_back(change.volume_after);
    }
    for (const auto& event : r.events) {
      numbers.push_back(int(event.kind));
      for (const auto* list : {&event.before, &event.after})
        for (const auto& component : *list) {
          numbers.push_back(component.component);
          volumes.push_back(component.volume);
        }
    }
  }
};

void distribute(Distributed& dsc, const Complex& start, const Partition& partition) {
  if (!partition.owner) {
    dsc.distribute(start);
    return;
  }
  const auto vertices = start.vertices();
  dsc.distribute(start,
                 [&](std::size_t i) { return partition.owner(i, start.position(vertices[i])); });
}

Result run(const Case& c, const Partition& partition) {
  Result result;
  on_ranks(partition.ranks, [&](Distributed& dsc, int rank) {
    distribute(dsc, c.start, partition);
    for (int step = 0; step < c.steps; ++step) {
      const Report report = c.step(dsc, step);
      const std::uint64_t checksum = dsc.checksum();
      if (rank == 0) {
        result.checksums.push_back(checksum);
        result.add(report);
      }
    }
    Complex gathered = dsc.gather();
    if (rank == 0)
      result.complex = std::move(gathered);
  });
  return result;
}

// Two partitions of each case, or all of them.
TEST(Distributed_complex, Is_equal_for_any_number_of_ranks_and_any_partition) {
  const auto partitions_of_all = partitions();
  const std::size_t number = all_cases() ? partitions_of_all.size() : 2;
  std::size_t next = 0;
  for (const Case& c : cases()) {
    const Result one = run(c, {"one rank", 1, {}});
    EXPECT_TRUE(one.complex.is_valid(true)) << c.name;
    for (std::size_t i = 0; i < number; ++i) {
      const Partition& partition = partitions_of_all[next++ % partitions_of_all.size()];
      const Result other = run(c, partition);
      EXPECT_EQ(other.checksums, one.checksums) << c.name << ", " << partition.name;
      EXPECT_EQ(other.numbers, one.numbers) << c.name << ", " << partition.name;
      EXPECT_EQ(other.volumes, one.volumes) << c.name << ", " << partition.name;
      EXPECT_EQ(other.complex.state(), one.complex.state()) << c.name << ", " << partition.name;
    }
  }
}

// The exact volumes are those of one rank without patches.
TEST(Distributed_complex, Moves_as_a_complex_on_one_rank_does) {
  Case c = cases()[3]; // abuse
  const Result distributed = run(c, {"three ranks", 3, {}});
  for (int step = 0; step < c.steps; ++step)
    DSC::advect_interface(
        c.start, abuse, .1 * step, .06,
        // distributed steps are not divided, and stop at the sides
        CGAL::parameters::largest_displacement(0.).domain_rule(DSC::Domain_rule::stop));
  // A few vertices of this coarse mesh do not arrive, other ones in the two algorithms.
  EXPECT_NEAR(distributed.complex.volume(1), c.start.volume(1), .08 * c.start.volume(1));
  const auto worst = [](const Complex& complex) {
    double result = 1;
    for (auto cell : complex.finite_cells())
      result = (std::min)(result, cell->quality());
    return result;
  };
  EXPECT_GT(worst(distributed.complex), .2 * worst(c.start));
  EXPECT_GT(distributed.complex.number_of_cells(), c.start.number_of_cells() / 2);
}

// The flow stretches the interface, so both get more and smaller facets.
TEST(Distributed_complex, Is_adapted_as_a_complex_on_one_rank_is) {
  Case c = cases()[6]; // Enright
  const std::size_t before = c.start.interface_vertices().size();
  const Result distributed = run(c, {"three ranks", 3, {}});
  DSC::Adaptive_advection_options<Complex> undivided; // as distributed steps
  undivided.advection.largest_displacement = 0;
  for (int step = 0; step < c.steps; ++step)
    DSC::advect_adaptively(c.start, DSC::Enright_velocity_3(3), .1 * step, .1, undivided);
  const auto vertices = double(c.start.interface_vertices().size());
  EXPECT_GT(vertices, 1.2 * double(before));
  EXPECT_NEAR(double(distributed.complex.interface_vertices().size()), vertices, .2 * vertices);
  // The radius of the ball is less than two edges.
  EXPECT_NEAR(distributed.complex.volume(1), c.start.volume(1), .08 * c.start.volume(1));
  const auto cells = double(c.start.number_of_cells());
  EXPECT_NEAR(double(distributed.complex.number_of_cells()), cells, .2 * cells);
}

TEST(Distributed_complex, Has_the_target_edge_lengths_of_a_complex_on_one_rank) {
  const Complex start = cases()[6].start;
  const DSC::Interface_snapshot<Complex> snapshot(start);
  const auto positions = snapshot.positions(start);
  const double edge = start.mean_interface_edge();
  using Rule = DSC::Adaptation_rule<3>;
  const std::vector<double> expected =
      DSC::internal::Curvature_lengths<Complex>(
          snapshot, positions, DSC::internal::Smooth_normals<Complex>(snapshot, positions, 180),
          .04 * edge, Rule::shortest * edge)
          .graded(Rule::longest * edge, Rule::gradation);
  EXPECT_LT(*std::min_element(expected.begin(), expected.end()), Rule::longest * edge);
  const auto vertices = start.vertices();
  on_ranks(4, [&](Distributed& dsc, int) {
    dsc.distribute(start, [](std::size_t i) { return int(DSC::internal::mixed(i) % 4); });
    const auto interface_ = dsc.interface_here();
    const DSC::internal::Distributed_adaptation<Complex> adaptation(dsc, interface_, {.04, 180});
    for (std::size_t i = 0; i < interface_.indices.size(); ++i) {
      // The ids are the numbers of the vertices of `start`.
      const auto id = dsc.mesh().piece.vertex(interface_.indices[i]).id;
      const auto place =
          std::find(snapshot.vertices.begin(), snapshot.vertices.end(), vertices[id]);
      ASSERT_NE(place, snapshot.vertices.end());
      EXPECT_NEAR(adaptation.target_lengths()[i],
                  expected[std::size_t(place - snapshot.vertices.begin())], 1e-12);
    }
    EXPECT_EQ(adaptation.is_worn(),
              DSC::Interface_adaptation<Complex>(start, snapshot, {.04, 180}).is_worn());
  });
}

TEST(Distributed_complex, Detail_off_the_interface_is_controlled) {
  const Complex start = make_complex(grid(8, small_meshes::ball));
  Complex alone = start;
  DSC::Detail_options<Complex> options_alone;
  options_alone.collapse_length = 2;
  DSC::internal::run_detail_control(alone, options_alone);
  const auto cells = double(alone.number_of_cells());
  on_ranks(3, start, [&](Distributed& dsc, int rank) {
    DSC::Detail_options<Distributed::Part> options;
    options.collapse_length = 2;
    const auto first = control_detail(dsc, options);
    EXPECT_GT(first.collapsed, 0u);
    EXPECT_NEAR(double(dsc.number_of_cells()), cells, .1 * cells);
    // What failed is not tried again.
    const auto again = control_detail(dsc, options);
    EXPECT_EQ(again.collapsed + again.split, 0u);
    const Complex gathered = dsc.gather();
    if (rank == 0) {
      EXPECT_TRUE(gathered.is_valid(true));
      EXPECT_EQ(gathered.interface_vertices().size(), start.interface_vertices().size());
      EXPECT_NEAR(gathered.volume(1), start.volume(1), 1e-12);
    }
    options.change_interface = true;
    EXPECT_THROW(control_detail(dsc, options), DSC::Error);
    dsc.distribute(make_complex(grid(4, [](const auto&) { return false; })));
    EXPECT_EQ(control_detail(dsc, DSC::Detail_options<Distributed::Part>()).collapsed, 0u);
  });
}

TEST(Distributed_complex, Adaptation_keeps_the_components) {
  const Complex start = make_complex(grid(8, small_meshes::two_balls));
  on_ranks(3, start, [&](Distributed& dsc, int rank) {
    const auto before = dsc.mesh().components;
    const DSC::Adaptation_options options = {.01, 180, false};
    const auto changes =
        keep_interface_fit(dsc, options, [](const auto& i) { return i.positions; });
    EXPECT_GT(changes.split, 0u);
    const auto& after = dsc.mesh().components;
    ASSERT_EQ(after.size(), before.size());
    for (auto a = after.begin(), b = before.begin(); a != after.end(); ++a, ++b) {
      EXPECT_EQ(a->first, b->first);
      EXPECT_EQ(a->second.label, b->second.label);
    }
    const Complex gathered = dsc.gather();
    if (rank == 0) {
      EXPECT_TRUE(gathered.is_valid(true));
      const DSC::internal::Label_totals totals(dsc.mesh().domain_measure);
      double volume = 0;
      for (const auto& [number, component] : after)
        if (component.label == 1)
          volume += totals.volume_of(component.volume);
      EXPECT_NEAR(volume, gathered.volume(1), 1e-9);
    }
    // The number of destinations is wrong on one rank.
    EXPECT_THROW(keep_interface_fit(dsc, {.001, 180, true},
                                    [&](const auto& i) {
                                      auto result = i.positions;
                                      if (rank == 1)
                                        result.pop_back();
                                      return result;
                                    }),
                 DSC::Error);
  });
}

TEST(Distributed_complex, Rotates_without_changing_the_mesh) {
  const Case c = cases()[0];
  const Result result = run(c, {"three ranks", 3, {}});
  EXPECT_EQ(result.complex.number_of_cells(), c.start.number_of_cells());
  EXPECT_NEAR(result.complex.volume(1), c.start.volume(1), 1e-12);
}

// The two systems are solved by different code.
TEST(Distributed_complex, Has_the_mean_curvature_of_a_complex_on_one_rank) {
  Complex start = make_complex(grid(8, small_meshes::eight_phases));
  on_ranks(3, start, [&](Distributed& dsc, int) {
    const auto interface_ = dsc.interface_here();
    const auto found =
        DSC::internal::mean_curvature_destinations(dsc, interface_, DSC::Interface_energy(), .002);
    const DSC::Interface_snapshot<Complex> snapshot(start);
    std::vector<Point> expected;
    DSC::Mean_curvature_flow()(snapshot, snapshot.positions(start), 0, .002, expected);
    const auto vertices = start.vertices();
    for (std::size_t i = 0; i < found.size(); ++i) {
      // The ids are the numbers of the vertices of `start`.
      const auto id = dsc.mesh().piece.vertex(interface_.indices[i]).id;
      const auto place =
          std::find(snapshot.vertices.begin(), snapshot.vertices.end(), vertices[id]);
      ASSERT_NE(place, snapshot.vertices.end());
      const Point& p = expected[std::size_t(place - snapshot.vertices.begin())];
      EXPECT_LT((p - found[i]).squared_length(), 1e-18);
    }
    EXPECT_THROW(advect_interface(dsc, DSC::Mean_curvature_flow(true), 0, .01), DSC::Error);
  });
}

TEST(Distributed_complex, Reports_merging_and_vanishing_components) {
  using Kind = DSC::Component_event::Kind;
  on_ranks(3, make_complex(grid(8, small_meshes::two_balls)), [&](Distributed& dsc, int rank) {
    EXPECT_EQ(dsc.number_of_components(1), 2u);
    std::vector<DSC::Component_event> events;
    for (int step = 0; step < 10 && events.empty(); ++step) {
      const Report report = offset(dsc, .05);
      events.insert(events.end(), report.events.begin(), report.events.end());
    }
    ASSERT_FALSE(events.empty());
    EXPECT_EQ(events.front().kind, Kind::merged);
    EXPECT_EQ(events.front().label, 1);
    EXPECT_EQ(events.front().before.size(), 2u);
    EXPECT_EQ(dsc.number_of_components(1), 1u);
    EXPECT_EQ(dsc.gather().number_of_components(1), rank == 0 ? 1u : 0u);

    dsc.distribute(make_complex(grid(8, small_meshes::two_balls)));
    std::size_t vanished = 0;
    for (int step = 0; step < 12; ++step)
      for (const auto& change : offset(dsc, -.05).labels)
        vanished += change.label == 1 ? change.vanished : 0;
    EXPECT_EQ(vanished, 2u);
    EXPECT_EQ(dsc.number_of_components(1), 0u);
  });
}

// A migration changes the owners only.
TEST(Distributed_complex, Migrates_cells_with_their_data) {
  Case c = cases()[3];
  c.steps = 3;
  const Result one = run(c, {"one rank", 1, {}});
  on_ranks(3, c.start, [&](Distributed& dsc, int) {
    for (int step = 0; step < c.steps; ++step) {
      c.step(dsc, step);
      const std::uint64_t before = dsc.checksum();
      dsc.migrate([&](std::uint64_t id, const Point&) { return int((id / 50 + step) % 3); });
      EXPECT_EQ(dsc.checksum(), before);
      EXPECT_EQ(before, one.checksums[step]);
    }
  });
}

TEST(Distributed_complex, Rebalances_the_work) {
  Case c = cases()[3]; // abuse
  c.steps = 3;
  const Result one = run(c, {"one rank", 1, {}});
  on_ranks(5, [&](Distributed& dsc, int) {
    dsc.distribute(c.start, [](std::size_t) { return 3; });
    EXPECT_DOUBLE_EQ(dsc.imbalance(), 5);
    for (int step = 0; step < c.steps; ++step) {
      c.step(dsc, step);
      const double before = dsc.imbalance();
      EXPECT_EQ(dsc.rebalance(), before > 1.2);
      EXPECT_LT(dsc.imbalance(), 1.2);
      EXPECT_EQ(dsc.checksum(), one.checksums[step]);
    }
    const auto graph = dsc.graph();
    EXPECT_EQ(graph.first.back(), std::int64_t(dsc.number_of_vertices()));
    for (std::int64_t n : graph.neighbors)
      EXPECT_LT(n, graph.first.back());
  });
}

TEST(Distributed_complex, Is_refined_without_changing_the_interface) {
  const Complex start = make_complex(grid(4, small_meshes::ball));
  std::vector<std::uint64_t> checksums;
  for (int ranks : {1, 3}) {
    on_ranks(ranks, start, [&](Distributed& dsc, int rank) {
      refine_3(dsc);
      refine_3(dsc);
      EXPECT_EQ(dsc.number_of_cells(), 64 * start.number_of_cells());
      const std::uint64_t checksum = dsc.checksum();
      offset(dsc, .01);
      const std::uint64_t moved = dsc.checksum();
      const Complex gathered = dsc.gather();
      if (rank > 0)
        return;
      checksums.insert(checksums.end(), {checksum, moved});
      EXPECT_TRUE(gathered.is_valid(true));
    });
  }
  EXPECT_EQ(checksums[0], checksums[2]);
  EXPECT_EQ(checksums[1], checksums[3]);
  on_ranks(2, start, [&](Distributed& dsc, int rank) {
    refine_3(dsc);
    const Complex gathered = dsc.gather();
    if (rank == 0) {
      EXPECT_NEAR(gathered.volume(1), start.volume(1), 1e-13);
      EXPECT_NEAR(gathered.area(1), start.area(1), 1e-12);
      EXPECT_NEAR(gathered.mean_interface_edge(), dsc.mean_interface_edge(), 1e-12);
    }
  });
}

// Each rank gives some cells of a mesh.
TEST(Distributed_complex, Is_assembled_from_cells_of_all_ranks) {
  const auto mesh = grid(4, small_meshes::ball);
  const Complex whole = make_complex(mesh);
  std::vector<std::uint64_t> checksums;
  const auto cells_of = [&](int rank, int ranks) {
    DSC::Cells_of_rank<Complex> result;
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      result.ids.push_back(1000 + 3 * v);
      result.points.emplace_back(mesh.points[v].x(), mesh.points[v].y(), mesh.points[v].z());
    }
    for (std::size_t c = 0; c < mesh.tetrahedra.size(); ++c)
      if (int(DSC::internal::mixed(c) % unsigned(ranks)) == rank) {
        result.cells.push_back(mesh.tetrahedra[c]);
        result.labels.push_back(mesh.labels[c]);
      }
    return result;
  };
  for (int ranks : {1, 2, 5}) {
    on_ranks(ranks, [&](Distributed& dsc, int rank) {
      assign_cells(dsc, cells_of(rank, ranks));
      EXPECT_EQ(dsc.number_of_cells(), whole.number_of_cells());
      EXPECT_NEAR(dsc.mean_interface_edge(), whole.mean_interface_edge(), 1e-12);
      EXPECT_NEAR(dsc.mesh().minimum_interface_edge, whole.minimum_interface_edge(), 1e-12);
      offset(dsc, .05);
      const std::uint64_t checksum = dsc.checksum();
      const Complex gathered = dsc.gather();
      if (rank > 0)
        return;
      checksums.push_back(checksum);
      EXPECT_TRUE(gathered.is_valid(true));
      EXPECT_EQ(gathered.number_of_components(1), 1u);
    });
  }
  EXPECT_EQ(checksums[1], checksums[0]);
  EXPECT_EQ(checksums[2], checksums[0]);
  const auto expect_error = [&](const auto& damage) {
    on_ranks(3, [&](Distributed& dsc, int rank) {
      auto cells = cells_of(rank, 3);
      if (rank == 1)
        damage(cells);
      EXPECT_THROW(assign_cells(dsc, cells), DSC::Error);
      EXPECT_EQ(dsc.number_of_cells(), 0u);
    });
  };
  expect_error([](auto& cells) { cells.labels.pop_back(); });
  expect_error([](auto& cells) { cells.cells.pop_back(), cells.labels.pop_back(); });
  expect_error([](auto& cells) { std::swap(cells.cells[0][0], cells.cells[0][1]); });
  expect_error([](auto& cells) { cells.cells[0][0] = cells.ids.size(); });
  expect_error(
      [](auto& cells) { cells.points[0] = Point(std::numeric_limits<double>::infinity(), 0, 0); });
}

TEST(Distributed_complex, May_be_empty_or_have_no_interface) {
  const Complex one_label = make_complex(grid(2, small_meshes::uniform));
  for (const Complex& start : {Complex(), one_label})
    DSC::run_in_threads(3, [&](DSC::Communicator& communicator) {
      const Temporary_folder folder;
      Distributed dsc(communicator);
      dsc.distribute(start);
      const std::uint64_t before = dsc.checksum();
      const Report report = offset(dsc, .1);
      EXPECT_TRUE(report.complete);
      EXPECT_EQ(report.passes, 0u);
      EXPECT_TRUE(advect_interface(dsc, DSC::Mean_curvature_flow(), 0, .1).complete);
      EXPECT_EQ(dsc.checksum(), before);
      dsc.rebalance();
      EXPECT_EQ(dsc.number_of_cells(), start.number_of_cells());
      EXPECT_EQ(dsc.label_measures().size(), start.labels().size());
      EXPECT_EQ(dsc.gather().number_of_cells(),
                communicator.rank() == 0 ? start.number_of_cells() : 0);
      CGAL::IO::write_PVTU(folder / "cells.pvtu", dsc);
      CGAL::IO::write_interface_PVTU(folder / "interface.pvtu", dsc);
      CGAL::IO::write_checkpoint(folder / "checkpoint.dsc", dsc);
    });
}

// Many labels, of which most share no cell.
TEST(Distributed_complex, May_have_many_labels) {
  const Complex start = make_complex(grid(6, [](const auto& p) {
    return int(std::floor(3 * (p.x() + 1))) + 6 * int(std::floor(3 * (p.y() + 1))) +
           36 * int(std::floor(3 * (p.z() + 1)));
  }));
  std::vector<std::uint64_t> checksums;
  for (int ranks : {1, 3}) {
    on_ranks(ranks, start, [&](Distributed& dsc, int rank) {
      const Report report = advect_interface(dsc, DSC::Mean_curvature_flow(), 0, .002);
      const std::uint64_t checksum = dsc.checksum();
      EXPECT_EQ(report.labels.size(), 216u);
      EXPECT_EQ(dsc.label_measures().size(), 216u);
      if (rank == 0)
        checksums.push_back(checksum);
    });
  }
  EXPECT_EQ(checksums[0], checksums[1]);
}

TEST(Distributed_complex, Topology_changes_can_be_forbidden) {
  on_ranks(2, make_complex(grid(8, small_meshes::two_balls)), [&](Distributed& dsc, int) {
    DSC::Distributed_options<Distributed> options;
    options.forbid_topology_changes();
    for (int step = 0; step < 7; ++step)
      advect_interface(dsc, DSC::Normal_offset{.05}, 0, 1, options);
    EXPECT_EQ(dsc.number_of_components(1), 2u);
  });
}

TEST(Distributed_complex, Continues_from_a_checkpoint_with_another_number_of_ranks) {
  const Case c = cases()[1];
  const Result one = run(c, {"one rank", 1, {}});
  const Temporary_folder folder;
  const std::string path = folder / "checkpoint.dsc";
  int done = 0;
  for (int ranks : {3, 1, 5, 2}) {
    on_ranks(ranks, [&](Distributed& dsc, int) {
      if (done == 0)
        dsc.distribute(c.start);
      else
        EXPECT_EQ(CGAL::IO::read_checkpoint(path, dsc), "step " + std::to_string(done));
      c.step(dsc, done);
      EXPECT_EQ(dsc.checksum(), one.checksums[done]);
      CGAL::IO::write_checkpoint(path, dsc, "step " + std::to_string(done + 1));
    });
    ++done;
  }
}

TEST(Distributed_complex, Damaged_checkpoints_are_refused_on_all_ranks) {
  const Temporary_folder folder;
  const std::string path = folder / "checkpoint.dsc";
  on_ranks(2, make_complex(grid(2, small_meshes::four_phases)),
           [&](Distributed& dsc, int) { CGAL::IO::write_checkpoint(path, dsc); });
  EXPECT_TRUE(CGAL::IO::is_distributed_checkpoint(path));
  EXPECT_EQ(CGAL::IO::checkpoint_dimension(path), 0);
  std::string bytes;
  {
    std::ifstream in(path, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(in), {});
  }
  std::mt19937 random(1);
  const auto expect_error = [&](const std::string& damaged) {
    std::ofstream(path, std::ios::binary) << damaged;
    on_ranks(3, [&](Distributed& dsc, int) {
      EXPECT_THROW(CGAL::IO::read_checkpoint(path, dsc), DSC::Error);
    });
  };
  for (int i = 0; i < 30; ++i) {
    expect_error(bytes.substr(0, random() % bytes.size()));
    std::string damaged = bytes;
    damaged[random() % bytes.size()] ^= char(1 + random() % 255);
    expect_error(damaged);
  }
  expect_error("\211DSCR3\r\n" + bytes.substr(8)); // the magic bytes of older versions
  on_ranks(2, [&](Distributed& dsc, int) {
    EXPECT_THROW(CGAL::IO::read_checkpoint(folder / "missing.dsc", dsc), DSC::Error);
    EXPECT_THROW(CGAL::IO::write_checkpoint(folder / "no/folder.dsc", dsc), DSC::Error);
  });
}

TEST(Distributed_complex, Each_rank_writes_its_cells_once) {
  const Temporary_folder folder;
  const Complex start = make_complex(grid(4, small_meshes::ball));
  on_ranks(3, start, [&](Distributed& dsc, int) {
    CGAL::IO::write_PVTU(folder / "cells.pvtu", dsc);
    CGAL::IO::write_interface_PVTU(folder / "a<b & c.pvtu", dsc);
    EXPECT_THROW(CGAL::IO::write_PVTU(folder / "no/cells.pvtu", dsc), DSC::Error);
  });
  std::size_t cells = 0;
  std::ptrdiff_t labeled = 0;
  for (int r = 0; r < 3; ++r) {
    std::vector<Complex::Point_3> points;
    std::vector<std::array<std::size_t, 4>> tetrahedra;
    std::vector<int> labels;
    CGAL::IO::read_VTU(folder / ("cells_" + std::to_string(r) + ".vtu"), points, tetrahedra, labels,
                       "label");
    cells += tetrahedra.size();
    labeled += std::count(labels.begin(), labels.end(), 1);
  }
  EXPECT_EQ(cells, start.number_of_cells());
  EXPECT_EQ(std::size_t(labeled), start.number_of_cells(1));
  EXPECT_TRUE(std::ifstream(folder / "a<b & c_2.vtu"));
  std::ifstream list(folder / "a<b & c.pvtu");
  const std::string text(std::istreambuf_iterator<char>(list), {});
  EXPECT_PRED2(contains, text, "\"a&lt;b &amp; c_2.vtu\"");
}

TEST(Distributed_complex, Errors_on_one_rank_are_thrown_on_all_ranks) {
  const Complex start = make_complex(grid(4, small_meshes::ball));
  on_ranks(3, [&](Distributed& dsc, int rank) {
    EXPECT_THROW(dsc.distribute(start, [](std::size_t) { return 3; }), DSC::Error);
    dsc.distribute(start);
    const std::uint64_t before = dsc.checksum();
    const auto field = [&](const Point&, double) -> Vector {
      if (rank == 1)
        throw std::runtime_error("no velocity");
      return {.01, 0, 0};
    };
    const auto message_of = [&](const auto& velocity) -> std::string {
      try {
        advect_interface(dsc, velocity, 0, 1);
      } catch (const DSC::Error& e) {
        return e.what();
      }
      return "";
    };
    EXPECT_EQ(message_of(field), "no velocity");
    const auto on_facets = [&](const DSC::Interface_snapshot<Complex>&,
                               const std::vector<Point>& positions, double,
                               std::vector<Vector>& velocities) {
      velocities.assign(positions.size(), Vector(.01, 0, 0));
      if (rank == 2)
        throw std::runtime_error("no facets");
    };
    EXPECT_EQ(message_of(on_facets), "no facets");
    EXPECT_NE(message_of([&](const Point&, double) {
                const double nan = std::numeric_limits<double>::quiet_NaN();
                return rank == 0 ? Vector(nan, 0, 0) : Vector(.01, 0, 0);
              }),
              "");
    EXPECT_NE(
        message_of([&](const DSC::Interface_snapshot<Complex>&, const std::vector<Point>& positions,
                       double, std::vector<Vector>& velocities) {
          const double nan = std::numeric_limits<double>::quiet_NaN();
          velocities.assign(positions.size(), rank == 0 ? Vector(nan, 0, 0) : Vector(.01, 0, 0));
        }),
        "");
    DSC::Distributed_options<Distributed> options;
    options.quality_threshold = rank == 1 ? 2 : .2;
    EXPECT_THROW(advect_interface(dsc, DSC::Normal_offset{.01}, 0, 1, options), DSC::Error);
    EXPECT_EQ(dsc.checksum(), before);
  });
}

// A rank is interrupted in a step. All ranks return to the state before the step and go on.
TEST(Distributed_complex, Interrupts_of_one_rank_stop_all_ranks) {
  Case c = cases()[3];
  c.steps = 3;
  const Result one = run(c, {"one rank", 1, {}});
  on_ranks(3, c.start, [&](Distributed& dsc, int rank) {
    for (int step = 0; step < c.steps; ++step) {
      const auto before = dsc.state();
      {
        int calls = 0;
        const DSC::Progress_scope scope(
            [&](const char*) { return rank != 1 || ++calls < 3 + 40 * step; },
            std::chrono::milliseconds(0));
        EXPECT_THROW(c.step(dsc, step), DSC::Interrupted_error);
      }
      dsc.restore(before);
      c.step(dsc, step);
      EXPECT_EQ(dsc.checksum(), one.checksums[step]);
    }
  });
}

// The complex stays valid after an error in a patch, and later events name all changes.
TEST(Distributed_complex, Goes_on_after_an_error_in_a_patch) {
  on_ranks(3, make_complex(grid(8, small_meshes::two_balls)), [&](Distributed& dsc, int rank) {
    DSC::Distributed_options<Distributed> options;
    bool has_thrown = false;
    options.topology_control = [](const Distributed::Part&, Distributed::Part::Cell_handle,
                                  int) -> bool { throw std::runtime_error("no control"); };
    for (int step = 0; step < 10; ++step) {
      try {
        advect_interface(dsc, DSC::Normal_offset{.05}, 0, 1,
                         has_thrown ? DSC::Distributed_options<Distributed>() : options);
      } catch (const DSC::Error& e) {
        EXPECT_STREQ(e.what(), "no control");
        has_thrown = true;
      }
      const Complex gathered = dsc.gather();
      EXPECT_TRUE(rank > 0 || gathered.is_valid(true));
    }
    EXPECT_TRUE(has_thrown);
    EXPECT_EQ(dsc.number_of_components(1), 1u);
  });
}

TEST(Distributed_complex, A_rank_that_ends_ends_the_others) {
  EXPECT_THROW(DSC::run_in_threads(3,
                                   [&](DSC::Communicator& communicator) {
                                     if (communicator.rank() == 2)
                                       throw std::runtime_error("this rank ends");
                                     communicator.all_gather({});
                                     communicator.reduced(DSC::Communicator::Operation::sum, 1);
                                   }),
               std::runtime_error);
}

TEST(Distributed_complex, Stops_at_the_boundary_of_a_box) {
  on_ranks(2, make_complex(grid(8, small_meshes::ball)), [&](Distributed& dsc, int rank) {
    const auto distant = [](const Point&, double) { return Vector(2, 0, 0); };
    const Report report = advect_interface(dsc, distant, 0, .3);
    EXPECT_GT(report.stopped_at_boundary, 0);
    const Complex gathered = dsc.gather();
    EXPECT_TRUE(rank > 0 || gathered.is_valid(true));
  });
}

TEST(Exact_sums, Do_not_depend_on_the_distribution) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> exponent(-300, 300), sign(-1, 1);
  std::vector<std::array<double, 2>> numbers;
  long double sum = 0;
  for (int i = 0; i < 1000; ++i) {
    numbers.push_back({sign(random) * std::pow(10, exponent(random) / 20), double(i % 7) - 3});
    sum += numbers.back()[0];
  }
  std::vector<std::array<double, 2>> results;
  for (int ranks : {1, 2, 5}) {
    std::mutex mutex;
    DSC::run_in_threads(ranks, [&](DSC::Communicator& communicator) {
      std::vector<std::array<double, 2>> own;
      for (std::size_t i = 0; i < numbers.size(); ++i)
        if (int(DSC::internal::mixed(i) % unsigned(ranks)) == communicator.rank())
          own.push_back(numbers[i]);
      const auto result = DSC::internal::Exact_sums<2>(communicator)(own);
      const std::lock_guard<std::mutex> lock(mutex);
      results.push_back(result);
    });
  }
  for (const auto& result : results)
    EXPECT_EQ(result, results.front());
  EXPECT_NEAR(results.front()[0], double(sum), 1e-12 * std::abs(double(sum)));
  const double small = std::accumulate(numbers.begin(), numbers.end(), 0.,
                                       [](double s, auto& x) { return s + x[1]; });
  EXPECT_EQ(results.front()[1], small);
}

// A part whose cells touch at an edge, and at a vertex.
TEST(Part_of_a_complex, May_touch_itself) {
  using Part = DSC::internal::Part_of<Complex>::Type;
  const Complex whole = make_complex(grid(2, small_meshes::four_phases));
  const auto cells = whole.cells();
  const auto vertices = whole.vertices();
  const DSC::Vertex_numbers numbers(whole, vertices);
  const auto part_of = [&](const std::vector<Complex::Cell_handle>& chosen) {
    std::vector<std::array<std::size_t, 4>> indices;
    for (auto c : chosen) {
      indices.emplace_back();
      for (int i = 0; i < 4; ++i)
        indices.back()[i] = numbers(c->vertex(i));
    }
    std::vector<std::size_t> used(vertices.size(), 0), place(vertices.size(), 0);
    for (const auto& c : indices)
      for (std::size_t v : c)
        ++used[v]; // number of cells
    const auto is_cut = [&](std::size_t v) {
      std::vector<Complex::Cell_handle> star;
      whole.star(vertices[v], star);
      return used[v] < star.size();
    };
    std::size_t n = 0;
    for (std::size_t v = 0; v < used.size(); ++v)
      if (used[v] != 0)
        place[v] = n++;
    std::vector<std::size_t> old;
    for (std::size_t v = 0; v < used.size(); ++v)
      if (used[v] != 0)
        old.push_back(v);
    for (auto& c : indices)
      for (std::size_t& v : c)
        v = place[v];
    const auto originals = DSC::internal::separate_touching_cells(n, indices);
    DSC::State<3> state;
    for (std::size_t original : originals) {
      const Point p = whole.position(vertices[old[original]]);
      state.points.push_back({p.x(), p.y(), p.z()});
      state.spacings.push_back(1);
      state.boundary_classes.push_back(
          is_cut(old[original]) ? DSC::Boundary_class::fixed | DSC::Part_domain::cut : 0);
    }
    for (std::size_t c = 0; c < indices.size(); ++c) {
      state.cells.emplace_back();
      for (int i = 0; i < 4; ++i)
        state.cells.back()[i] = std::uint32_t(indices[c][i] + 1);
      state.cell_labels.push_back(chosen[c]->subdomain_index());
      state.noted_qualities.push_back(1);
      state.failures.push_back(0);
    }
    state.mean_interface_edge = 1;
    Part part;
    DSC::internal::assign_part(part, state);
    EXPECT_TRUE(part.is_valid(true));
    EXPECT_EQ(part.number_of_cells(), chosen.size());
    return originals.size() - n; // number of copies
  };
  const auto common = [&](Complex::Cell_handle a, Complex::Cell_handle b) {
    int result = 0;
    for (int i = 0; i < 4; ++i)
      result += a->has_vertex(b->vertex(i));
    return result;
  };
  std::array<bool, 4> seen = {};
  for (auto a : cells)
    for (auto b : cells) {
      const int shared = a < b ? common(a, b) : 4;
      if (shared == 4 || seen[shared])
        continue;
      seen[shared] = true;
      EXPECT_EQ(part_of({a, b}), shared == 3 ? 0u : std::size_t(shared));
    }
  EXPECT_TRUE(seen[1] && seen[2] && seen[3]);
  EXPECT_EQ(part_of(cells), 0u);
  std::mt19937 random(3);
  for (int i = 0; i < 50; ++i) {
    std::vector<Complex::Cell_handle> chosen;
    for (auto c : cells)
      if (random() % 2 == 0)
        chosen.push_back(c);
    part_of(chosen);
  }
}

} // namespace
