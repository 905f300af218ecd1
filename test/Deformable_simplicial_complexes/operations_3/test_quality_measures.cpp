#include "mesh_helpers.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/quality_measures.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace test_quality_measures {

using Kernel = CGAL::Epick;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Tetrahedron = std::array<Point, 4>;

double length(const Vector& v) { return std::sqrt(v.squared_length()); }

double volume(const Tetrahedron& t) {
  return CGAL::determinant(t[1] - t[0], t[2] - t[0], t[3] - t[0]) / 6;
}

double facet_area(const Tetrahedron& t, int opposite) {
  const Point &a = t[(opposite + 1) % 4], &b = t[(opposite + 2) % 4], &c = t[(opposite + 3) % 4];
  return length(CGAL::cross_product(b - a, c - a)) / 2;
}

// Returns the dihedral angle at the edge ij, computed from directions in the facets orthogonal to
// the edge.
double dihedral_angle(const Tetrahedron& t, int i, int j) {
  std::vector<Vector> across;
  const Vector edge = (t[j] - t[i]) / length(t[j] - t[i]);
  for (int k = 0; k < 4; ++k)
    if (k != i && k != j) {
      const Vector v = t[k] - t[i];
      across.push_back(v - (v * edge) * edge);
    }
  return std::atan2(length(CGAL::cross_product(across[0], across[1])), across[0] * across[1]);
}

double circumradius(const Tetrahedron& t) {
  // Solves 2 (t[i] - t[0]) x = |t[i] - t[0]|^2 for i = 1, 2, 3 by Cramer's rule.
  const std::array<Vector, 3> rows = {t[1] - t[0], t[2] - t[0], t[3] - t[0]};
  const Vector right(rows[0].squared_length() / 2, rows[1].squared_length() / 2,
                     rows[2].squared_length() / 2);
  const auto column = [&](int k) { return Vector(rows[0][k], rows[1][k], rows[2][k]); };
  const double d = CGAL::determinant(column(0), column(1), column(2));
  return length(Vector(CGAL::determinant(right, column(1), column(2)) / d,
                       CGAL::determinant(column(0), right, column(2)) / d,
                       CGAL::determinant(column(0), column(1), right) / d));
}

// The quality measures computed from their definitions.

double slow(const DSC::Volume_length_ratio_3&, const Tetrahedron& t) {
  double squared = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      squared += (t[i] - t[j]).squared_length() / 6;
  return 6 * std::sqrt(2.) * volume(t) / std::pow(std::sqrt(squared), 3);
}

double slow(const DSC::Minimum_sine_3&, const Tetrahedron& t) {
  double minimum = 1;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      minimum = (std::min)(minimum, std::sin(dihedral_angle(t, i, j)));
  return minimum / (2 * std::sqrt(2.) / 3);
}

double slow(const DSC::Biased_minimum_sine_3&, const Tetrahedron& t) {
  double minimum = 1;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) {
      const double angle = dihedral_angle(t, i, j);
      minimum = (std::min)(minimum, (std::cos(angle) < 0 ? .7 : 1) * std::sin(angle));
    }
  return minimum / (2 * std::sqrt(2.) / 3);
}

double slow(const DSC::Radius_ratio_3&, const Tetrahedron& t) {
  double area = 0;
  for (int i = 0; i < 4; ++i)
    area += facet_area(t, i);
  return 3 * (3 * volume(t) / area) / circumradius(t);
}

double of_corner(const DSC::Volume_length_ratio_3&) { return 4 / (3 * std::sqrt(3.)); }
double of_corner(const DSC::Minimum_sine_3&) { return std::sqrt(3.) / 2; }
double of_corner(const DSC::Biased_minimum_sine_3&) { return std::sqrt(3.) / 2; }
double of_corner(const DSC::Radius_ratio_3&) { return std::sqrt(3.) - 1; }

Tetrahedron regular() {
  return {Point(1, 1, 1), Point(1, -1, -1), Point(-1, -1, 1), Point(-1, 1, -1)};
}

Tetrahedron corner() { return {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1)}; }

Tetrahedron random_tetrahedron(mesh_helpers::Random& random) {
  Tetrahedron t;
  do
    for (Point& p : t) {
      const double x = random(-1, 1), y = random(-1, 1);
      p = Point(x, y, random(-1, 1));
    }
  while (!(volume(t) > 1e-3));
  return t;
}

template <class Measure> class Quality_measures : public testing::Test
{
protected:
  double quality(const Tetrahedron& t) const { return measure(t[0], t[1], t[2], t[3]); }

  Measure measure;
  mesh_helpers::Random random{7};
};

using Measures = testing::Types<DSC::Volume_length_ratio_3, DSC::Minimum_sine_3,
                                DSC::Biased_minimum_sine_3, DSC::Radius_ratio_3>;
TYPED_TEST_SUITE(Quality_measures, Measures);

TYPED_TEST(Quality_measures, regular_tetrahedron_is_one) {
  EXPECT_NEAR(this->quality(regular()), 1, 1e-15);
}

TYPED_TEST(Quality_measures, corner_tetrahedron_has_its_closed_form) {
  EXPECT_NEAR(this->quality(corner()), of_corner(this->measure), 1e-15);
}

