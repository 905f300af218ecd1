// Overlap volumes of tetrahedra, and redistribution of contents by overlap.
#include "mesh_helpers.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/internal/traversal/cell_corners.h>
#include <CGAL/Interface_remeshing/Carried_cell_averages.h>
#include <CGAL/Interface_remeshing/internal/values/overlap_measure.h>

namespace test_redistribution {

namespace internal = CGAL::Deformable_simplicial_complexes::internal;
using mesh_helpers::jittered_grid;
using mesh_helpers::Random;
using namespace small_meshes;
using Corners = std::array<Position, 4>;
using Tetrahedron = internal::Clipping_simplex<Complex::Space>;
using Filled = internal::Filled_simplex<Complex::Space, double>;

double overlap_volume(const Corners& s, const Corners& t) {
  return internal::overlap_measure(Tetrahedron(s), Tetrahedron(t));
}

// Returns a tetrahedron between a segment of the x-axis and an edge. Its volume is one sixth of the
// length.
Filled between(double from, double to, int label, double content) {
  return {
      Tetrahedron({Position(from, 0, 0), Position(to, 0, 0), Position(0, 1, 0), Position(0, 0, 1)}),
      label, content};
}

std::vector<double> redistributed(const std::vector<Filled>& from, std::vector<Filled> to) {
  internal::redistribute_contents(from, to);
  std::vector<double> contents;
  for (const Filled& t : to)
    contents.push_back(t.content);
  return contents;
}

void expect_near(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_NEAR(a[i], b[i], 1e-14);
}

TEST(Overlap_volume, of_simple_tetrahedra) {
  const Corners unit = {Position(0, 0, 0), Position(1, 0, 0), Position(0, 1, 0), Position(0, 0, 1)};
  const auto placed = [&](double scale, double shift) {
    Corners result = unit;
    for (Position& p : result)
      p = Position(scale * p.x() + shift, scale * p.y() + shift, scale * p.z() + shift);
    return result;
  };
  const auto expect = [](const Corners& s, const Corners& t, double volume) {
    EXPECT_NEAR(overlap_volume(s, t), volume, 1e-15);
    EXPECT_NEAR(overlap_volume(t, s), volume, 1e-15);
  };
  expect(unit, unit, 1. / 6);
  expect(unit, placed(1, 2), 0);
  expect(unit, placed(1, .5), 0); // overlapping boxes
  expect(unit, placed(1, .25), 1. / 384);
  expect(unit, placed(.5, 0), 1. / 48);
  expect(unit, placed(.25, .05), 1. / 384); // inside
  expect(unit, placed(3, -.5), 1. / 6);     // outside
  // a common facet, a common vertex
  expect(unit, {Position(0, 0, 0), Position(0, 1, 0), Position(1, 0, 0), Position(0, 0, -1)}, 0);
  expect(unit, placed(-1, 0), 0);
  // half of it, and half of that half
  expect(unit, {Position(0, 0, 0), Position(.5, .5, 0), Position(0, 1, 0), Position(0, 0, 1)},
         1. / 12);
  // both tetrahedra on every second corner of a cube: their intersection is an octahedron
  expect({Position(0, 0, 0), Position(1, 1, 0), Position(0, 1, 1), Position(1, 0, 1)},
         {Position(1, 0, 0), Position(0, 1, 0), Position(0, 0, 1), Position(1, 1, 1)}, 1. / 6);
}

// The tetrahedra of a rotated grid cover each tetrahedron inside.
TEST(Overlap_volume, sums_to_the_volume) {
  const Complex dsc = jittered_grid(3, small_meshes::uniform, .3, 1);
  const auto turned = [](const Position& p) {
    return Position(.6 * p.x() - .8 * p.y(), .8 * p.x() + .6 * p.y(), p.z());
  };
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    Corners t;
    for (Position& p : t)
      p = CGAL::ORIGIN + random.vector<Complex>(.55);
    if (internal::signed_measure<Complex::Space>(t) < 0)
      std::swap(t[0], t[1]);
    double sum = 0;
    for (const auto c : dsc.cells()) {
      Corners s = internal::cell_corners(dsc, c);
      for (Position& p : s)
        p = turned(p);
      sum += overlap_volume(s, t);
    }
    EXPECT_NEAR(sum, internal::signed_measure<Complex::Space>(t), 1e-15);
  }
}

TEST(Redistribute_contents, by_overlap) {
  expect_near(redistributed({between(0, 1, 0, 10), between(1, 2, 0, 20)},
                            {between(0, .5, 0, 0), between(.5, 1.5, 0, 0), between(1.5, 2, 0, 0)}),
              {5, 15, 10});
}

TEST(Redistribute_contents, within_labels_as_far_as_there_are_any) {
  // label 1 grows: its content spreads into the gap only
  expect_near(redistributed({between(0, 1, 1, 6), between(1, 2, 1, 6), between(2, 4, 2, 1)},
                            {between(0, 1, 1, 0), between(1, 3, 1, 0), between(3, 4, 2, 0)}),
              {6, 6, 1});
  // label 1 shrinks at one end and grows by the same volume at the other end: its density is
  // constant
  expect_near(redistributed({between(0, 1, 0, 0), between(1, 3, 1, 8), between(3, 4, 0, 0)},
                            {between(0, 2, 0, 0), between(2, 4, 1, 0)}),
              {0, 8});
  // label 1 shrinks: all its cells take the remaining content
  expect_near(redistributed({between(0, 3, 1, 9), between(3, 4, 0, 1)},
                            {between(0, 1, 1, 0), between(1, 2, 1, 0), between(2, 4, 0, 0)}),
              {4.5, 4.5, 1});
  // label 1 vanishes
  expect_near(redistributed({between(0, 1, 1, 9), between(1, 2, 0, 2)},
                            {between(0, .5, 0, 0), between(.5, 2, 0, 0)}),
              {4.5, 6.5});
}

TEST(Redistribute_contents, of_flat_tetrahedra) {
  const auto contents =
      redistributed({between(1, 1, 0, 3), between(1, 2, 0, 2)},
                    {between(1, 1, 0, 0), between(1, 1.5, 0, 0), between(1.5, 2, 0, 0)});
  EXPECT_NEAR(contents[0] + contents[1] + contents[2], 5, 1e-14);
  expect_near(redistributed({between(1, 1, 0, 3)}, {between(1, 1, 0, 0)}), {3});
}

} // namespace test_redistribution
