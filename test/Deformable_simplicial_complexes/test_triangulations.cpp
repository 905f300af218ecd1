#include "mesh_helpers.h"
#include "test.h"

#include <CGAL/Complex_construction/grow_domain.h>
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_2.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>

#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/tetrahedral_remeshing.h>

#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>

// Triangulations that are moved out of a complex, changed by CGAL, and moved in again; data of
// users in the bases of vertices and cells.

namespace {

using small_meshes::Complex;
using small_meshes::grid;
using small_meshes::make_complex;
using Triangulation = Complex::Triangulation;
using Mesh = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;

int three_labels(const small_meshes::Point& p) {
  return small_meshes::ball(p) == 0 ? 0 : p.x() < 0 ? 1 : 2;
}

} // namespace

TEST(Triangulations, sizes_of_simplices) {
  EXPECT_LE(sizeof(Triangulation::Cell), 104u);
  EXPECT_LE(sizeof(Triangulation::Vertex), 64u);
}

TEST(Triangulations, release_numbers_the_patches) {
  Complex dsc = make_complex(grid(6, three_labels));
  const Complex before = dsc;
  for (auto c : dsc.finite_cells())
    for (int i = 0; i < 4; ++i)
      if (!dsc.is_infinite(c->neighbor(i))) {
        EXPECT_EQ(c->is_facet_on_surface(i), dsc.is_interface(Complex::Facet(c, i)));
      }
  Triangulation triangulation = dsc.release();
  EXPECT_EQ(dsc.number_of_cells(), 0u);
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_TRUE(triangulation.is_valid());
  std::map<int, std::size_t> sizes;
  for (const auto& f : triangulation.finite_facets()) {
    const int patch = f.first->surface_patch_index(f.second);
    EXPECT_EQ(patch, triangulation.mirror_facet(f).first->surface_patch_index(
                         triangulation.mirror_facet(f).second));
    ++sizes[patch];
  }
  EXPECT_EQ(sizes[1], before.interface_facets(0, 1).size());
  EXPECT_EQ(sizes[2], before.interface_facets(0, 2).size());
  EXPECT_EQ(sizes[3], before.interface_facets(1, 2).size());
  std::map<int, std::size_t> dimensions;
  for (auto v : triangulation.finite_vertex_handles()) {
    ++dimensions[v->in_dimension()];
    if (v->in_dimension() == 3) {
      EXPECT_EQ(v->index(), v->cell()->subdomain_index());
    }
  }
  EXPECT_EQ(dimensions[1] + dimensions[2], before.interface_vertices().size());
  EXPECT_GT(dimensions[1], 0u);

  Mesh mesh;
  mesh.triangulation().swap(triangulation);
  mesh.rescan_after_load_of_triangulation();
  EXPECT_EQ(mesh.number_of_facets_in_complex(), before.interface_facets().size());
  EXPECT_EQ(mesh.number_of_cells_in_complex(),
            before.number_of_cells(1) + before.number_of_cells(2));
}

TEST(Triangulations, release_and_assign_keep_the_complex) {
  Complex dsc = make_complex(grid(5, three_labels));
  mesh_helpers::jitter(dsc, .1, 7);
  const auto before = dsc.state();
  const auto v = dsc.vertices().back();
  dsc.assign(dsc.release());
  EXPECT_TRUE(dsc.is_valid(true));
  EXPECT_EQ(dsc.vertices().back(), v);
  auto after = dsc.state();
  EXPECT_EQ(after.points, before.points);
  EXPECT_EQ(after.cells, before.cells);
  EXPECT_EQ(after.cell_labels, before.cell_labels);
  EXPECT_EQ(after.boundary_classes, before.boundary_classes);
}

// A flow, a remeshing by CGAL, and the flow again. The sphere is smooth: CGAL 6.2 fails at edges of
// a cube, where normals vanish.
TEST(Triangulations, remeshing_by_cgal_between_steps) {
  Complex dsc = mesh_helpers::sphere(8, .6);
  const auto step = [&] {
    return DSC::deform_interface(dsc, [&](auto v) {
      const auto p = dsc.position(v);
      return p + .1 * (p - CGAL::ORIGIN);
    });
  };
  EXPECT_TRUE(step().complete);
  Triangulation triangulation = dsc.release();
  CGAL::tetrahedral_isotropic_remeshing(triangulation, .3);
  EXPECT_TRUE(triangulation.is_valid());
  // Containers of CGAL compare handles by time stamps.
  std::set<std::size_t> stamps;
  for (auto c : triangulation.all_cell_handles())
    stamps.insert(c->time_stamp());
  EXPECT_EQ(stamps.size(), triangulation.number_of_cells());
  dsc.assign(std::move(triangulation));
  EXPECT_TRUE(dsc.is_valid(true));
  EXPECT_EQ(dsc.euler_characteristic(1), 2);
  EXPECT_TRUE(step().complete);
  EXPECT_TRUE(dsc.is_valid(true));
}

