#include "mesh_helpers.h"
#include "temporary_folder.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complex_traits_3.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>
#include <CGAL/Mesh_files/checkpoint.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

// The numbers of this kernel are evaluated lazily, and conversions to double depend on the
// evaluation.
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Complex =
    CGAL::Deformable_simplicial_complex_3<CGAL::Deformable_simplicial_complex_traits_3<Kernel>>;
using Point = Complex::Point_3;
using Vector = Complex::Approximate_vector_3;

const Kernel::FT third = Kernel::FT(1) / 3; // not a double

// A cube of side length 1/3 in a box whose sides have coordinates that are not doubles.
Complex cube_in_thirds() {
  const auto mesh = small_meshes::grid(4, small_meshes::cube);
  std::vector<Point> points;
  for (const auto& p : mesh.points)
    points.emplace_back(third * p.x(), third * p.y(), third * p.z());
  Complex dsc;
  dsc.assign(points, mesh.tetrahedra, mesh.labels);
  return dsc;
}

void evaluate_exactly(const Complex& dsc) {
  for (auto v : dsc.vertices())
    CGAL::exact(v->point());
}

void expect_double_coordinates(const Complex& dsc) {
  for (auto v : dsc.vertices())
    EXPECT_EQ(v->point(), mesh_helpers::exact_point(dsc, dsc.position(v)));
}

Complex::Vertex_handle inner_vertex(const Complex& dsc) {
  for (auto v : dsc.vertices())
    if (!dsc.is_boundary(v))
      return v;
  return {};
}

// Returns a point near v whose coordinates are not doubles.
Point near(const Complex& dsc, Complex::Vertex_handle v) {
  const auto p = dsc.position(v);
  return {p.x() + third / 100, p.y() + third / 70, p.z() + third / 30};
}

} // namespace

TEST(Exact_kernel, evaluation_changes_nothing) {
  const Complex dsc = cube_in_thirds();
  const auto before = dsc.state();
  ASSERT_TRUE(dsc.is_valid());
  evaluate_exactly(dsc);
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_TRUE(dsc.state() == before);
  expect_double_coordinates(dsc);
}

TEST(Exact_kernel, points_are_rounded_wherever_they_come_in) {
  Complex dsc = cube_in_thirds();
  const auto v = inner_vertex(dsc);
  std::vector<Complex::Cell_handle> star;
  dsc.star(v, star);

  ASSERT_EQ(dsc.move_vertex(v, near(dsc, v)), 1);
  expect_double_coordinates(dsc);

  Point q = near(dsc, v);
  ASSERT_TRUE(dsc.is_positive_star(v, star, q));
  dsc.set_point(v, star, q);
  expect_double_coordinates(dsc);

  q = near(dsc, v);
  std::vector<double> measures;
  for (auto c : star)
    measures.push_back(dsc.measure(c));
  const auto qualities = mesh_helpers::qualities_with(dsc, star, {v}, {q});
  dsc.set_points({v}, {q}, star, measures, qualities,
                 [](std::size_t n, const auto& f, std::size_t = 0) {
                   for (std::size_t i = 0; i < n; ++i)
                     f(i);
                 });
  expect_double_coordinates(dsc);

  q = near(dsc, v);
  EXPECT_EQ(dsc.admissible_destination(v, q), dsc.rounded(q));

  Complex::Cavity cavity(dsc);
  for (auto c : star)
    cavity.remove(c);
  const auto moved = cavity.add(v, q);
  for (auto c : star) {
    std::array<Complex::Cavity::Index, 4> t;
    for (int i = 0; i < 4; ++i)
      t[i] = c->vertex(i) == v ? moved : cavity.add(c->vertex(i));
    cavity.create(t, c);
  }
  dsc.replace(cavity);
  EXPECT_EQ(v->point(), dsc.rounded(q));

  const auto c = *dsc.triangulation().finite_cell_handles().begin();
  cavity.clear();
  cavity.remove(c);
  const auto added = cavity.add(CGAL::centroid(c->vertex(0)->point(), c->vertex(1)->point(),
                                               c->vertex(2)->point(), c->vertex(3)->point()),
                                DSC::Boundary_class::inside);
  for (int i = 0; i < 4; ++i) {
    std::array<Complex::Cavity::Index, 4> t = {cavity.add(c->vertex(0)), cavity.add(c->vertex(1)),
                                               cavity.add(c->vertex(2)), cavity.add(c->vertex(3))};
    t[i] = added;
    cavity.create(t, c);
  }
  dsc.replace(cavity);
  expect_double_coordinates(dsc);
  evaluate_exactly(dsc);
  EXPECT_TRUE(dsc.is_valid());
}

TEST(Exact_kernel, tetrahedron_that_rounding_makes_flat_is_refused) {
  const Kernel::FT tiny = Kernel::FT(1) / (1 << 30) / (1 << 30) / (1 << 30);
  const std::vector<Point> points = {
      {0, 0, third}, {1, 0, third}, {0, 1, third}, {1, 1, third + tiny}};
  ASSERT_EQ(CGAL::orientation(points[0], points[1], points[2], points[3]), CGAL::POSITIVE);
  Complex dsc;
  EXPECT_THROW(dsc.assign(points, {{0, 1, 2, 3}}, {0}),
               CGAL::Deformable_simplicial_complexes::Invalid_cells_error);
}

// Steps to destinations that are not doubles, with a checkpoint in between. The domain stays a box.
TEST(Exact_kernel, whole_flow) {
  const Temporary_folder folder;
  Complex dsc = cube_in_thirds();
  const auto step = [](Complex& complex) {
    const auto report = DSC::deform_interface(complex, [&](Complex::Vertex_handle v) {
      const Point& p = v->point();
      return Point(p.x() - third * p.y() / 5, p.y() + third * p.x() / 5, p.z() + third / 20);
    });
    EXPECT_TRUE(report.complete);
    DSC::improve_mesh(complex);
    evaluate_exactly(complex);
    EXPECT_TRUE(complex.is_valid());
    expect_double_coordinates(complex);
  };
  step(dsc);
  const std::string path = folder / "exact.dsc";
  CGAL::IO::write_checkpoint(path, dsc.state());
  Complex restored;
  restored.restore(CGAL::IO::read_checkpoint(path).state);
  for (int i = 0; i < 2; ++i) {
    step(dsc);
    step(restored);
  }
  EXPECT_TRUE(restored.state() == dsc.state());
  const double side = CGAL::to_double(third);
  for (auto v : dsc.vertices())
    for (int axis = 0; axis < 3; ++axis) {
      if (DSC::Boundary_class::fixes(v->boundary_class(), axis)) {
        EXPECT_EQ(CGAL::abs(v->point()[axis]), side);
      }
    }
}
