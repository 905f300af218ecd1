#include "mesh_helpers.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>

#include <new>

// Inner loops allocate no memory once their buffers are large enough. If an allocation fails, the
// complex is unchanged.

namespace {

std::size_t number_of_allocations = 0;
std::size_t failing_allocation = 0; // its number; 0 if no allocation fails

} // namespace

[[gnu::noinline]] void* operator new(std::size_t size) {
  if (++number_of_allocations == failing_allocation)
    throw std::bad_alloc();
  if (void* memory = std::malloc(size))
    return memory;
  throw std::bad_alloc();
}

[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace {

using small_meshes::Complex;

// Returns the number of allocations per cell of a mesh after all cells have been examined once.
template <class Look> double allocations_a_cell(const Complex& dsc, const Look& look) {
  const auto cells = dsc.cells();
  std::size_t before = 0;
  for (int round = 0; round < 2; ++round) {
    before = number_of_allocations;
    for (const auto c : cells)
      look(c);
  }
  return double(number_of_allocations - before) / double(cells.size());
}

} // namespace

TEST(Allocations, there_are_none_where_cells_are_looked_at) {
  const Complex dsc = mesh_helpers::jittered_grid(4, small_meshes::ball, .3, 1);
  std::vector<Complex::Cell_handle> star;
  DSC::Cavity<Complex> cavity(dsc);
  Complex::Point_3 target;
  std::size_t found = 0;
  // A compiler can leave out the allocation of an object that nothing else sees.
  std::vector<int> seen;
  EXPECT_GT(allocations_a_cell(dsc, [&](auto) { std::vector<int>(1).swap(seen); }), .9);
  EXPECT_EQ(allocations_a_cell(dsc, [&](auto c) { dsc.star(c->vertex(0), star); }), 0);
  EXPECT_EQ(allocations_a_cell(dsc,
                               [&](auto c) {
                                 dsc.star(c->vertex(1), star);
                                 found +=
                                     DSC::propose_smart_laplacian(dsc, c->vertex(1), star, target);
                               }),
            0);
  EXPECT_EQ(allocations_a_cell(dsc,
                               [&](auto c) {
                                 if (c->vertex(1)->is_interface())
                                   return; // interface vertices are rarely smoothed
                                 dsc.star(c->vertex(1), star);
                                 found +=
                                     DSC::propose_optimal_position(dsc, c->vertex(1), star, target);
                               }),
            0);
  EXPECT_EQ(allocations_a_cell(
                dsc, [&](auto c) { found += DSC::propose_edge_removal(dsc, c, 0, 1, cavity); }),
            0);
  EXPECT_EQ(allocations_a_cell(
                dsc, [&](auto c) { found += DSC::propose_multi_face_removal(dsc, c, 0, cavity); }),
            0);
  EXPECT_GT(found, 100u);
}

namespace {

// Calls a function repeatedly. In each call, a later allocation fails, until the function succeeds.
// Returns the number of failures.
template <class Function> std::size_t fail_in_turn(const Function& function) {
  for (std::size_t i = 0;; ++i) {
    failing_allocation = number_of_allocations + 1 + i;
    bool has_failed = false;
    try {
      function();
    } catch (const std::bad_alloc&) {
      has_failed = true;
    }
    failing_allocation = 0;
    if (!has_failed)
      return i;
  }
}

} // namespace

TEST(Allocations, components_stay_known_if_one_fails) {
  Complex dsc = mesh_helpers::jittered_grid(3, small_meshes::two_boxes, .3, 1);
  const auto cells = dsc.cells();
  dsc.relabel(cells[40], 5);
  Complex expected = dsc;
  const Complex& asked = dsc;
  EXPECT_GT(fail_in_turn([&] { asked.state(); }), 10u);
  EXPECT_TRUE(dsc.is_valid(true));
  EXPECT_TRUE(dsc.state() == expected.state());
  EXPECT_EQ(dsc.take_component_events().size(), 1u);
}

TEST(Allocations, cavities_know_their_vertices_if_one_fails) {
  const Complex dsc = mesh_helpers::jittered_grid(3, small_meshes::ball, .3, 1);
  DSC::Cavity<Complex> cavity(dsc);
  cavity.clear();
  EXPECT_GT(fail_in_turn([&] {
              for (auto v : dsc.vertices())
                cavity.add(v);
            }),
            3u);
  EXPECT_EQ(cavity.vertices().size(), dsc.number_of_vertices());
  for (std::uint32_t i = 0; i < cavity.vertices().size(); ++i)
    EXPECT_EQ(cavity.index_of(cavity.vertices()[i].handle), i);
}

TEST(Allocations, commits_do_all_or_nothing_if_one_fails) {
  Complex dsc = mesh_helpers::jittered_grid(3, small_meshes::two_boxes, .3, 1);
  DSC::Cavity<Complex> cavity(dsc);
  std::size_t failures = 0;
  for (auto c : dsc.cells())
    if (DSC::propose_edge_removal(dsc, c, 0, 1, cavity)) {
      failures += fail_in_turn([&] {
        const auto before = dsc.version();
        try {
          dsc.replace(cavity);
        } catch (const std::bad_alloc&) {
          EXPECT_EQ(dsc.version(), before);
          throw;
        }
      });
      break;
    }
  EXPECT_GT(failures, 0u);
  EXPECT_TRUE(dsc.is_valid(true));
}

TEST(Allocations, points_are_all_set_or_none_if_one_fails) {
  Complex dsc = mesh_helpers::jittered_grid(3, small_meshes::two_boxes, .3, 1);
  const auto vertices = dsc.vertices();
  const auto cells = dsc.cells();
  std::vector<Complex::Point_3> points;
  for (auto v : vertices)
    points.emplace_back(2 * v->point().x(), v->point().y(), v->point().z());
  const auto shapes = mesh_helpers::shapes_with(dsc, cells, vertices, points);
  const double volume = dsc.volume(1);
  const auto in_turn = [](std::size_t n, const auto& function, std::size_t = 0) {
    for (std::size_t i = 0; i < n; ++i)
      function(i);
  };
  EXPECT_GT(fail_in_turn([&] {
              try {
                dsc.set_points(vertices, points, cells, shapes.measures, shapes.qualities, in_turn);
              } catch (const std::bad_alloc&) {
                failing_allocation = 0;
                EXPECT_TRUE(dsc.is_valid(true));
                EXPECT_EQ(dsc.volume(1), volume);
                throw;
              }
            }),
            0u);
  EXPECT_TRUE(dsc.is_valid(true));
  EXPECT_NEAR(dsc.volume(1), 2 * volume, 1e-12);
}
