#include "mesh_helpers.h"

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3/Cavity_3.h>
#include <CGAL/Deformable_simplicial_complex_3/edge_removal_3.h>
#include <CGAL/Deformable_simplicial_complex_3/multi_face_removal_3.h>
#include <CGAL/Deformable_simplicial_complex_3/vertex_optimization_3.h>
#include <CGAL/Deformable_simplicial_complex_3/vertex_smoothing_3.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

// Inner loops take no memory once their buffers have grown.

namespace {

std::size_t number_of_allocations = 0;

} // namespace

void* operator new(std::size_t size) {
  ++number_of_allocations;
  if (void* memory = std::malloc(size))
    return memory;
  throw std::bad_alloc();
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace {

using small_meshes::Complex;

// How often memory is taken for each cell of a mesh, when all have been looked at before.
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
  CGAL::Cavity_3<Complex> cavity(dsc);
  Complex::Point_3 target;
  std::size_t found = 0;
  EXPECT_GT(allocations_a_cell(dsc, [](auto) { std::vector<int> vector(1); }), .9);
  EXPECT_EQ(allocations_a_cell(dsc, [&](auto c) { dsc.star(c->vertex(0), star); }), 0);
  EXPECT_EQ(allocations_a_cell(dsc,
                               [&](auto c) {
                                 dsc.star(c->vertex(1), star);
                                 found +=
                                     CGAL::propose_smart_laplacian(dsc, c->vertex(1), star, target);
                               }),
            0);
  EXPECT_EQ(allocations_a_cell(dsc,
                               [&](auto c) {
                                 if (c->vertex(1)->is_interface())
                                   return; // those are rarely smoothed
                                 dsc.star(c->vertex(1), star);
                                 found += CGAL::propose_optimal_position(dsc, c->vertex(1), star,
                                                                         target);
                               }),
            0);
  EXPECT_EQ(allocations_a_cell(
                dsc, [&](auto c) { found += CGAL::propose_edge_removal(dsc, c, 0, 1, cavity); }),
            0);
  EXPECT_EQ(allocations_a_cell(
                dsc, [&](auto c) { found += CGAL::propose_multi_face_removal(dsc, c, 0, cavity); }),
            0);
  EXPECT_GT(found, 100u);
}
