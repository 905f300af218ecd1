#include "operation_helpers.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/internal/topology/Manifold_relabeling.h>
#include <CGAL/Deformable_simplicial_complexes/internal/topology/Trapped_cells.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/cell_corners.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>
#include <CGAL/Interface_remeshing/Carried_cell_averages.h>
#include <CGAL/Interface_remeshing/Curvature_sizing_field.h>
#include <CGAL/Interface_remeshing/Volume_changer.h>

// Algorithms that must stay fast for vertices of high degree and for many labels, compared bitwise
// with slow reference implementations.

namespace test_bounded_costs {

namespace internal = CGAL::Deformable_simplicial_complexes::internal;
using mesh_helpers::jittered_grid;
using namespace operation_helpers;
using small_meshes::grid;
using small_meshes::make_complex;
using Position = Complex::Point_3;
using Vector = Complex::Vector_3;

// A regular ring of n tetrahedra around an edge, next to one vertex of the edge. Without the edge,
// the ring has no tetrahedron as thin as the tetrahedra at the edge.
Labeled_mesh thin_ring(std::size_t n) {
  Labeled_mesh mesh = {{Point(.999, 0, -1), Point(.999, 0, 1)}, {}, {}};
  for (std::size_t k = 0; k < n; ++k) {
    const double angle = 2 * CGAL_PI * double(k) / double(n);
    mesh.points.emplace_back(std::cos(angle), std::sin(angle), 0);
    mesh.tetrahedra.push_back({0, 1, 2 + k, 2 + (k + 1) % n});
    mesh.labels.push_back(0);
  }
  return mesh;
}

// Random labels, some of them negative. Cells are small near the middle.
Complex motley_complex(std::size_t n, std::size_t number_of_labels, unsigned seed) {
  Random random(seed);
  Labeled_mesh mesh =
      grid(n, [&](const Point&) { return int(random.below(number_of_labels)) - 2; });
  const auto cube = [](double x) { return x * x * x; };
  for (Point& p : mesh.points)
    p = Point(cube(p.x()), cube(p.y()), cube(p.z()));
  return make_complex(mesh);
}

std::map<int, std::size_t> numbers_of_components(const Complex& dsc) {
  std::map<int, std::size_t> result;
  std::set<Cell_handle> seen;
  for (Cell_handle seed : dsc.cells()) {
    if (!seen.insert(seed).second)
      continue;
    ++result[seed->subdomain_index()];
    std::vector<Cell_handle> front = {seed};
    while (!front.empty()) {
      const Cell_handle c = front.back();
      front.pop_back();
      for (int i = 0; i < 4; ++i) {
        const Cell_handle n = c->neighbor(i);
        if (!dsc.is_infinite(n) && n->subdomain_index() == c->subdomain_index() &&
            seen.insert(n).second)
          front.push_back(n);
      }
    }
  }
  return result;
}

using Filled = internal::Filled_simplex<Complex::Space, double>;

std::vector<Filled> filled_cells(const Complex& dsc, Random& random) {
  std::vector<Filled> result;
  for (Cell_handle c : dsc.cells())
    result.push_back({internal::Clipping_simplex<Complex::Space>(internal::cell_corners(dsc, c)),
                      c->subdomain_index(), random(-1, 1)});
  return result;
}

// Reference implementation of internal::pour() for all pairs of a source and a target.
void pour_slowly(const std::vector<const Filled*>& sources, const std::vector<Filled*>& targets) {
  std::vector<double> gaps, overlaps(targets.size());
  double volume = 0, excess = 0, left = 0, gap = 0;
  for (const Filled* t : targets) {
    gaps.push_back(t->measure());
    volume += gaps.back();
  }
  for (const Filled* s : sources) {
    double sum = 0;
    for (std::size_t j = 0; j < targets.size(); ++j)
      sum += overlaps[j] = overlap_measure(s->simplex, targets[j]->simplex);
    const double whole = (std::max)(sum, s->measure());
    for (std::size_t j = 0; j < targets.size(); ++j) {
      targets[j]->content += overlaps[j] / whole * s->content;
      gaps[j] -= overlaps[j];
    }
    left += (whole - sum) / whole * s->content;
    excess += whole - sum;
  }
  if (!(excess > 0))
    return;
  for (double& g : gaps)
    gap += g = (std::max)(0., g);
  const double fill = 1 / (std::max)(gap, excess), spread = (1 - fill * gap) / volume;
  for (std::size_t j = 0; j < targets.size(); ++j)
    targets[j]->content += (fill * gaps[j] + spread * targets[j]->measure()) * left;
}

TEST(Edge_removal, refuses_rings_of_more_than_52_cells) {
  for (std::size_t n : {51, 52, 53, 400}) {
    Complex dsc;
    Labeled_mesh mesh = thin_ring(n);
    auto v = dsc.assign(mesh.points, mesh.tetrahedra, mesh.labels);
    Edge_in_cell e = find_edge(dsc, v[0], v[1]);
    Cavity cavity(dsc);
    EXPECT_EQ(propose_edge_removal(dsc, e.cell, e.i, e.j, cavity), n <= 52) << n;

    std::fill_n(mesh.labels.begin(), n / 2, 1);
    v = dsc.assign(mesh.points, mesh.tetrahedra, mesh.labels);
    e = find_edge(dsc, v[0], v[1]);
    Cavity flip(dsc);
    EXPECT_EQ(propose_interface_edge_flip(dsc, e.cell, e.i, e.j, flip), n <= 52) << n;
  }
}

TEST(Edge_collapse, is_proposed_up_to_the_quality_that_it_leaves) {
  const Complex dsc = jittered_grid(3, small_meshes::four_phases, .35, 5);
  Cavity cavity(dsc);
  int proposed = 0;
  for_each_edge(dsc, [&](const Edge_in_cell& e) {
    if (!propose_edge_collapse(dsc, e.cell, e.i, e.j, 0, cavity))
      return;
    ++proposed;
    const double quality = cavity.quality_after();
    EXPECT_TRUE(propose_edge_collapse(dsc, e.cell, e.i, e.j, quality, cavity));
    EXPECT_EQ(cavity.quality_after(), quality);
    EXPECT_FALSE(propose_edge_collapse(dsc, e.cell, e.i, e.j, std::nextafter(quality, 1.), cavity));
  });
  EXPECT_GT(proposed, 50);
}

TEST(Curvature_sizing_field, is_what_relaxation_over_all_edges_ends_with) {
  const Complex dsc = jittered_grid(8, small_meshes::ball, .3, 1);
  const DSC::Interface_snapshot<Complex> interface_(dsc);
  const auto positions = interface_.positions(dsc);
  static constexpr double tolerance = .002, shortest = .01, longest = 1, gradation = .05;
  const DSC::Curvature_sizing_field<3> not_graded(dsc, tolerance, shortest, longest, 1e100),
      graded(dsc, tolerance, shortest, longest, gradation);
  std::vector<double> lengths;
  for (const Position& p : positions)
    lengths.push_back(not_graded(p));
  std::size_t changes = 0;
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (const auto& triangle : interface_.facets())
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          const std::size_t a = triangle.vertices[i], b = triangle.vertices[j];
          const double bound =
              lengths[a] + gradation * std::sqrt((positions[b] - positions[a]).squared_length());
          if (lengths[b] > bound) {
            lengths[b] = bound;
            has_changed = true;
            ++changes;
          }
        }
  }
  EXPECT_GT(changes, 50u);
  for (std::size_t v = 0; v < positions.size(); ++v)
    EXPECT_EQ(graded(positions[v]), lengths[v]);
}

