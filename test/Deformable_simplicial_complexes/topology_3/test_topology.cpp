#include "betti_numbers.h"
#include "mesh_helpers.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/Deformation_options.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>

// Changes of the topology of labels and of their interface in deformations.

namespace test_topology {

using CGAL::Deformable_simplicial_complexes::Allow_topology_changes_between;
using CGAL::Deformable_simplicial_complexes::Forbid_topology_changes;
using DSC::relabeling_keeps_topology;
using mesh_helpers::Random;
using namespace small_meshes;
using betti_numbers::Betti_numbers;

const Betti_numbers ball = {1, 0, 0}, sphere = {1, 0, 1};

bool has_label_1(Cell_handle c) { return c->subdomain_index() == 1; }

template <class NamedParameters>
DSC::Deformation_report<Complex> deform(Complex& dsc,
                                        const std::function<Vector(Position)>& displacement,
                                        const NamedParameters& np) {
  const auto destination = [&](Vertex_handle v) {
    return dsc.position(v) + displacement(dsc.position(v));
  };
  const auto report = DSC::deform_interface(dsc, destination, np);
  EXPECT_TRUE(dsc.is_valid());
  return report;
}

// Two cubes with the given labels, at a distance of one fifth of their side length.
auto two_cubes(int left, int right) {
  return [=](const Point& p) {
    const bool is_inside =
        std::abs(p.y()) < .5 && std::abs(p.z()) < .5 && std::abs(std::abs(p.x()) - .5) < .25;
    return !is_inside ? 0 : p.x() < 0 ? left : right;
  };
}

// Moves everything towards x = 0.
Vector to_the_middle(const Position& p) { return Vector(p.x() > 0 ? -.08 : .08, 0, 0); }

TEST(Betti_numbers, of_known_shapes) {
  const Complex solid = make_complex(grid(4, small_meshes::cube));
  EXPECT_EQ(betti_numbers::of_cells(solid, has_label_1), ball);
  EXPECT_EQ(betti_numbers::of_cells(solid, [](Cell_handle c) { return c->subdomain_index() == 0; }),
            sphere);
  EXPECT_EQ(betti_numbers::of_interface(solid), sphere);
  const auto is_frame = [](const Point& p) {
    return int(std::abs(p.z()) < .5 && (std::abs(p.x()) > .5) + (std::abs(p.y()) > .5) == 1);
  };
  const Complex posts = make_complex(grid(4, is_frame));
  EXPECT_EQ(betti_numbers::of_cells(posts, has_label_1).components, 1); // along edges
  const auto is_ring = [](const Point& p) {
    const bool is_hole = std::abs(p.x()) < .25 && std::abs(p.y()) < .25;
    return int(std::abs(p.z()) < .5 && std::abs(p.x()) < .75 && std::abs(p.y()) < .75 && !is_hole);
  };
  const Complex ring = make_complex(grid(8, is_ring));
  EXPECT_EQ(betti_numbers::of_cells(ring, has_label_1), (Betti_numbers{1, 1, 0}));
  EXPECT_EQ(betti_numbers::of_interface(ring), (Betti_numbers{1, 2, 1}));
  const Complex quadrants = make_complex(grid(4, small_meshes::four_phases));
  EXPECT_EQ(betti_numbers::of_interface(quadrants), ball); // four half planes
}

TEST(Relabeling_topology, cells_at_the_side_of_a_solid_keep_it) {
  const Complex dsc = make_complex(grid(8, small_meshes::cube));
  std::size_t kept = 0;
  for (Cell_handle c : dsc.cells()) {
    std::size_t facets = 0, vertices = 0;
    for (int i = 0; i < 4; ++i) {
      facets += dsc.is_interface(std::make_pair(c, i));
      vertices += c->vertex(i)->is_interface();
    }
    const bool keeps = relabeling_keeps_topology(dsc, c, 1 - c->subdomain_index());
    if (facets == 1 && vertices == 3) {
      EXPECT_TRUE(keeps);
      ++kept;
    }
    if (facets == 0) { // a new component, or one that is connected only by a vertex or an edge
      EXPECT_FALSE(keeps);
    }
    EXPECT_FALSE(relabeling_keeps_topology(dsc, c, 2)); // a new label appears
  }
  EXPECT_GT(kept, 0u);
}

// If the criterion holds, Betti numbers counted from scratch do not change.
TEST(Relabeling_topology, agrees_with_betti_numbers_on_random_labels) {
  Random random(1);
  std::size_t kept = 0;
  for (int number_of_labels : {2, 3, 5})
    for (double spread : {0., .3, 1.}) {
      const auto random_label = [&](const Point& p) {
        const bool is_random = random(0, 1) < spread;
        return is_random ? int(random.below(std::size_t(number_of_labels)))
                         : (p.x() < 0) + (number_of_labels > 2 && p.y() < 0);
      };
      Complex dsc = make_complex(grid(3, random_label));
      auto before = betti_numbers::of_complex(dsc);
      const auto cells = dsc.cells();
      for (int i = 0; i < 100; ++i) {
        const Cell_handle c = cells[random.below(cells.size())];
        const int label = int(random.below(std::size_t(number_of_labels)));
        if (label == c->subdomain_index() || !relabeling_keeps_topology(dsc, c, label))
          continue;
        dsc.relabel(c, label);
        ++kept;
        const auto after = betti_numbers::of_complex(dsc);
        ASSERT_EQ(before, after);
      }
    }
  EXPECT_GT(kept, 30u);
}

// A reported change is a real change. This is testable only away from the box and around a ball,
// where a single change is possible.
TEST(Relabeling_topology, names_no_change_where_there_is_none) {
  Complex dsc = make_complex(grid(6, small_meshes::ball));
  std::size_t changes = 0;
  for (Cell_handle c : dsc.cells()) {
    bool is_far = true;
    for (int i = 0; i < 4; ++i)
      is_far = is_far && !dsc.is_boundary(c->vertex(i));
    if (c->subdomain_index() != 0 || !is_far || c->time_stamp() % 8 != 0)
      continue;
    const auto before = betti_numbers::of_complex(dsc);
    const bool keeps = relabeling_keeps_topology(dsc, c, 1);
    dsc.relabel(c, 1);
    EXPECT_EQ(keeps, betti_numbers::of_complex(dsc) == before);
    changes += !keeps;
    dsc.relabel(c, 0);
  }
  EXPECT_GT(changes, 0u);
}

// Two boxes with equal triangulations of the facing sides. Vertices project to vertices, so
// rounding decides which facet of a cell of the gap is the largest.
TEST(Gaps, between_equal_triangulations_close_at_once_whatever_their_width) {
  for (double width : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10, 1e-12}) {
    const double layer = 2. / 7;
    auto mesh = grid(7, [&](const Point& p) {
      const bool is_inside = std::abs(p.y()) < 2.5 * layer && std::abs(p.z()) < 2.5 * layer;
      return is_inside && std::abs(p.x()) > .5 * layer && std::abs(p.x()) < 2.5 * layer ? 1 : 0;
    });
    for (Point& p : mesh.points)
      if (p.x() > 0)
        p = Point(p.x() - layer + width, p.y(), p.z());
    Complex dsc = make_complex(mesh);
    ASSERT_EQ(dsc.number_of_components(1), 2u);
    const auto report = deform(
        dsc,
        [&](const Position& p) {
          const double middle = width / 2 - layer / 2;
          return Vector(std::abs(p.x() - middle) > width ? 0 : p.x() > middle ? -.05 : .05, 0, 0);
        },
        parameters::default_values());
    EXPECT_TRUE(report.unfinished.empty()) << width;
    for (const auto& change : report.labels)
      EXPECT_NEAR(change.volume_unexplained(), 0, .005 * change.volume_before) << width;
    EXPECT_EQ(dsc.number_of_components(1), 1u) << width;
    EXPECT_EQ(dsc.euler_characteristic(1), 2) << width;
  }
}

