#include "surface_measures.h"
#include "temporary_folder.h"
#include "test.h"

#include <CGAL/Interface_remeshing/extract_interface_3.h>
#include <CGAL/Mesh_files/File_error.h>
#include <CGAL/Mesh_files/labeled_surface_3.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Surface_mesh.h>

// Extraction of interfaces as surfaces in memory and in files.

namespace test_extraction {

using CGAL::Deformable_simplicial_complexes::File_error;
using small_meshes::grid;
using small_meshes::make_complex;
using small_meshes::Point;
using namespace surface_measures;
using Mesh = CGAL::Surface_mesh<Point>;
namespace PMP = CGAL::Polygon_mesh_processing;

// Extraction

TEST(Extract_interface, of_a_cube) {
  const Complex dsc = make_complex(grid(4, small_meshes::cube));
  const auto surface = DSC::extract_interface(dsc);
  EXPECT_EQ(surface.points.size(), 26u);
  EXPECT_EQ(surface.triangles.size(), 48u);
  EXPECT_EQ(surface.vertices, dsc.interface_vertices());
  const Measures m = measures(surface);
  EXPECT_NEAR(m.area, 6, tolerance);
  EXPECT_NEAR(m.volume, 1, tolerance); // positive: the normals point out of label 1
  EXPECT_EQ(m.euler_characteristic, 2);
  for (const auto& labels : surface.labels)
    EXPECT_EQ(labels, (std::array<int, 2>{1, 0}));
}

TEST(Extract_interface, points_out_of_the_first_label_of_a_pair) {
  const Complex dsc = make_complex(grid(4, small_meshes::cube));
  const auto from_cube = DSC::extract_interface(dsc, 1, 0);
  const auto into_cube = DSC::extract_interface(dsc, 0, 1);
  EXPECT_EQ(from_cube.triangles, DSC::extract_interface(dsc).triangles);
  EXPECT_NEAR(measures(from_cube).volume, 1, tolerance);
  EXPECT_NEAR(measures(into_cube).volume, -1, tolerance);
  EXPECT_EQ(into_cube.labels.at(0), (std::array<int, 2>{0, 1}));
}

TEST(Extract_interface, is_in_user_coordinates) {
  Complex dsc = make_complex(grid(4, small_meshes::cube));
  dsc.set_normalization({Complex::Vector_3(10, 20, 30), 2});
  const auto surface = DSC::extract_interface(dsc);
  EXPECT_NEAR(measures(surface).area, 24, tolerance);
  for (std::size_t i = 0; i < surface.points.size(); ++i)
    EXPECT_EQ(surface.points[i], dsc.user_position(surface.vertices[i]));
  const auto box = CGAL::bbox_3(surface.points.begin(), surface.points.end());
  EXPECT_EQ(box, CGAL::Bbox_3(9, 19, 29, 11, 21, 31));
}

TEST(Extract_interface, of_pairs_of_several_labels) {
  const Complex boxes = make_complex(grid(4, small_meshes::two_boxes));
  EXPECT_NEAR(measures(DSC::extract_interface(boxes)).area, 7, tolerance);
  EXPECT_NEAR(measures(DSC::extract_interface(boxes, 1, 2)).area, 1, tolerance);
  EXPECT_NEAR(measures(DSC::extract_interface(boxes, 0, 2)).area, 3, tolerance);
  const auto middle = DSC::extract_interface(boxes, 1, 2);
  for (const auto& t : middle.triangles)
    EXPECT_GT(CGAL::normal(middle.points[t[0]], middle.points[t[1]], middle.points[t[2]]).x(), 0);

  const Complex phases = make_complex(grid(4, small_meshes::four_phases));
  EXPECT_NEAR(measures(DSC::extract_interface(phases)).area, 8, tolerance);
  EXPECT_NEAR(measures(DSC::extract_interface(phases, 3, 1)).area, 2, tolerance);
  EXPECT_TRUE(DSC::extract_interface(phases, 0, 3).triangles.empty());
}

TEST(Extract_interface, of_two_balls) {
  const Complex dsc = make_complex(grid(16, small_meshes::two_balls));
  const Measures m = measures(DSC::extract_interface(dsc));
  EXPECT_NEAR(m.volume, dsc.volume(1), tolerance);
  EXPECT_NEAR(m.area, dsc.area(1), tolerance);
  EXPECT_EQ(m.euler_characteristic, dsc.euler_characteristic(1));
}

TEST(Extract_interface, of_one_label_is_empty) {
  const Complex dsc = make_complex(grid(2, small_meshes::uniform));
  EXPECT_TRUE(DSC::extract_interface(dsc).points.empty());
  Mesh mesh;
  DSC::interface_to_surface_mesh(DSC::extract_interface(dsc), mesh);
  EXPECT_TRUE(mesh.is_empty());
}

TEST(Interface_to_surface_mesh, is_closed_and_outward_for_a_cube) {
  const Complex dsc = make_complex(grid(4, small_meshes::cube));
  Mesh mesh;
  DSC::interface_to_surface_mesh(DSC::extract_interface(dsc), mesh);
  EXPECT_TRUE(mesh.is_valid());
  ASSERT_TRUE(CGAL::is_closed(mesh));
  EXPECT_TRUE(PMP::is_outward_oriented(mesh));
  EXPECT_NEAR(PMP::volume(mesh), 1, tolerance);
}

TEST(Interface_to_surface_mesh, is_cut_open_along_triple_lines) {
  const Complex dsc = make_complex(grid(4, small_meshes::four_phases));
  const auto surface = DSC::extract_interface(dsc);
  Mesh mesh;
  DSC::interface_to_surface_mesh(surface, mesh);
  EXPECT_TRUE(mesh.is_valid());
  ASSERT_EQ(mesh.number_of_faces(), surface.triangles.size());
  // The line where the four half planes meet has five vertices.
  EXPECT_EQ(mesh.number_of_vertices(), surface.points.size() + 3 * 5);
  for (const auto face : mesh.faces()) {
    const auto& t = surface.triangles[face.idx()];
    const auto normal =
        CGAL::normal(surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]);
    const auto n = PMP::compute_face_normal(face, mesh);
    EXPECT_GT(n.x() * normal.x() + n.y() * normal.y() + n.z() * normal.z(), 0);
  }
}