TEST(Triangulations, a_wrong_one_is_refused_and_stays) {
  Complex dsc = make_complex(grid(3, small_meshes::cube));
  const auto before = dsc.state();
  Complex other = make_complex(grid(2, small_meshes::uniform));
  const auto vertices = other.vertices();
  const auto inner = *std::find_if(vertices.begin(), vertices.end(),
                                   [&](auto v) { return !other.is_boundary(v); });
  Triangulation triangulation = other.release();
  const auto right = inner->point();
  for (const auto& wrong : {Complex::Point_3(7, 0, 0),
                            Complex::Point_3(0, 0, std::numeric_limits<double>::infinity())}) {
    inner->set_point(wrong);
    EXPECT_THROW(dsc.assign(std::move(triangulation)), DSC::Invalid_cells_error);
    EXPECT_TRUE(dsc.state() == before);
    EXPECT_EQ(triangulation.number_of_vertices(), 27u);
  }
  inner->set_point(right);
  dsc.assign(std::move(triangulation));
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_THROW(dsc.assign(Triangulation()), DSC::Invalid_cells_error);
}

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Marked_3 = CGAL::Deformable_simplicial_complex_3<
    Kernel, CGAL::Triangulation_data_structure_3<
                CGAL::Deformable_simplicial_complex_vertex_base_3<
                    Kernel, CGAL::Triangulation_vertex_base_with_info_3<std::string, Kernel>>,
                CGAL::Deformable_simplicial_complex_cell_base_3<
                    Kernel, CGAL::Triangulation_cell_base_with_info_3<std::string, Kernel>>>>;
// The bases in the other order.
using Marked_2 = CGAL::Deformable_simplicial_complex_2<
    Kernel, CGAL::Triangulation_data_structure_2<
                CGAL::Triangulation_vertex_base_with_info_2<
                    std::string, Kernel, CGAL::Deformable_simplicial_complex_vertex_base_2<Kernel>>,
                CGAL::Triangulation_face_base_with_info_2<
                    std::string, Kernel, CGAL::Deformable_simplicial_complex_face_base_2<Kernel>>>>;

template <class Point> std::string name(const Point& p) {
  std::ostringstream text;
  text << p;
  return text.str();
}
// The name of a simplex by the names of its vertices.
template <class Complex> std::string name_of(typename Complex::Cell_handle c) {
  std::set<std::string> names;
  for (int i = 0; i <= Complex::dimension; ++i)
    names.insert(name(c->vertex(i)->point()));
  std::string result;
  for (const std::string& part : names)
    result += part + ';';
  return result;
}
template <class Complex> void give_names(Complex& dsc) {
  for (auto v : dsc.vertices())
    v->info() = name(v->point());
  for (auto c : dsc.cells())
    c->info() = name_of<Complex>(c);
}

// The vertices of the interface stay where they are, and some cells beside it are not improved.
template <class Complex> void expect_data_in_grown_domain(Complex& dsc) {
  give_names(dsc);
  std::set<std::string> names = {""};
  for (auto c : dsc.cells())
    names.insert(c->info());
  const std::size_t vertices = dsc.number_of_vertices();
  DSC::grow_domain(dsc);
  ASSERT_TRUE(dsc.is_valid(true));
  EXPECT_GT(dsc.number_of_vertices(), vertices);
  for (auto v : dsc.interface_vertices())
    EXPECT_EQ(v->info(), name(v->point()));
  std::size_t old = 0, made = 0;
  for (auto c : dsc.cells()) {
    const auto known = names.find(name_of<Complex>(c));
    EXPECT_EQ(names.count(c->info()), 1u);
    old += known != names.end() && c->info() == *known;
    made += c->info().empty();
  }
  EXPECT_GT(old, 0u);
  EXPECT_GT(made, 0u);
}

} // namespace

TEST(Triangulations, data_of_users_stay_in_a_grown_domain) {
  const auto mesh = grid(6, small_meshes::ball);
  Marked_3 in_space;
  in_space.assign(mesh.points, mesh.tetrahedra, mesh.labels);
  expect_data_in_grown_domain(in_space);
  auto in_plane = DSC::make_deformable_simplicial_complex_2<Marked_2>(
      CGAL::Bbox_2(0, 0, 4, 4), .5,
      [](const auto& p) { return std::hypot(p.x() - 2, p.y() - 2) < 1.2 ? 1 : 0; });
  expect_data_in_grown_domain(in_plane);
}

// Copies and sorted complexes have the data that users put into vertices and cells; operations keep
// them where vertices and cells stay.
TEST(Triangulations, data_of_users) {
  const auto mesh = grid(4, small_meshes::ball);
  Marked_3 dsc;
  dsc.assign(mesh.points, mesh.tetrahedra, mesh.labels);
  mesh_helpers::jitter(dsc, .3, 1);
  give_names(dsc);
  const auto expect_names = [&](const Marked_3& complex) {
    EXPECT_TRUE(complex.is_valid(true));
    for (auto v : complex.vertices())
      EXPECT_EQ(v->info(), name(v->point()));
    for (auto c : complex.cells())
      EXPECT_EQ(c->info(), name_of<Marked_3>(c));
  };
  const Marked_3 copy = dsc;
  expect_names(copy);
  EXPECT_TRUE(copy.state() == dsc.state());
  dsc.sort_storage();
  expect_names(dsc);
  dsc.assign(dsc.release());
  expect_names(dsc);

  std::map<std::size_t, std::string> names; // by time stamp
  for (auto c : dsc.cells())
    names[c->time_stamp()] = c->info();
  DSC::improve_mesh(dsc, parameters::quality_threshold(.7));
  std::size_t kept = 0;
  for (auto c : dsc.cells()) {
    const auto known = names.find(c->time_stamp());
    kept += known != names.end();
    EXPECT_EQ(c->info(), known == names.end() ? "" : known->second);
  }
  EXPECT_GT(kept, 0u);
  EXPECT_LT(kept, dsc.number_of_cells());
}
