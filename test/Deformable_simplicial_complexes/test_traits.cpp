#include "mesh_helpers.h"
#include "test.h"

#include <CGAL/Interface_remeshing/improve_mesh.h>

#include <CGAL/Filtered_kernel.h>
#include <CGAL/Simple_cartesian.h>

// A complex takes any kernel with exact predicates whose numbers are doubles. The result does not
// depend on the kernel.
TEST(Traits, complex_on_another_kernel) {
  using Kernel = CGAL::Filtered_kernel<CGAL::Simple_cartesian<double>>;
  using Complex = CGAL::Deformable_simplicial_complex_3<Kernel>;
  const auto mesh = small_meshes::grid(4, small_meshes::two_boxes);
  const auto run = [](auto& dsc) {
    using Vector = typename std::decay_t<decltype(dsc)>::Vector_3;
    mesh_helpers::jitter(dsc, .2, 5);
    DSC::deform_interface(dsc, [&](auto v) {
      const auto p = dsc.position(v);
      return p + .1 * Vector(p.y(), -p.x(), 1);
    });
    DSC::improve_mesh(dsc);
    EXPECT_TRUE(dsc.is_valid());
    return dsc.state();
  };
  Complex dsc;
  std::vector<Complex::Point_3> points;
  for (const auto& p : mesh.points)
    points.emplace_back(p.x(), p.y(), p.z());
  dsc.assign(points, mesh.tetrahedra, mesh.labels);
  EXPECT_NEAR(dsc.volume(1), .5, 1e-14);
  small_meshes::Complex reference = small_meshes::make_complex(mesh);
  EXPECT_TRUE(run(dsc) == run(reference));
}
