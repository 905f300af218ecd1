#include "betti_numbers.h"
#include "mesh_helpers.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/Deformation_options.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>
#include <CGAL/Interface_remeshing/manifold_interface.h>

// Boundaries of phases that are 2-manifolds, and deformations that preserve this property.

namespace test_manifold_interface {

using DSC::is_manifold_at;
using DSC::non_manifold_vertices;
using DSC::propose_manifold_relabeling;
using mesh_helpers::Coordinates;
using mesh_helpers::Random;
using namespace small_meshes;
using betti_numbers::Topology;
using Label_of_point = std::function<int(const Point&)>;

std::size_t number_of_pinches(const Complex& dsc) { return non_manifold_vertices(dsc).size(); }

std::vector<Coordinates> pinches(const Label_of_point& label) {
  const Complex dsc = make_complex(grid(4, label));
  std::vector<Coordinates> result;
  for (Vertex_handle v : non_manifold_vertices(dsc))
    result.push_back(mesh_helpers::coordinates(dsc, v));
  std::sort(result.begin(), result.end());
  return result;
}

// Two cubes with the given labels that touch at the origin.
Label_of_point cubes_at_a_vertex(int left, int right) {
  return [=](const Point& p) {
    const bool is_inside = small_meshes::cube(p) == 1 && p.x() * p.y() > 0 && p.x() * p.z() > 0;
    return !is_inside ? 0 : p.x() < 0 ? left : right;
  };
}

// Two cubes that touch along an edge, of label 1 in label 0, or with `inside` = 0 of label 0 in
// label 1.
Label_of_point cubes_at_an_edge(int inside) {
  return [=](const Point& p) {
    const bool is_inside = small_meshes::cube(p) == 1 && p.x() * p.y() > 0 && p.z() < 0;
    return is_inside ? inside : 1 - inside;
  };
}

// Two boxes with one layer of cubes of grid(7) between them.
int boxes_with_gap(const Point& p) {
  return (std::max)(std::abs(p.y()), std::abs(p.z())) < 3. / 7 && std::abs(p.x()) > 1. / 7 &&
         std::abs(p.x()) < 5. / 7;
}

bool is_in_gap(const Complex& dsc, Cell_handle c) {
  Vector center(0, 0, 0);
  for (int i = 0; i < 4; ++i)
    center = center + (dsc.position(c->vertex(i)) - CGAL::ORIGIN) / 4;
  return std::abs(center.x()) < 1. / 7 && std::abs(center.y()) < 3. / 7 &&
         std::abs(center.z()) < 3. / 7;
}

int quadruple_point(const Point& p) { return p.x() < 0 ? 0 : p.y() < 0 ? 1 : p.z() < 0 ? 2 : 3; }

// A plane between two labels, or two intersecting planes between four labels, with random labels on
// a part of the cells.
Label_of_point noise(int number_of_labels, double part, Random& random) {
  return [=, &random](const Point& p) {
    return random(0, 1) < part ? int(random.below(std::size_t(number_of_labels)))
                               : small_meshes::four_phases(p) % number_of_labels;
  };
}

// Returns whether the facets at v that bound a label form at most one fan around v. By the
// definition, their edges opposite to v form one cycle or there are no such edges.
bool is_surrounded_once(const Complex& dsc, Vertex_handle v, int label) {
  std::vector<Cell_handle> star;
  dsc.star(v, star);
  std::map<std::size_t, int> degrees;
  betti_numbers::Joined_sets sets;
  for (Cell_handle c : star)
    for (int k = 0; k < 4; ++k) {
      const Cell_handle n = c->neighbor(k);
      if (c->vertex(k) == v || dsc.is_infinite(c) || c->subdomain_index() != label ||
          (!dsc.is_infinite(n) && n->subdomain_index() == label))
        continue;
      std::vector<std::size_t> ends;
      for (int i = 0; i < 4; ++i)
        if (i != k && c->vertex(i) != v)
          ends.push_back(c->vertex(i)->time_stamp());
      ++degrees[ends[0]];
      ++degrees[ends[1]];
      sets.join(ends[0], ends[1]);
    }
  return std::all_of(degrees.begin(), degrees.end(), [&](const auto& degree) {
    return degree.second == 2 && sets.find(degree.first) == sets.find(degrees.begin()->first);
  });
}

TEST(Manifold_at, is_not_where_parts_of_a_phase_touch) {
  const std::vector<Coordinates> origin = {{0, 0, 0}}, edge = {{0, 0, -.5}, {0, 0, 0}};
  EXPECT_EQ(pinches(cubes_at_a_vertex(1, 1)), origin);
  EXPECT_EQ(pinches(cubes_at_a_vertex(1, 2)), origin); // the surrounding phase is pinched
  EXPECT_EQ(pinches(cubes_at_an_edge(1)), edge);
  EXPECT_EQ(pinches(cubes_at_an_edge(0)), edge);
}

TEST(Manifold_at, is_where_labels_meet_in_lines_and_points) {
  const std::vector<Coordinates> nowhere;
  for (const Label_of_point& label : std::vector<Label_of_point>{
           small_meshes::uniform, small_meshes::cube, small_meshes::ball, small_meshes::two_boxes,
           small_meshes::four_phases, quadruple_point})
    EXPECT_EQ(pinches(label), nowhere);
}

TEST(Manifold_at, agrees_with_the_definition_on_random_labels) {
  Random random(1);
  std::size_t manifold = 0, pinched = 0;
  for (int number_of_labels : {2, 3, 4})
    for (double part : {.02, .1, .5}) {
      const Complex dsc = make_complex(grid(4, noise(number_of_labels, part, random)));
      for (Vertex_handle v : dsc.vertices()) {
        bool expected = true;
        for (int label : dsc.labels())
          expected = expected && is_surrounded_once(dsc, v, label);
        ASSERT_EQ(is_manifold_at(dsc, v), expected);
        ++(expected ? manifold : pinched);
      }
    }
  EXPECT_GT(manifold, 0u);
  EXPECT_GT(pinched, 0u);
}

TEST(Manifold_relabeling, opens_a_tunnel_between_parts) {
  Complex dsc = make_complex(grid(7, boxes_with_gap));
  ASSERT_EQ(number_of_pinches(dsc), 0u);
  std::vector<Cell_handle> cells;
  std::size_t proposals = 0;
  for (Cell_handle c : dsc.cells()) {
    if (!is_in_gap(dsc, c))
      continue;
    dsc.relabel(c, 1);
    EXPECT_GT(number_of_pinches(dsc), 0u); // the single relabeling creates a pinch
    dsc.relabel(c, 0);
    ASSERT_TRUE(propose_manifold_relabeling(dsc, c, 1, cells));
    ++proposals;
    EXPECT_EQ(cells.front(), c);
    EXPECT_FALSE(DSC::relabeling_keeps_topology(dsc, cells, 1));
    for (Cell_handle d : cells) {
      EXPECT_EQ(d->subdomain_index(), 0);
      dsc.relabel(d, 1);
    }
    EXPECT_EQ(number_of_pinches(dsc), 0u);
    EXPECT_EQ(dsc.number_of_components(1), 1u);
    for (Cell_handle d : cells)
      dsc.relabel(d, 0);
  }
  EXPECT_EQ(proposals, 54u); // in the cubes of the gap
}

// A cell that closes a crease of the ball preserves all Betti numbers.
TEST(Manifold_relabeling, can_be_refused_where_the_topology_is_kept) {
  Complex dsc = make_complex(grid(6, small_meshes::ball));
  std::size_t kept = 0, pinched = 0;
  for (Cell_handle c : dsc.cells()) {
    const int label = c->subdomain_index();
    if (!DSC::relabeling_keeps_topology(dsc, c, 1 - label))
      continue;
    dsc.relabel(c, 1 - label);
    const bool is_manifold = number_of_pinches(dsc) == 0;
    ++(is_manifold ? kept : pinched);
    dsc.relabel(c, label);
    std::vector<Cell_handle> cells;
    EXPECT_EQ(propose_manifold_relabeling(dsc, c, 1 - label, cells) && cells.size() == 1,
              is_manifold);
  }
  EXPECT_GT(kept, 0u);
  EXPECT_GT(pinched, 0u);
}

TEST(Manifold_relabeling, keeps_its_promise_on_random_labels) {
  Random random(2);
  std::size_t proposed = 0, refused = 0, kept = 0;
  for (int number_of_labels : {2, 3, 4})
    for (double part : {0., .03, .15}) {
      Complex dsc = make_complex(grid(4, noise(number_of_labels, part, random)));
      std::vector<Cell_handle> cells;
      for (Cell_handle c : dsc.cells()) {
        const int label = int(random.below(std::size_t(number_of_labels))),
                  before = c->subdomain_index();
        if (label == before || c->time_stamp() % 4 != 0)
          continue;
        const auto state = dsc.state();
        const bool is_proposed = propose_manifold_relabeling(dsc, c, label, cells);
        ASSERT_TRUE(dsc.state() == state);
        ++(is_proposed ? proposed : refused);
        if (!is_proposed)
          continue;
        const auto pinches_before = non_manifold_vertices(dsc);
        const bool keeps = DSC::relabeling_keeps_topology(dsc, cells, label);
        const auto topology = keeps ? betti_numbers::of_complex(dsc) : Topology();
        for (Cell_handle d : cells) {
          ASSERT_EQ(d->subdomain_index(), before);
          dsc.relabel(d, label);
        }
        for (Cell_handle d : cells)
          for (int i = 0; i < 4; ++i)
            ASSERT_TRUE(is_manifold_at(dsc, d->vertex(i)));
        for (Vertex_handle v : non_manifold_vertices(dsc))
          ASSERT_EQ(std::count(pinches_before.begin(), pinches_before.end(), v), 1);
        if (keeps) {
          ASSERT_EQ(betti_numbers::of_complex(dsc), topology);
        }
        kept += keeps;
      }
    }
  EXPECT_GT(proposed, 0u);
  EXPECT_GT(refused, 0u);
  EXPECT_GT(kept, 0u);
}

// Commits the proposals for each edge of each cell. Returns their number.
template <class Propose> std::size_t expect_no_new_pinch(Complex& dsc, const Propose& propose) {
  std::vector<std::pair<Cell_handle, std::size_t>> cells;
  for (Cell_handle c : dsc.cells())
    cells.emplace_back(c, c->time_stamp());
  std::size_t committed = 0;
  Complex::Cavity cavity(dsc);
  for (const auto& cell : cells)
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        if (i != j && dsc.is_alive(cell.first, cell.second) && propose(cell.first, i, j, cavity)) {
          const std::size_t before = number_of_pinches(dsc);
          dsc.replace(cavity);
          EXPECT_LE(number_of_pinches(dsc), before);
          ++committed;
        }
  return committed;
}

TEST(Manifold_interface, survives_collapses_and_flips) {
  std::size_t collapses = 0, flips = 0;
  for (unsigned seed = 1; seed < 9; ++seed) {
    Random random(seed);
    const std::vector<Label_of_point> labels = {small_meshes::ball, small_meshes::four_phases,
                                                noise(2, .1, random), noise(4, .3, random)};
    for (const Label_of_point& label : labels) {
      Complex dsc = mesh_helpers::jittered_grid(4, label, .4, seed);
      flips += expect_no_new_pinch(dsc, [&](Cell_handle c, int i, int j, Complex::Cavity& cavity) {
        return propose_interface_edge_flip(dsc, c, i, j, cavity);
      });
      collapses +=
          expect_no_new_pinch(dsc, [&](Cell_handle c, int i, int j, Complex::Cavity& cavity) {
            return propose_edge_collapse(dsc, c, i, j, 0, cavity);
          });
    }
  }
  EXPECT_GT(collapses, 0u);
  EXPECT_GT(flips, 0u);
}

// Examines the complex before each pass.
struct Pinch_counter : public DSC::Deformation_visitor<Complex>
{
  explicit Pinch_counter(const Complex& complex) : dsc(complex) {}