TYPED_TEST(Quality_measures, flat_tetrahedron_is_zero) {
  EXPECT_EQ(this->quality({Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(3, 2, 0)}), 0);
  // a cap, a spade and a sliver, whose four points lie on a circle
  EXPECT_EQ(this->quality({Point(0, 0, 0), Point(4, 0, 0), Point(0, 4, 0), Point(1, 1, 0)}), 0);
  EXPECT_EQ(this->quality({Point(0, 0, 0), Point(4, 0, 0), Point(0, 4, 0), Point(2, 2, 0)}), 0);
  EXPECT_EQ(this->quality({Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)}), 0);
}

TYPED_TEST(Quality_measures, inverted_tetrahedron_is_negative) {
  for (int i = 0; i < 100; ++i) {
    Tetrahedron t = random_tetrahedron(this->random);
    const double upright = this->quality(t);
    std::swap(t[0], t[1]);
    EXPECT_LT(this->quality(t), 0);
    EXPECT_GT(upright, 0);
  }
  Tetrahedron mirrored = regular();
  std::swap(mirrored[2], mirrored[3]);
  EXPECT_LT(this->quality(mirrored), 0);
}

TYPED_TEST(Quality_measures, agrees_with_its_definition) {
  for (int i = 0; i < 1000; ++i) {
    const Tetrahedron t = random_tetrahedron(this->random);
    const double quality = this->quality(t);
    EXPECT_NEAR(quality, slow(this->measure, t), 1e-9);
    EXPECT_GT(quality, 0);
    EXPECT_LE(quality, 1 + 1e-12);
  }
}

TYPED_TEST(Quality_measures, does_not_depend_on_the_order_of_vertices) {
  for (int i = 0; i < 50; ++i) {
    const Tetrahedron t = random_tetrahedron(this->random);
    const double quality = this->quality(t);
    std::array<int, 4> order = {0, 1, 2, 3};
    do {
      const Tetrahedron permuted = {t[order[0]], t[order[1]], t[order[2]], t[order[3]]};
      if (volume(permuted) > 0) { // an even permutation
        EXPECT_NEAR(this->quality(permuted), quality, 1e-12);
      }
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

TYPED_TEST(Quality_measures, is_invariant_under_similarities) {
  for (int i = 0; i < 200; ++i) {
    const Tetrahedron t = random_tetrahedron(this->random);
    const double angle = this->random(0, 6.28), scale = std::exp(this->random(-5, 5));
    const Vector shift(this->random(-1, 1), this->random(-1, 1), this->random(-1, 1));
    Tetrahedron image;
    for (int k = 0; k < 4; ++k) {
      const Vector v =
          t[k] - CGAL::ORIGIN; // rotated about z, then x and z exchanged and y reflected
      const double x = std::cos(angle) * v.x() - std::sin(angle) * v.y(),
                   y = std::sin(angle) * v.x() + std::cos(angle) * v.y();
      image[k] = CGAL::ORIGIN + scale * (Vector(v.z(), -y, x) + shift);
    }
    ASSERT_GT(volume(image), 0);
    EXPECT_NEAR(this->quality(image), this->quality(t), 1e-10);
  }
}

// The quality of thin tetrahedra decreases with their height, down to the smallest heights.
TYPED_TEST(Quality_measures, decreases_with_the_height_of_a_sliver) {
  double last = 2;
  for (double height = .5; height > 1e-12; height /= 16) {
    const Tetrahedron t = {Point(0, 0, 0), Point(1, 1, 0), Point(0, 1, height),
                           Point(1, 0, height)};
    const double quality =
        volume(t) > 0 ? this->quality(t) : this->quality({t[1], t[0], t[2], t[3]});
    EXPECT_GT(quality, 0);
    EXPECT_LT(quality, last);
    last = quality;
  }
  EXPECT_LT(last, 1e-9);
}

// Gradients compared with central differences, also for thin tetrahedra.
TEST(Volume_length_ratio, gradient_agrees_with_differences) {
  const DSC::Volume_length_ratio_3 measure;
  mesh_helpers::Random random(8);
  for (int i = 0; i < 500; ++i) {
    Tetrahedron t = random_tetrahedron(random);
    if (i % 2 == 0) // nearly degenerate
      t[0] = t[1] + .3 * (t[2] - t[1]) + .4 * (t[3] - t[1]) + 1e-3 * (t[0] - t[1]);
    const Vector gradient = measure.gradient(t[0], t[1], t[2], t[3]);
    const auto slope = [&](const Vector& axis) {
      static constexpr double h = 1e-5;
      return (measure(t[0] + h * axis, t[1], t[2], t[3]) -
              measure(t[0] - h * axis, t[1], t[2], t[3])) /
             (2 * h);
    };
    const Vector expected(slope(Vector(1, 0, 0)), slope(Vector(0, 1, 0)), slope(Vector(0, 0, 1)));
    EXPECT_LT(std::sqrt((gradient - expected).squared_length()),
              1e-6 * (1 + std::sqrt(expected.squared_length())));
  }
}

} // namespace test_quality_measures