TEST(Topology_control, forbidden_cubes_do_not_merge) {
  Complex dsc = make_complex(grid(8, two_cubes(1, 1)));
  const auto before = betti_numbers::of_complex(dsc);
  DSC::Deformation_report<Complex> report;
  for (int i = 0; i < 4; ++i)
    report = deform(dsc, to_the_middle, parameters::topology_control(Forbid_topology_changes()));
  EXPECT_EQ(betti_numbers::of_complex(dsc), before);
  EXPECT_FALSE(report.complete);
  EXPECT_EQ(dsc.number_of_components(1), 2u);
  for (const auto& unfinished : report.unfinished) // only vertices of the sides that meet
    EXPECT_LT(std::abs(dsc.position(unfinished.vertex).x()), .1);
}

TEST(Topology_control, is_per_pair_of_labels) {
  for (const bool is_allowed : {false, true}) {
    Complex dsc = make_complex(grid(8, two_cubes(1, 1)));
    const Allow_topology_changes_between control(
        {is_allowed ? std::pair<int, int>(1, 0) : std::pair<int, int>(1, 2)});
    for (int i = 0; i < 4; ++i)
      deform(dsc, to_the_middle, parameters::topology_control(control));
    EXPECT_EQ(dsc.number_of_components(1), is_allowed ? 1u : 2u);
  }
}