  bool go_further(unsigned /*pass*/) override {
    pinches += number_of_pinches(dsc);
    return true;
  }

  const Complex& dsc;
  std::size_t pinches = 0;
};

// Deforms the complex with a random field, rough or smooth. Returns the number of pinches before
// each pass and at the end.
template <class NamedParameters>
std::size_t deform_at_random(Complex& dsc, unsigned field, const NamedParameters& np) {
  Random random(field);
  const double length = random(.1, 3) * dsc.mean_interface_edge();
  const auto wave = random.vector<Complex>(6), amplitude = random.vector<Complex>(length);
  const auto destination = [&](Vertex_handle v) {
    const Position p = dsc.position(v);
    const Vector way = field % 2 == 0 ? random.vector<Complex>(length)
                                      : std::sin(wave * (p - CGAL::ORIGIN)) * amplitude;
    return p + way;
  };
  Pinch_counter counter(dsc);
  DSC::deform_interface(dsc, destination,
                        np.visitor(std::ref(counter)).maximum_number_of_passes(6));
  EXPECT_TRUE(dsc.is_valid());
  return counter.pinches + number_of_pinches(dsc);
}

// Deforms a grid with a sequence of random fields. Returns the number of pinches.
std::size_t pinches_in_run(std::size_t n, const Label_of_point& label, bool manifold_interface) {
  Complex dsc = make_complex(grid(n, label));
  EXPECT_EQ(number_of_pinches(dsc), 0u);
  std::size_t sum = 0;
  for (unsigned field = 1; field <= 16 && !dsc.interface_vertices().empty(); ++field)
    sum += deform_at_random(dsc, field, parameters::manifold_interface(manifold_interface));
  return sum;
}

void expect_pinches_only_without(std::size_t n, const Label_of_point& label) {
  const std::size_t without = pinches_in_run(n, label, false);
  ::testing::Test::RecordProperty("pinches_without", int(without));
  EXPECT_GT(without, 0u);
  EXPECT_EQ(pinches_in_run(n, label, true), 0u);
}

TEST(Manifold_interface, of_a_ball_is_kept_under_random_fields) {
  expect_pinches_only_without(6, small_meshes::ball);
}

TEST(Manifold_interface, of_four_labels_is_kept_under_random_fields) {
  expect_pinches_only_without(6, small_meshes::four_phases);
}

TEST(Manifold_interface, of_a_pinched_input_gets_no_worse) {
  Random random(5);
  for (const Label_of_point& label : std::vector<Label_of_point>{
           cubes_at_a_vertex(1, 1), cubes_at_an_edge(1), noise(4, .2, random)}) {
    Complex dsc = make_complex(grid(4, label));
    std::size_t before = number_of_pinches(dsc);
    ASSERT_GT(before, 0u);
    for (unsigned field = 1; field <= 8 && !dsc.interface_vertices().empty(); ++field) {
      deform_at_random(dsc, field, parameters::manifold_interface(true));
      const std::size_t after = number_of_pinches(dsc);
      ASSERT_LE(after, before);
      before = after;
    }
  }
}

// The contact is resolved, not only prevented.
TEST(Manifold_interface, lets_cubes_merge) {
  const auto two_cubes = [](const Point& p) {
    return int(std::abs(p.y()) < .5 && std::abs(p.z()) < .5 &&
               std::abs(std::abs(p.x()) - .5) < .25);
  };
  const auto merge = [](Complex& dsc, const auto& np) {
    std::size_t merges = 0;
    for (int i = 0; i < 4; ++i) {
      const auto to_the_middle = [&](Vertex_handle v) {
        const Position p = dsc.position(v);
        return p + Vector(p.x() > 0 ? -.08 : .08, 0, 0);
      };
      const auto report = DSC::deform_interface(dsc, to_the_middle, np);
      EXPECT_EQ(number_of_pinches(dsc), 0u);
      for (const auto& event : report.events)
        if (event.label == 1 && event.kind == DSC::Component_event::Kind::merged) {
          ++merges;
          EXPECT_LT(std::abs(event.where.x()), .1);
        }
    }
    return merges;
  };
  Complex dsc = make_complex(grid(8, two_cubes));
  EXPECT_EQ(merge(dsc, parameters::manifold_interface(true)), 1u);
  EXPECT_EQ(dsc.number_of_components(1), 1u);
  EXPECT_EQ(dsc.euler_characteristic(1) % 2, 0); // as of any closed surface

  const CGAL::Deformable_simplicial_complexes::Forbid_topology_changes forbid;
  dsc = make_complex(grid(8, two_cubes));
  EXPECT_EQ(merge(dsc, parameters::manifold_interface(true).topology_control(forbid)), 0u);
  EXPECT_EQ(dsc.number_of_components(1), 2u);
}

} // namespace test_manifold_interface
