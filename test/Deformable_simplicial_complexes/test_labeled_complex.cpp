#include "plane.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/Deformation_options.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>

#include <new>
#include <type_traits>

namespace {

// The number of allocations that still succeed.
std::size_t granted = (std::numeric_limits<std::size_t>::max)();

void* allocate(std::size_t size) {
  if (granted == 0)
    throw std::bad_alloc();
  --granted;
  if (void* result = std::malloc(size == 0 ? 1 : size))
    return result;
  throw std::bad_alloc();
}

} // namespace

void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }

namespace {

using plane::Complex;
using plane::Point;
using Cavity = Complex::Cavity;
using Cell = Complex::Cell_handle;
using Vertex = Complex::Vertex_handle;
constexpr std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();

// With the surroundings, there are four labels, for which the totals have space; a fifth label
// needs more space.
Complex three_disks() {
  return plane::disks_in_a_square({{-.6, 0, .4, 1}, {.6, 0, .4, 2}, {0, 1, .4, 3}}, 24, 2, 12);
}

// Returns a finite cell of a label.
Cell a_cell(const Complex& complex, int label) {
  for (Cell c : complex.cells())
    if (c->subdomain_index() == label)
      return c;
  return Cell();
}

// Calls change(complex) with an increasing number of granted allocations until it succeeds. After
// each failure, the complex must be unchanged.
template <class Change> void fail_at_each_allocation(const Change& change) {
  std::size_t n = 0;
  for (bool is_done = false; !is_done; ++n) {
    ASSERT_LT(n, 1000u);
    Complex complex = three_disks();
    const Complex::State before = complex.state();
    try {
      change(complex, n);
      is_done = true;
    } catch (const std::bad_alloc&) {
      granted = unlimited;
      EXPECT_TRUE(complex.state() == before) << n;
    }
    granted = unlimited;
    EXPECT_TRUE(complex.is_valid(true)) << n;
  }
  EXPECT_GT(n, 1u); // otherwise, no allocation has failed
}

TEST(Labeled_complex, relabeling_without_memory_changes_nothing) {
  fail_at_each_allocation([](Complex& complex, std::size_t n) {
    const Cell c = a_cell(complex, 1);
    granted = n;
    complex.relabel(c, 7); // a label without totals
  });
}

TEST(Labeled_complex, replacing_without_memory_changes_nothing) {
  fail_at_each_allocation([](Complex& complex, std::size_t n) {
    // Replaces the star of an interface vertex by a star with a new center: cells of two labels and
    // a new vertex.
    const Vertex v = complex.interface_vertices().front();
    std::vector<Cell> star;
    complex.star(v, star);
    Cavity cavity(complex);
    cavity.begin(CGAL::Deformable_simplicial_complexes::Proposal_kind::replacement);
    for (Cell c : star)
      cavity.remove(c);
    const auto center = cavity.add(v->point(), v->boundary_class());
    for (Cell c : star) {
      Cavity::Indices corners;
      for (int i = 0; i < 3; ++i)
        corners[i] = c->vertex(i) == v ? center : cavity.add(c->vertex(i));
      cavity.create(corners, c);
    }
    granted = n;
    complex.replace(cavity);
  });
}

TEST(Labeled_complex, refuses_a_stale_proposal) {
  Complex complex = three_disks();
  Cavity cavity(complex);
  bool is_proposed = false;
  for (Cell c : complex.cells())
    for (int i = 0; i < 3 && !is_proposed; ++i)
      is_proposed = propose_edge_flip(complex, c, i, cavity);
  ASSERT_TRUE(is_proposed);
  EXPECT_EQ(cavity.kind(), CGAL::Deformable_simplicial_complexes::Proposal_kind::flip);
  Complex changed = complex;
  complex.relabel(a_cell(complex, 1), 2);
  const Complex::State before = complex.state();
  EXPECT_THROW(complex.replace(cavity),
               CGAL::Deformable_simplicial_complexes::Stale_proposal_error);
  EXPECT_TRUE(complex.state() == before);
}

TEST(Labeled_complex, moves_without_copying) {
  static_assert(std::is_nothrow_move_constructible<Complex>::value, "vectors would copy");
  static_assert(std::is_nothrow_move_assignable<Complex>::value, "");
  Complex complex = three_disks();
  const Complex::State state = complex.state();
  const Vertex v = complex.vertices().front();
  Complex moved = std::move(complex);
  EXPECT_TRUE(moved.state() == state);
  EXPECT_EQ(moved.vertices().front(), v);
  EXPECT_EQ(complex.number_of_vertices(), 0u);
  EXPECT_TRUE(complex.vertices().empty());
  EXPECT_TRUE(complex.is_valid());
  const Complex copy = complex;
  EXPECT_EQ(copy.number_of_cells(), 0u);
  complex.restore(state);
  EXPECT_TRUE(complex.state() == state);
}

// Returns the positions of events for disks that merge. The topology control may query the number
// of components.
std::vector<std::pair<double, double>> places_of_events(bool looks) {
  Complex complex = plane::disks_in_a_square({{-.6, 0, .4, 1}, {.6, 0, .4, 1}}, 40, 2, 20);
  std::vector<std::pair<double, double>> result;
  const auto control = [&](const Complex& c, Cell, int) {
    if (looks) {
      EXPECT_GE(c.number_of_components(1), 1u);
    }
    return true;
  };
  for (int step = 0; step < 12; ++step) {
    const auto report = DSC::deform_interface(
        complex,
        [&](Vertex v) {
          const auto p = complex.position(v);
          return Point(p.x() > 0 ? p.x() - .03 : p.x() + .03, p.y());
        },
        CGAL::parameters::topology_control(control));
    for (const auto& event : report.events)
      result.emplace_back(event.where.x(), event.where.y());
  }
  return result;
}

TEST(Labeled_complex, counting_components_alters_no_number) {
  const auto places = places_of_events(false);
  EXPECT_EQ(places.size(), 1u);
  EXPECT_EQ(places_of_events(true), places);
}

TEST(Labeled_complex, counts_components_before_they_are_numbered) {
  Complex complex = three_disks();
  EXPECT_EQ(complex.number_of_components(1), 1u);
  for (Cell c : complex.cells())
    if (c->subdomain_index() == 2)
      complex.relabel(c, 1);
  EXPECT_EQ(complex.number_of_components(1), 2u);
  EXPECT_EQ(complex.number_of_components(2), 0u);
  complex.update_components();
  EXPECT_EQ(complex.number_of_components(1), 2u);
  EXPECT_NE(complex.component(a_cell(complex, 0)), complex.component(a_cell(complex, 1)));
}

} // namespace