// Surfaces

TEST(Labeled_surface, of_a_written_interface_is_the_interface) {
  const Temporary_folder folder;
  const Complex dsc = complex_with_long_coordinates(small_meshes::cube);
  const auto surface = DSC::extract_interface(dsc);
  for (const std::string extension : {"off", "obj", "ply", "stl", "OFF"}) {
    const std::string path = folder / ("a." + extension);
    CGAL::IO::write_interface(path, dsc);
    const auto read = CGAL::IO::read_labeled_surface(path, 5);
    EXPECT_EQ(read.label, 5);
    EXPECT_EQ(read.points.size(), surface.points.size()) << extension;
    ASSERT_EQ(read.triangles.size(), surface.triangles.size()) << extension;
    for (std::size_t i = 0; i < surface.triangles.size(); ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const auto p = surface.points[surface.triangles[i][j]];
        EXPECT_EQ(read.points[read.triangles[i][j]], Point(p.x(), p.y(), p.z())) << extension;
      }
  }
  EXPECT_EQ(folder.number_of_files(), 5);
}

TEST(Labeled_surface, of_a_pair_is_written) {
  const Temporary_folder folder;
  const Complex dsc = make_complex(grid(4, small_meshes::two_boxes));
  CGAL::IO::write_interface(folder / "a.off", dsc, 2, 1);
  EXPECT_NEAR(measures(CGAL::IO::read_labeled_surface(folder / "a.off")).area, 1, tolerance);
}

TEST(Labeled_surface, polygons_are_triangulated) {
  const Temporary_folder folder;
  // a prism of height 1 over the L-shaped hexagon of area 3
  write_bytes(folder / "a.off", "OFF\n12 8 0\n"
                                "0 0 0\n2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n"
                                "0 0 1\n2 0 1\n2 1 1\n1 1 1\n1 2 1\n0 2 1\n"
                                "6 5 4 3 2 1 0\n6 6 7 8 9 10 11\n"
                                "4 0 1 7 6\n4 1 2 8 7\n4 2 3 9 8\n4 3 4 10 9\n4 4 5 11 10\n"
                                "4 5 0 6 11\n");
  const auto surface = CGAL::IO::read_labeled_surface(folder / "a.off");
  EXPECT_EQ(surface.label, 1);
  EXPECT_EQ(surface.triangles.size(), 20u);
  const Measures m = measures(surface);
  EXPECT_NEAR(m.volume, 3, tolerance);
  EXPECT_NEAR(m.area, 14, tolerance);
  EXPECT_EQ(m.euler_characteristic, 2);
}

TEST(Labeled_surface, polygons_of_any_size_are_triangulated) {
  const Temporary_folder folder;
  for (const std::string e : {"-200", "-9", "0", "9", "200"}) {
    const std::string one = "1e" + e;
    write_bytes(folder / "a.off", "OFF\n5 1 0\n0 0 0\n" + one + " 0 0\n" + one + " " + one +
                                      " 0\n0 " + one + " 0\n0 0.5e" + e + " 0\n5 0 1 2 3 4\n");
    EXPECT_EQ(CGAL::IO::read_labeled_surface(folder / "a.off").triangles.size(), 3u) << one;
  }
}

TEST(Labeled_surface, bad_files_are_refused) {
  const Temporary_folder folder;
  const std::string points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  write_bytes(folder / "text.off", "this is no surface");
  write_bytes(folder / "truncated.off", "OFF\n4 1 0\n" + points);
  write_bytes(folder / "index.off", "OFF\n4 1 0\n" + points + "3 0 1 7\n");
  write_bytes(folder / "segment.off", "OFF\n4 1 0\n" + points + "2 0 1\n");
  write_bytes(folder / "flat.off", "OFF\n4 1 0\n" + points + "5 0 0 1 1 0\n");
  write_bytes(folder / "overflow.off",
              "OFF\n4 1 0\n-1e308 0 0\n1e308 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
  write_bytes(folder / "empty.stl", "");
  write_bytes(folder / "cut.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n");
  write_bytes(folder / "cut.ply", "ply\nformat ascii 1.0\nelement vertex 3\n");
  write_bytes(folder / "points.obj", "v 0 0 0\nv 1 0 0\n");
  write_bytes(folder / "surface.xyz", points);
  for (const char* name :
       {"text.off", "truncated.off", "index.off", "segment.off", "flat.off", "overflow.off",
        "empty.stl", "cut.stl", "cut.ply", "points.obj", "surface.xyz", "missing.off", "missing"})
    EXPECT_THROW(CGAL::IO::read_labeled_surface(folder / name), File_error) << name;
}

} // namespace test_extraction
