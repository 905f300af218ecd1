#include "mesh_helpers.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/hilbert_order.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>
#include <CGAL/Random.h>
#include <CGAL/hilbert_sort.h>

// Copies, states, storage order, numbers of components, and errors that is_valid() finds.

namespace test_complex_storage {

using CGAL::Deformable_simplicial_complexes::Invalid_cells_error;
using mesh_helpers::interface_triangles;
using mesh_helpers::jittered_grid;
using namespace small_meshes;

// A complex in which vertices and cells were removed and created.
Complex used_complex() {
  Complex dsc = jittered_grid(4, small_meshes::two_boxes, .45, 11);
  const auto report = DSC::improve_mesh(dsc, parameters::quality_threshold(.7));
  EXPECT_GT(report.flipped, 0u);
  EXPECT_GT(report.collapsed, 0u);
  dsc.set_normalization({Complex::Vector_3(1, 2, 3), 10});
  return dsc;
}

// Changes a complex by operations whose results depend on the storage order.
Complex::State continuation(Complex dsc) {
  mesh_helpers::jitter(dsc, .1, 12);
  DSC::improve_mesh(dsc, parameters::quality_threshold(.8));
  for (int i = 0; i < 3; ++i)
    DSC::deform_interface(dsc, [&](Vertex_handle v) {
      const auto p = dsc.position(v);
      const Complex::Vector_3 way(std::sin(4 * p.y()), std::sin(4 * p.z()), std::sin(4 * p.x()));
      return p + .2 * way;
    });
  EXPECT_TRUE(dsc.is_valid());
  return dsc.state();
}

// Two bars of label 1 with a gap of label 0 between them.
int two_bars(const Point& p) { return std::abs(p.x()) > .5 ? 1 : 0; }

Complex make_bars() { return make_complex(grid(4, two_bars)); }

bool is_bridge(const Complex& dsc, Cell_handle c) {
  const auto p = CGAL::centroid(dsc.position(c->vertex(0)), dsc.position(c->vertex(1)),
                                dsc.position(c->vertex(2)), dsc.position(c->vertex(3)));
  return std::abs(p.x()) < .5 && p.y() > 0 && p.y() < .5 && p.z() > 0 && p.z() < .5;
}

template <class Condition> void relabel(Complex& dsc, int label, Condition condition) {
  for (Cell_handle c : dsc.cells())
    if (condition(c))
      dsc.relabel(c, label);
  EXPECT_TRUE(dsc.is_valid());
}

using Event = DSC::Component_event;

void expect_event(const Event& event, Event::Kind kind, int label, std::size_t before,
                  std::size_t after) {
  EXPECT_EQ(event.kind, kind);
  EXPECT_EQ(event.label, label);
  EXPECT_EQ(event.before.size(), before);
  EXPECT_EQ(event.after.size(), after);
}

// Copies and states

TEST(Complex_storage, copies_continue_to_the_same_bits) {
  const Complex dsc = used_complex();
  Complex copy(dsc);
  EXPECT_TRUE(copy.is_valid());
  EXPECT_TRUE(copy.state() == dsc.state());
  EXPECT_TRUE(continuation(copy) == continuation(dsc));
  mesh_helpers::jitter(copy, .1, 1);
  EXPECT_FALSE(copy.state() == dsc.state()); // the copy shares no data
  copy = dsc;
  EXPECT_TRUE(copy.state() == dsc.state());
}

TEST(Complex_storage, moves_and_swaps_keep_handles) {
  Complex dsc = used_complex();
  const auto state = dsc.state();
  const auto vertices = dsc.vertices();
  Complex moved(std::move(dsc));
  EXPECT_EQ(moved.vertices(), vertices);
  EXPECT_TRUE(moved.state() == state);
  EXPECT_EQ(moved.number_of_components(1), 1u);
  Complex other = make_bars();
  const auto bars = other.state();
  other.swap(moved);
  EXPECT_EQ(other.vertices(), vertices);
  EXPECT_TRUE(moved.state() == bars);
  moved = std::move(other);
  EXPECT_EQ(moved.vertices(), vertices);
  EXPECT_TRUE(moved.is_valid());
}

TEST(Complex_storage, clear_leaves_nothing) {
  Complex dsc = used_complex();
  dsc.clear();
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_EQ(dsc.number_of_vertices(), 0u);
  EXPECT_EQ(dsc.number_of_cells(), 0u);
  EXPECT_EQ(dsc.number_of_components(1), 0u);
  EXPECT_EQ(dsc.volume(1), 0);
  EXPECT_TRUE(dsc.labels().empty());
  EXPECT_TRUE(dsc.vertices().empty());
  EXPECT_TRUE(dsc.interface_facets().empty());
  dsc = used_complex();
  EXPECT_TRUE(dsc.is_valid());
}

TEST(Complex_storage, restored_states_continue_to_the_same_bits) {
  const Complex dsc = used_complex();
  const auto state = dsc.state();
  Complex restored = make_bars();
  restored.restore(state);
  EXPECT_TRUE(restored.is_valid());
  EXPECT_TRUE(restored.state() == state);
  EXPECT_EQ(restored.normalization().scale, 10);
  EXPECT_EQ(restored.mean_interface_edge(), dsc.mean_interface_edge());
  EXPECT_TRUE(continuation(restored) == continuation(dsc));
}

TEST(Complex_storage, impossible_states_are_refused) {
  const auto state = make_complex(grid(2, small_meshes::four_phases)).state();
  Complex dsc = make_bars();
  const auto before = dsc.state();
  const auto expect_refusal = [&](auto spoil) {
    auto spoiled = state;
    spoil(spoiled);
    EXPECT_THROW(dsc.restore(spoiled), Invalid_cells_error);
    EXPECT_TRUE(dsc.state() == before);
  };
  expect_refusal([](auto& s) { s.cell_labels.pop_back(); });
  expect_refusal([](auto& s) { s.points[0][1] = std::nan(""); });
  expect_refusal([](auto& s) { s.spacings[0] = std::numeric_limits<float>::infinity(); });
  expect_refusal([](auto& s) { s.spacings.pop_back(); });
  expect_refusal([](auto& s) { s.vertex_cells[3] = std::uint32_t(s.cells.size()); });
  expect_refusal([](auto& s) { s.cells[3][2] = std::uint32_t(s.points.size() + 1); });
  expect_refusal([](auto& s) { s.cells[3][2] = s.cells[3][1]; });
  expect_refusal([](auto& s) { std::swap(s.points[2], s.points[3]); });
  expect_refusal([](auto& s) { s.boundary_classes[0] ^= 1; });
  expect_refusal([](auto& s) { s.cell_components[0] = 4; });
  expect_refusal([](auto& s) { // two components with the same number
    std::replace(s.cell_components.begin(), s.cell_components.end(), 1u, 0u);
  });
  expect_refusal([](auto& s) { std::swap(s.cells[3][0], s.cells[3][1]); }); // inverted
  expect_refusal([](auto& s) {
    for (auto& c : s.cells) // all infinite cells inverted
      if (std::count(c.begin(), c.end(), 0u) > 0)
        std::swap(c[0], c[1]);
  });
}

TEST(Complex_storage, is_sorted_without_changing_anything_else) {
  Complex dsc = used_complex();
  const auto triangles = interface_triangles(dsc);
  const auto qualities = [&] {
    std::vector<std::pair<double, int>> result;
    for (Cell_handle c : dsc.cells())
      result.emplace_back(dsc.quality(c), dsc.label(c));
    std::sort(result.begin(), result.end());
    return result;
  };
  const auto points = [&] {
    std::vector<std::pair<mesh_helpers::Coordinates, int>> result;
    for (Vertex_handle v : dsc.vertices())
      result.emplace_back(mesh_helpers::coordinates(dsc, v), v->boundary_class());
    std::sort(result.begin(), result.end());
    return result;
  };
  const auto qualities_before = qualities();
  const auto points_before = points();
  const double volume = dsc.volume(1), area = dsc.area(1, 2), edge = dsc.mean_interface_edge();
  dsc.sort_storage();
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_TRUE(interface_triangles(dsc) == triangles);
  EXPECT_EQ(qualities(), qualities_before);
  EXPECT_EQ(points(), points_before);
  EXPECT_EQ(dsc.volume(1), volume);
  EXPECT_NEAR(dsc.area(1, 2), area, 1e-14);
  EXPECT_EQ(dsc.mean_interface_edge(), edge);
  EXPECT_EQ(dsc.normalization().scale, 10);
}

TEST(Complex_storage, orders_follow_creation) {
  const Complex dsc = used_complex();
  const auto by_time_stamp = [](auto a, auto b) { return a->time_stamp() < b->time_stamp(); };
  const auto vertices = dsc.vertices(), interface_vertices = dsc.interface_vertices();
  const auto cells = dsc.cells();
  EXPECT_TRUE(std::is_sorted(vertices.begin(), vertices.end(), by_time_stamp));
  EXPECT_TRUE(std::is_sorted(interface_vertices.begin(), interface_vertices.end(), by_time_stamp));
  EXPECT_TRUE(std::is_sorted(cells.begin(), cells.end(), by_time_stamp));
  const auto facets = dsc.interface_facets();
  EXPECT_TRUE(std::is_sorted(facets.begin(), facets.end(), [](const auto& a, const auto& b) {
    return std::make_pair(a.first->time_stamp(), a.second) <
           std::make_pair(b.first->time_stamp(), b.second);
  }));
  EXPECT_TRUE(used_complex().state() == dsc.state());
}

TEST(Complex_storage, ids_stay_dense) {
  Complex dsc = small_meshes::make_complex(small_meshes::grid(3, small_meshes::two_boxes));
  const std::size_t vertices = dsc.number_of_vertices() + 1, // and the infinite cell
      cells = dsc.triangulation().tds().number_of_cells();
  EXPECT_EQ(dsc.vertex_id_bound(), vertices);
  EXPECT_EQ(dsc.cell_id_bound(), cells);
  DSC::Cavity<Complex> cavity(dsc);
  std::size_t most_vertices = vertices, most_cells = cells;
  for (int i = 0; i < 60; ++i) {
    const auto all = dsc.cells();
    const auto c = all[std::size_t(i) * 7 % all.size()];
    const bool is_split = i % 3 != 0 && DSC::propose_edge_split(dsc, c, 0, 1, .5, cavity);
    if (!is_split && !DSC::propose_edge_collapse(dsc, c, i % 4, (i + 1) % 4, 0, cavity))
      continue;
    // New cells are created before the replaced cells are removed.
    const std::size_t planned = cavity.planned().size();
    most_vertices = (std::max)(most_vertices, dsc.number_of_vertices() + 2);
    most_cells = (std::max)(most_cells, dsc.triangulation().tds().number_of_cells() + planned);
    dsc.replace(cavity);
    ASSERT_TRUE(dsc.is_valid(true));
    EXPECT_LE(dsc.vertex_id_bound(), most_vertices);
    EXPECT_LE(dsc.cell_id_bound(), most_cells);
  }
  EXPECT_GT(dsc.version(), 30u);
}

TEST(Complex_storage, stars_hold_each_cell_around_once) {
  const Complex dsc = used_complex();
  std::vector<Cell_handle> star, expected;
  for (Vertex_handle v : dsc.vertices()) {
    dsc.star(v, star);
    EXPECT_EQ(star.front(), v->cell());
    expected.clear();
    dsc.triangulation().tds().incident_cells(v, std::back_inserter(expected));
    std::sort(star.begin(), star.end());
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(star, expected);
  }
}

// Components

TEST(Components, merge_and_split) {
  const double rounding = 1e-14; // of sums of volumes of cells below 8
  Complex dsc = make_bars();
  EXPECT_EQ(dsc.number_of_components(1), 2u);
  const double volume = dsc.volume(1);
  relabel(dsc, 1, [&](Cell_handle c) { return is_bridge(dsc, c); });
  EXPECT_EQ(dsc.number_of_components(1), 1u);
  auto events = dsc.take_component_events();
  ASSERT_EQ(events.size(), 1u);
  expect_event(events[0], Event::Kind::merged, 1, 2, 1);
  // The volumes are those just before the change: a part of the bridge may belong to a bar then.
  const double joined = dsc.volume(1),
               bars = events[0].before[0].volume + events[0].before[1].volume;
  EXPECT_GE(bars, volume - rounding);
  EXPECT_LT(bars, joined - rounding);
  EXPECT_NEAR(events[0].after[0].volume, joined, rounding);
  EXPECT_TRUE(dsc.take_component_events().empty());
  relabel(dsc, 0, [&](Cell_handle c) { return is_bridge(dsc, c); });
  events = dsc.take_component_events();
  ASSERT_EQ(events.size(), 1u);
  expect_event(events[0], Event::Kind::split, 1, 1, 2);
  EXPECT_NEAR(events[0].after[0].volume + events[0].after[1].volume, volume, rounding);
  for (const auto& part : events[0].after) {
    std::size_t cells = 0;
    for (Cell_handle c : dsc.cells())
      cells += c->subdomain_index() == 1 && c->component() == part.component;
    EXPECT_EQ(2 * cells, dsc.number_of_cells(1));
  }
}

TEST(Components, events_come_in_order) {
  Complex dsc = make_bars();
  relabel(dsc, 1, [&](Cell_handle c) { return is_bridge(dsc, c); });
  EXPECT_EQ(dsc.number_of_components(1), 1u);
  dsc.update_components(); // the copy is only inspected
  relabel(dsc, 0, [&](Cell_handle c) { return c->subdomain_index() == 1; });
  EXPECT_EQ(dsc.number_of_components(1), 0u);
  EXPECT_EQ(dsc.labels(), std::vector<int>{0});
  const auto events = dsc.take_component_events();
  ASSERT_EQ(events.size(), 2u);
  expect_event(events[0], Event::Kind::merged, 1, 2, 1);
  expect_event(events[1], Event::Kind::vanished, 1, 1, 0);
  EXPECT_EQ(dsc.volume(1), 0);
  EXPECT_TRUE(dsc.interface_vertices().empty());
}

TEST(Components, what_happens_between_two_looks_is_one_event) {
  Complex dsc = make_bars();
  relabel(dsc, 1, [&](Cell_handle c) { return is_bridge(dsc, c); });
  relabel(dsc, 0, [&](Cell_handle c) { return c->subdomain_index() == 1; });
  const auto events = dsc.take_component_events();
  ASSERT_EQ(events.size(), 2u); // of each bar
  expect_event(events[0], Event::Kind::vanished, 1, 1, 0);
  expect_event(events[1], Event::Kind::vanished, 1, 1, 0);
}

TEST(Components, of_a_label_that_was_not_there_appear) {
  Complex dsc = make_bars();
  const auto cells = dsc.cells();
  const Cell_handle c =
      *std::find_if(cells.begin(), cells.end(), [&](Cell_handle d) { return is_bridge(dsc, d); });
  dsc.relabel(c, 7);
  const auto events = dsc.take_component_events();
  ASSERT_EQ(events.size(), 1u);
  expect_event(events[0], Event::Kind::appeared, 7, 0, 1);
  EXPECT_DOUBLE_EQ(events[0].after[0].volume, dsc.volume(7));
}

TEST(Components, one_of_two_vanishes) {
  Complex dsc = make_bars();
  relabel(dsc, 0, [&](Cell_handle c) {
    return c->subdomain_index() == 1 && dsc.position(c->vertex(0)).x() > 0;
  });
  const auto events = dsc.take_component_events();
  ASSERT_EQ(events.size(), 1u);
  expect_event(events[0], Event::Kind::vanished, 1, 1, 0);
}

// A state stores the volumes at the time of numbering, so that a resumed run reports the same
// events.
TEST(Components, keep_their_numbers_in_states) {
  Complex dsc = jittered_grid(4, two_bars, .45, 7);
  const auto expect_same_events = [](Complex& a, Complex& b) {
    const auto expected = a.take_component_events(), events = b.take_component_events();
    EXPECT_FALSE(expected.empty());
    ASSERT_EQ(events.size(), expected.size());
    const auto expect_same_parts = [](const auto& parts, const auto& expected_parts) {
      ASSERT_EQ(parts.size(), expected_parts.size());
      for (std::size_t i = 0; i < parts.size(); ++i) {
        EXPECT_EQ(parts[i].component, expected_parts[i].component);
        EXPECT_EQ(parts[i].volume, expected_parts[i].volume);
      }
    };
    for (std::size_t i = 0; i < events.size(); ++i) {
      EXPECT_EQ(events[i].kind, expected[i].kind);
      EXPECT_EQ(events[i].label, expected[i].label);
      expect_same_parts(events[i].before, expected[i].before);
      expect_same_parts(events[i].after, expected[i].after);
    }
  };
  // Remeshing changes cells and volumes, but not components.
  DSC::improve_mesh(dsc, parameters::quality_threshold(.6).number_of_iterations(1));
  DSC::deform_interface(
      dsc, [&](Vertex_handle v) { return CGAL::ORIGIN + .95 * (dsc.position(v) - CGAL::ORIGIN); });
  dsc.take_component_events();
  Complex restored;
  restored.restore(dsc.state());
  for (const int label : {1, 0, 1}) {
    for (Complex* complex : {&dsc, &restored})
      relabel(*complex, label, [&](Cell_handle c) { return is_bridge(*complex, c); });
    expect_same_events(dsc, restored);
  }
}

// Validity

TEST(Is_valid, sees_what_was_tampered_with) {
  using CGAL::Deformable_simplicial_complexes::internal::Simplex_access;
  const Complex good = used_complex();
  EXPECT_TRUE(good.is_valid());
  const auto expect_invalid = [&](auto tamper) {
    Complex dsc = good;
    tamper(dsc);
    EXPECT_FALSE(dsc.is_valid());
  };
  for (std::size_t i : {0, 20, 90}) {
    expect_invalid([&](Complex& dsc) { Simplex_access::set_quality(dsc.cells()[i], .5); });
    expect_invalid([&](Complex& dsc) { dsc.cells()[i]->set_subdomain_index(9); });
    expect_invalid(
        [&](Complex& dsc) { Simplex_access::set_id(dsc.cells()[i], dsc.cells()[i + 1]->id()); });
    expect_invalid([&](Complex& dsc) { Simplex_access::set_id(dsc.vertices()[i], 1000000); });
    expect_invalid([&](Complex& dsc) {
      const Cell_handle c = dsc.cells()[i];
      c->set_subdomain_index(c->subdomain_index() == 0 ? 1 : 0);
    });
    expect_invalid([&](Complex& dsc) {
      const Vertex_handle v = dsc.vertices()[i];
      Simplex_access::set_interface_degree(v, v->interface_degree() + 1);
    });
    expect_invalid([&](Complex& dsc) { // a small displacement, so that all cells stay positive
      const Vertex_handle v = dsc.vertices()[i];
      const Point& p = v->point();
      v->set_point(Point(p.x() + 1e-12, p.y(), p.z()));
    });
    expect_invalid([&](Complex& dsc) { // a large displacement
      const Vertex_handle v = dsc.vertices()[i];
      v->set_point(Point(3, 3, 3));
    });
    expect_invalid([&](Complex& dsc) {
      const Vertex_handle v = dsc.vertices()[i];
      Simplex_access::set_boundary_class(v, dsc.is_boundary(v) ? 0 : 1);
    });
  }
}

// A vertex on a side that is not planar would change the domain if it moved along the side.
TEST(Is_valid, sees_sides_that_are_no_planes) {
  const Complex dsc = make_complex(grid(2, small_meshes::uniform));
  for (Vertex_handle v : dsc.vertices())
    if (dsc.is_boundary(v))
      CGAL::Deformable_simplicial_complexes::internal::Simplex_access::set_boundary_class(
          v, 1); // also for the vertices at x = 1
  EXPECT_FALSE(dsc.is_valid());
}

// Order in storage

TEST(Hilbert_order, is_that_of_CGAL) {
  using Point = Complex::Point_3;
  std::vector<Point> points;
  CGAL::Random random(3);
  for (int i = 0; i < 3000; ++i)
    points.emplace_back(random.get_int(0, 9), random.get_double(), random.get_double());
  const auto order =
      CGAL::Deformable_simplicial_complexes::internal::hilbert_order<Complex::Space>(points);
  ASSERT_EQ(order.size(), points.size());
  std::vector<Point> sorted = points;
  CGAL::hilbert_sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(points[order[i]], sorted[i]);
}

// Complexes without cells

TEST(Empty_complex, state_can_be_restored) {
  const Complex empty;
  EXPECT_TRUE(empty.is_valid());
  Complex dsc = make_bars();
  ASSERT_NO_THROW(dsc.restore(empty.state()));
  EXPECT_EQ(dsc.number_of_cells(), 0u);
}

TEST(Empty_complex, storage_can_be_sorted) {
  Complex dsc;
  ASSERT_NO_THROW(dsc.sort_storage());
  EXPECT_TRUE(dsc.is_valid());
}

} // namespace test_complex_storage