// The infinite vertex has the largest degree.
TEST(Labeled_star, knows_the_neighbors_of_cells) {
  const Complex dsc = jittered_grid(3, small_meshes::four_phases, .3, 3);
  auto vertices = dsc.vertices();
  vertices.push_back(dsc.triangulation().infinite_vertex());
  for (Vertex_handle v : vertices) {
    const internal::Labeled_star<Complex> star(dsc, v,
                                               [](Cell_handle c) { return c->subdomain_index(); });
    for (std::size_t i = 0; i < star.size(); ++i) {
      auto next = star.neighbors(i).begin();
      for (int k = 0; k < 4; ++k)
        if (star.cell(i)->vertex(k) != v) {
          EXPECT_TRUE(star.cell(*next++) == star.cell(i)->neighbor(k));
        }
    }
  }
}

TEST(Components, are_counted_for_each_label) {
  Complex dsc = motley_complex(4, 20, 1);
  const auto expect_right_numbers = [&] {
    const auto expected = numbers_of_components(dsc);
    for (int label = -5; label < 25; ++label) {
      const auto found = expected.find(label);
      EXPECT_EQ(dsc.number_of_components(label), found == expected.end() ? 0 : found->second);
    }
  };
  expect_right_numbers();
  Random random(2);
  for (Cell_handle c : dsc.cells())
    if (random.below(2) == 0)
      dsc.relabel(c, 3);
  expect_right_numbers();
}