TEST(Topology_control, asks_a_predicate_of_the_user) {
  Complex dsc = make_complex(grid(8, two_cubes(1, 1)));
  std::size_t asked = 0;
  const auto control = [&](const Complex& complex, Cell_handle c, int label) {
    EXPECT_FALSE(relabeling_keeps_topology(complex, c, label));
    ++asked;
    return false;
  };
  for (int i = 0; i < 4; ++i)
    deform(dsc, to_the_middle, parameters::topology_control(control));
  EXPECT_GT(asked, 0u);
  EXPECT_EQ(dsc.number_of_components(1), 2u);
}

// No displacement causes a forbidden change.
TEST(Topology_control, forbidden_changes_do_not_happen_under_random_abuse) {
  Random random(3);
  const auto random_label = [&](const Point&) { return int(random.below(4)); };
  const std::vector<std::function<int(const Point&)>> labels = {
      small_meshes::ball, small_meshes::two_boxes, small_meshes::four_phases, random_label};
  for (const auto& label : labels) {
    Complex dsc = make_complex(grid(4, label));
    const auto before = betti_numbers::of_complex(dsc);
    for (int field = 0; field < 10; ++field) {
      const double length = random(.1, 3) * dsc.mean_interface_edge();
      const auto wave = random.vector<Complex>(6), amplitude = random.vector<Complex>(length);
      const auto displacement = [&](const Position& p) {
        return field % 2 == 0 ? random.vector<Complex>(length)
                              : std::sin(wave * (p - CGAL::ORIGIN)) * amplitude;
      };
      deform(dsc, displacement,
             parameters::topology_control(Forbid_topology_changes()).maximum_number_of_passes(6));
      ASSERT_EQ(betti_numbers::of_complex(dsc), before) << field;
    }
  }
}

// For any control, only the labels with a granted change may change.
TEST(Topology_control, eight_labels_change_only_where_granted) {
  using Control = std::function<bool(const Complex&, Cell_handle, int)>;
  const auto is_at_the_right = [](const Complex& complex, Cell_handle c, int) {
    return complex.position(c->vertex(0)).x() > 0;
  };
  Random random(4);
  std::size_t granted_in_all = 0;
  for (const Control& control :
       {Control(CGAL::Deformable_simplicial_complexes::Allow_topology_changes()),
        Control(Forbid_topology_changes()),
        Control(Allow_topology_changes_between({std::pair<int, int>(1, 3)})),
        Control(is_at_the_right)}) {
    Complex dsc = make_complex(grid(4, small_meshes::eight_phases));
    auto before = betti_numbers::of_complex(dsc);
    ASSERT_EQ(before.labels.size(), 8u);
    for (int field = 0; field < 4; ++field) {
      std::set<int> granted;
      const auto recorded = [&](const Complex& complex, Cell_handle c, int label) {
        const bool is_granted = control(complex, c, label);
        if (is_granted)
          granted.insert({c->subdomain_index(), label});
        return is_granted;
      };
      const double length = random(.5, 2) * dsc.mean_interface_edge();
      deform(
          dsc, [&](const Position&) { return random.vector<Complex>(length); },
          parameters::topology_control(recorded).maximum_number_of_passes(4));
      const auto after = betti_numbers::of_complex(dsc);
      EXPECT_TRUE(differ_only_in(granted, before, after)) << before << '\n' << after;
      granted_in_all += granted.size();
      before = after;
    }
  }
  EXPECT_GT(granted_in_all, 0u);
}

struct Event_visitor : public DSC::Deformation_visitor<Complex>
{
  std::vector<DSC::Topology_event<Complex>> events;

  void after_topology_event(const DSC::Topology_event<Complex>& event) override {
    events.push_back(event);
  }
};

