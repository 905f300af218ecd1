#include "mesh_helpers.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complex_traits_3.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

namespace {

using Rational = CGAL::Exact_rational;
using mesh_helpers::Random;

template <class Kernel> class Traits_on_kernel : public testing::Test
{
protected:
  using Traits = CGAL::Deformable_simplicial_complex_traits_3<Kernel>;
  using Point = typename Traits::Point_3;

  Traits traits;
  Random random{3};
};

using Kernels = testing::Types<CGAL::Exact_predicates_inexact_constructions_kernel,
                               CGAL::Exact_predicates_exact_constructions_kernel,
                               CGAL::Simple_cartesian<Rational>>;
TYPED_TEST_SUITE(Traits_on_kernel, Kernels);

} // namespace

TYPED_TEST(Traits_on_kernel, orientation_is_exact) {
  using Point = typename TestFixture::Point;
  const auto orientation = this->traits.orientation_3_object();
  const Point o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  EXPECT_EQ(orientation(o, x, y, z), CGAL::POSITIVE);
  EXPECT_EQ(orientation(x, o, y, z), CGAL::NEGATIVE);
  const double third = 1. / 3, smallest = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(orientation(o, x, y, Point(third, third, 0)), CGAL::COPLANAR);
  EXPECT_EQ(orientation(o, x, y, Point(third, third, smallest)), CGAL::POSITIVE);
  EXPECT_EQ(orientation(o, x, y, Point(third, third, -smallest)), CGAL::NEGATIVE);
  // 0.1 + 0.2 differs from 0.3: the four points do not lie in the plane x + y = z
  EXPECT_NE(orientation(o, Point(1, 1, 2), Point(1, 0, 1), Point(.1, .2, .3)), CGAL::COPLANAR);
}

TYPED_TEST(Traits_on_kernel, constructions_keep_double_coordinates) {
  using Approximate = typename TestFixture::Traits::Approximate_point_3;
  const auto exact = this->traits.construct_exact_point_3_object();
  const auto approximate = this->traits.construct_approximate_point_3_object();
  for (int i = 0; i < 100; ++i) {
    const Approximate p(this->random(-1, 1), this->random(-1e9, 1e9), this->random(0, 1e-300));
    EXPECT_EQ(approximate(exact(p)), p);
  }
  const auto volume = this->traits.compute_approximate_volume_3_object();
  const Approximate o(0, 0, 0), x(2, 0, 0), y(0, 3, 0), z(0, 0, 4);
  EXPECT_EQ(volume(o, x, y, z), 4);
  EXPECT_EQ(volume(x, o, y, z), -4);
}

// All operations run with any kernel and give bitwise equal results.
TYPED_TEST(Traits_on_kernel, complex_does_not_depend_on_the_kernel) {
  using Complex = CGAL::Deformable_simplicial_complex_3<typename TestFixture::Traits>;
  const auto mesh = small_meshes::grid(4, small_meshes::two_boxes);
  const auto run = [&](auto& dsc) {
    mesh_helpers::jitter(dsc, .2, 5);
    DSC::deform_interface(dsc, [&](auto v) {
      const auto p = dsc.position(v);
      return mesh_helpers::exact_point(
          dsc, p + .1 * typename Complex::Approximate_vector_3(p.y(), -p.x(), 1));
    });
    DSC::improve_mesh(dsc);
    EXPECT_TRUE(dsc.is_valid());
    return dsc.state();
  };
  Complex dsc;
  std::vector<typename Complex::Point_3> points;
  for (const auto& p : mesh.points)
    points.emplace_back(p.x(), p.y(), p.z());
  dsc.assign(points, mesh.tetrahedra, mesh.labels);
  EXPECT_NEAR(dsc.volume(1), .5, 1e-14);
  small_meshes::Complex reference = small_meshes::make_complex(mesh);
  EXPECT_TRUE(run(dsc) == run(reference));
}