// Relabelings update the numbers and volumes of components one by one; is_valid() compares them
// with a flood fill.
TEST(Components, are_known_after_relabelings_that_keep_them) {
  Complex dsc = jittered_grid(4, small_meshes::two_boxes, .3, 1);
  Random random(3);
  std::size_t known = 0, changed = 0;
  for (int i = 0; i < 600; ++i) {
    dsc.update_components();
    const auto before = numbers_of_components(dsc);
    const auto cells = dsc.cells();
    const Cell_handle c = cells[random.below(cells.size())];
    const Cell_handle n = c->neighbor(int(random.below(4)));
    if (dsc.is_infinite(n) || n->subdomain_index() == c->subdomain_index())
      continue;
    dsc.relabel(c, n->subdomain_index());
    EXPECT_TRUE(dsc.is_valid(true));
    const auto events = dsc.take_component_events();
    EXPECT_TRUE(dsc.is_valid(true));
    ++(events.empty() ? known : changed);
    if (events.empty()) {
      EXPECT_EQ(numbers_of_components(dsc), before);
    }
    for (const auto& event : events)
      for (const auto& part : event.after) {
        double volume = 0;
        for (Cell_handle d : dsc.cells())
          if (d->component() == part.component)
            volume += dsc.measure(d);
        EXPECT_NEAR(part.volume, volume, 1e-14);
      }
  }
  EXPECT_GT(known, 50u);
  EXPECT_GT(changed, 5u);
}

// Components that relabelings separate may vanish or merge again before the next query.
TEST(Components, are_known_after_many_relabelings) {
  Complex dsc = jittered_grid(4, small_meshes::two_boxes, .3, 2);
  Random random(4);
  std::size_t known = 0, changed = 0;
  for (int i = 0; i < 400; ++i) {
    auto expected = numbers_of_components(dsc);
    dsc.take_component_events();
    const auto cells = dsc.cells();
    Cell_handle c = cells[random.below(cells.size())];
    for (std::size_t k = random.below(30); k > 0; --k) { // a walk
      const Cell_handle n = c->neighbor(int(random.below(4)));
      if (dsc.is_infinite(n))
        continue;
      if (n->subdomain_index() != c->subdomain_index())
        dsc.relabel(c, n->subdomain_index());
      if (i % 3 == 0) {
        EXPECT_EQ(dsc.number_of_components(1), numbers_of_components(dsc)[1]);
      }
      c = n;
    }
    EXPECT_TRUE(dsc.is_valid());
    const auto events = dsc.take_component_events();
    EXPECT_TRUE(dsc.is_valid());
    ++(events.empty() ? known : changed);
    using Kind = DSC::Component_event::Kind;
    for (const auto& event : events) // a simultaneous merge and split is reported twice
      expected[event.label] += (event.kind == Kind::merged ? 1 : event.after.size()) -
                               (event.kind == Kind::split ? 1 : event.before.size());
    for (const auto& [label, number] : expected)
      EXPECT_EQ(dsc.number_of_components(label), number);
    for (const auto& [label, number] : numbers_of_components(dsc))
      EXPECT_EQ(dsc.number_of_components(label), number);
  }
  EXPECT_GT(known, 50u);
  EXPECT_GT(changed, 50u);
}

