// CAD surfaces, whose triangles have small angles, in rigid motion.

#include "test.h"

#include <CGAL/Complex_construction/Construction_options.h>
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/interface_flows_3.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>

#include <CGAL/Bbox_3.h>

namespace test_needles {

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Point = Complex::Point_3;
using Report = DSC::Deformation_report<Complex>;
using Surface = DSC::Labeled_surface_3<Point>;

// A prism over a regular polygon. Its ends are fans about a vertex: all angles there are 180 / n
// degrees or close to 180 degrees.
Complex drum(std::size_t n, double height) {
  Surface s;
  for (double z : {-height / 2, height / 2})
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = 2 * CGAL_PI * double(i) / double(n);
      s.points.emplace_back(std::cos(angle), std::sin(angle), z);
    }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    s.triangles.push_back({i, j, n + j});
    s.triangles.push_back({i, n + j, n + i});
  }
  for (std::size_t i = 1; i + 1 < n; ++i) {
    s.triangles.push_back({0, i + 1, i});
    s.triangles.push_back({n, n + i, n + i + 1});
  }
  s.label = 1;
  return DSC::make_deformable_simplicial_complex_3<Complex>(std::vector<Surface>{s},
                                                            CGAL::Tetgen_tetrahedralizer_3());
}

// Returns triangles as time stamps of vertices, which do not depend on positions.
std::vector<std::array<std::size_t, 3>> interface_triangles(const Complex& dsc) {
  std::vector<std::array<std::size_t, 3>> result;
  for (const auto& f : dsc.interface_facets()) {
    const auto v = dsc.facet_vertices(f);
    result.push_back({v[0]->time_stamp(), v[1]->time_stamp(), v[2]->time_stamp()});
    std::sort(result.back().begin(), result.back().end());
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<Report> turn(Complex& dsc, int steps) {
  const DSC::Rigid_rotation_3 rotation({0, 0, 0}, {0, 0, 1}, CGAL_PI / 90);
  std::vector<Report> result;
  for (int step = 0; step < steps; ++step) {
    result.push_back(DSC::advect_interface(dsc, rotation, double(step), 1.));
    EXPECT_TRUE(result.back().complete);
  }
  EXPECT_TRUE(dsc.is_valid(true));
  return result;
}

// The cells between the ends are as thin as the drum; they must not change the interface.
TEST(Needles, keep_their_triangles_in_a_rigid_motion) {
  Complex dsc = drum(64, .06);
  const auto triangles = interface_triangles(dsc);
  const double volume = dsc.volume(1);
  turn(dsc, 20);
  EXPECT_EQ(interface_triangles(dsc), triangles);
  EXPECT_NEAR(dsc.volume(1), volume, 1e-12 * volume);
}

// Free vertices and edges at the sides of the domain were in the way, and vertices that moved one
// by one changed the shape of the box.
TEST(Boxes_of_twelve_triangles, are_turned_exactly_by_any_angle) {
  Surface box;
  for (double z : {0., 4.726324897624818})
    for (const auto& [x, y] :
         {std::pair(0., 0.), std::pair(9.423012542407854, 0.),
          std::pair(9.423012542407854, 13.723331000548068), std::pair(0., 13.723331000548068)})
      box.points.emplace_back(x, y, z);
  box.triangles = {{1, 0, 3}, {3, 2, 1}, {7, 4, 5}, {5, 6, 7}, {0, 1, 5}, {0, 5, 4},
                   {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
  box.label = 1;
  DSC::Construction_options<3> options;
  options.thin_parts.edge_per_thickness = 0;
  const Complex start = DSC::make_deformable_simplicial_complex_3<Complex>(
      std::vector<Surface>{box}, CGAL::Tetgen_tetrahedralizer_3(), options);
  const auto triangles = interface_triangles(start);
  CGAL::Bbox_3 domain;
  for (auto v : start.finite_vertices())
    domain += start.position(v).bbox();
  const Complex::Point_3 center((domain.xmin() + domain.xmax()) / 2,
                                (domain.ymin() + domain.ymax()) / 2,
                                (domain.zmin() + domain.zmax()) / 2);
  for (double degrees : {90., 200., 260., 270., 272., 275., 300., 1000.}) {
    Complex dsc = start;
    const DSC::Rigid_rotation_3 rotation(center, {1, 2, 3}, degrees * CGAL_PI / 180);
    EXPECT_TRUE(DSC::advect_interface(dsc, rotation, 0, 1).complete) << degrees;
    EXPECT_EQ(interface_triangles(dsc), triangles) << degrees;
    EXPECT_NEAR(dsc.volume(1), start.volume(1), 1e-12 * start.volume(1)) << degrees;
  }
}

// Cells at needles cannot be improved. After the first step, remeshing works only where the mesh is
// sheared.
TEST(Needles, are_not_tried_again_in_each_step) {
  Complex dsc = drum(48, 4);
  const auto reports = turn(dsc, 5);
  for (std::size_t step = 1; step < reports.size(); ++step)
    EXPECT_LT(reports[step].smoothed + reports[step].flipped, dsc.number_of_cells() / 8);
}

} // namespace test_needles