TEST(Topology_events, tell_of_a_merge_once_and_where) {
  Complex dsc = make_complex(grid(8, two_cubes(1, 1)));
  Event_visitor visitor;
  std::vector<DSC::Topology_event<Complex>> reported;
  for (int i = 0; i < 4; ++i) {
    const auto report = deform(dsc, to_the_middle, parameters::visitor(std::ref(visitor)));
    reported.insert(reported.end(), report.events.begin(), report.events.end());
  }
  ASSERT_EQ(visitor.events.size(), 1u);
  ASSERT_EQ(reported.size(), 1u);
  const auto& event = reported.front();
  EXPECT_EQ(event.kind, DSC::Component_event::Kind::merged);
  EXPECT_EQ(event.label, 1);
  ASSERT_EQ(event.before.size(), 2u);
  ASSERT_EQ(event.after.size(), 1u);
  EXPECT_GE(event.pass, 1u);
  EXPECT_LT(std::abs(event.where.x()), .05);
  EXPECT_LT(std::abs(event.where.y()), .55);
  EXPECT_LT(std::abs(event.where.z()), .55);
  EXPECT_EQ(visitor.events.front().where, event.where);
}

// A bar between two cubes is pinched until it breaks. Then the rest of one side vanishes.
TEST(Topology_events, tell_of_what_splits_and_vanishes) {
  const auto dumbbell = [](const Point& p) {
    const double width = std::abs(p.x()) > .25 ? .5 : .25;
    return std::abs(p.x()) < .75 && std::abs(p.y()) < width && std::abs(p.z()) < width ? 1 : 0;
  };
  Complex dsc = make_complex(grid(8, dumbbell));
  std::vector<DSC::Topology_event<Complex>> events;
  const auto shortened = [](const Vector& way) {
    const double length = std::sqrt(way.squared_length());
    return length > .06 ? .06 / length * way : way;
  };
  for (int i = 0; i < 20 && dsc.number_of_components(1) == 1; ++i) {
    const auto report = deform(
        dsc,
        [&](const Position& p) {
          return std::abs(p.x()) < .2 ? shortened(Vector(0, -p.y(), -p.z())) : Vector(0, 0, 0);
        },
        parameters::manifold_interface(false));
    events.insert(events.end(), report.events.begin(), report.events.end());
  }
  // While cells of the neck are relabeled one after the other, the ends of the neck may meet again.
  ASSERT_FALSE(events.empty());
  std::size_t components = 1;
  for (const auto& event : events) {
    EXPECT_EQ(event.before.size(), components);
    components = event.after.size();
    EXPECT_EQ(event.kind, components == 2 ? DSC::Component_event::Kind::split
                                          : DSC::Component_event::Kind::merged);
    EXPECT_LT(std::abs(event.where.x()), .3);
  }
  EXPECT_EQ(components, 2u);
  events.clear();

  // A part of the left end may separate before the left end vanishes. The right end can reach to
  // the left of the middle.
  const auto vertices_on_the_right = [&] {
    std::set<Vertex_handle> result;
    const auto cells = dsc.finite_cells();
    const auto is_on_the_right = [&](Cell_handle c) {
      return c->subdomain_index() == 1 && dsc.position(c->vertex(0)).x() > .5;
    };
    const auto first = std::find_if(cells.begin(), cells.end(), is_on_the_right);
    for (Cell_handle c : cells)
      if (c->subdomain_index() == 1 && c->component() == (*first)->component())
        for (int i = 0; i < 4; ++i)
          result.insert(c->vertex(i));
    return result;
  };
  for (int i = 0; i < 100 && dsc.number_of_components(1) > 1; ++i) {
    const auto right = vertices_on_the_right();
    const auto report = DSC::deform_interface(
        dsc,
        [&](Vertex_handle v) {
          const Point p = dsc.position(v);
          return right.count(v) > 0 ? p : p + shortened(Point(-.5, 0, 0) - p);
        },
        parameters::manifold_interface(false));
    events.insert(events.end(), report.events.begin(), report.events.end());
  }
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_EQ(dsc.number_of_components(1), 1u);
  ASSERT_FALSE(events.empty());
  EXPECT_EQ(events.back().kind, DSC::Component_event::Kind::vanished);
  EXPECT_EQ(events.back().before.size(), 1u);
  EXPECT_TRUE(events.back().after.empty());
  EXPECT_LT(events.back().where.x(), -.3);
}

} // namespace test_topology