TEST(Redistribute_contents, adds_what_all_pairs_would) {
  Random random(1);
  const auto from = filled_cells(jittered_grid(3, small_meshes::uniform, .3, 1), random);
  auto to = filled_cells(jittered_grid(4, small_meshes::uniform, .3, 2), random);
  auto slow = to;
  std::vector<const Filled*> sources;
  std::vector<Filled*> targets, slow_targets;
  for (std::size_t i = 0; i < from.size(); i += 2)
    sources.push_back(&from[i]);
  for (std::size_t i = 0; i < to.size() / 2; ++i) { // so that some content remains
    targets.push_back(&to[i]);
    slow_targets.push_back(&slow[i]);
  }
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < sources.size(); ++i)
    for (std::size_t j = 0; j < targets.size(); ++j)
      if (CGAL::do_overlap(sources[i]->simplex.bbox(), targets[j]->simplex.bbox()))
        pairs.emplace_back(i, j);
  EXPECT_TRUE(internal::pairs_that_may_overlap<Complex::Space>(sources, targets) == pairs);
  EXPECT_LT(2 * pairs.size(), sources.size() * targets.size());
  internal::pour(sources, targets);
  pour_slowly(sources, slow_targets);
  for (std::size_t j = 0; j < to.size(); ++j)
    EXPECT_EQ(to[j].content, slow[j].content);
}

TEST(Volume_changer, does_not_need_directions_that_are_zero) {
  const Complex dsc = make_complex(grid(10, [](const Point& p) {
    return small_meshes::two_balls(p) == 0 ? 0 : p.x() < 0 ? 1 : 2;
  }));
  const DSC::Interface_snapshot<Complex> interface_(dsc);
  const auto start = interface_.positions(dsc);
  const DSC::Volume_changer<Complex> changer(interface_);
  const std::map<int, double> amounts = {{1, .01}, {2, -.01}};
  const auto sparse = changer.gradients(amounts, start);
  auto dense = sparse;
  for (auto& directions : dense) {
    EXPECT_EQ(directions.size(), 1u);
    for (Eigen::Index i = 0; i < 2; ++i)
      directions.try_emplace(i, 0, 0, 0);
  }
  auto positions = start, expected = start;
  changer.change_by(amounts, sparse, positions);
  changer.change_by(amounts, dense, expected);
  EXPECT_TRUE(positions == expected);
  EXPECT_NEAR(changer.changes(start, positions)[1], .01, 1e-14);
}

// One cell after the other, without reuse of results. All vertices move to one point, so that all
// components vanish.
TEST(Trapped_cells, small_components_are_found_from_all_of_their_cells) {
  for (bool manifold : {false, true})
    for (std::size_t number_of_labels : {2, 5}) {
      Complex at_once = motley_complex(6, number_of_labels, 3);
      Complex one_by_one = at_once;
      DSC::Deformation_visitor<Complex> visitor;
      DSC::Deformation_options<Complex> options;
      options.manifold_interface = manifold;
      internal::Destinations<Complex> at_once_to(at_once), one_by_one_to(one_by_one);
      for (Vertex_handle v : at_once.interface_vertices())
        at_once_to.add(v, Point(0, 0, 0));
      for (Vertex_handle v : one_by_one.interface_vertices())
        one_by_one_to.add(v, Point(0, 0, 0));
      const internal::Contacts<Complex> at_once_contacts(at_once, at_once_to),
          one_by_one_contacts(one_by_one, one_by_one_to);
      const internal::Rigid_components<Complex> at_once_rigid(at_once, at_once_to),
          one_by_one_rigid(one_by_one, one_by_one_to);
      internal::Trapped_cells<Complex> fast(at_once, visitor, at_once_to, at_once_contacts,
                                            at_once_rigid, options),
          slow(one_by_one, visitor, one_by_one_to, one_by_one_contacts, one_by_one_rigid, options);
      fast.remove_vanishing_components(at_once.cells());
      for (Cell_handle c : one_by_one.cells())
        slow.remove_vanishing_components({c});
      EXPECT_EQ(fast.number_of_relabeled(), slow.number_of_relabeled());
      EXPECT_TRUE(at_once.state() == one_by_one.state());
      if (!manifold) {
        EXPECT_GT(fast.number_of_relabeled(), 100u);
      }
    }
}

} // namespace test_bounded_costs
