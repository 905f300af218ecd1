#include "temporary_folder.h"
#include "test.h"
#include "whole_files.h"

#include <CGAL/Mesh_files/File_error.h>
#include <CGAL/Mesh_files/Unused_content.h>
#include <CGAL/Mesh_files/internal/text/files.h>
#include <CGAL/Mesh_files/labeled_surface_3.h>
#include <CGAL/Mesh_files/point_set_3.h>

namespace test_unused_content {

using CGAL::Deformable_simplicial_complexes::File_error;
using CGAL::Deformable_simplicial_complexes::Unused_content;
using whole_files::Encoding;

template <class Read>
std::string unused_of(const Read& read, const std::string& name, const std::string& bytes) {
  const Temporary_folder folder;
  write_bytes(folder / name, bytes);
  Unused_content unused;
  read(folder / name, &unused);
  return unused.text();
}

std::string unused_of_surface(const std::string& name, const std::string& bytes) {
  return unused_of([](const std::string& path,
                      Unused_content* unused) { CGAL::IO::read_labeled_surface(path, 1, unused); },
                   name, bytes);
}

// Returns the points and normals of a file, and its unused content.
std::pair<std::vector<CGAL::IO::Point_and_normal_3>, std::string>
points_of(const std::string& name, const std::string& bytes) {
  std::vector<CGAL::IO::Point_and_normal_3> points;
  std::string unused =
      unused_of([&](const std::string& path,
                    Unused_content* unused) { points = CGAL::IO::read_point_set(path, unused); },
                name, bytes);
  return {points, unused};
}

TEST(Unused_content, of_surfaces_is_the_same_in_text_and_binary) {
  EXPECT_EQ(unused_of_surface("a.off", whole_files::off("", 0, true)), "");
  EXPECT_EQ(unused_of_surface("a.off", whole_files::off("STCN", 9, true)),
            "12 colors and texture coordinates of points, 12 normals of points");
  for (const Encoding encoding : {Encoding::text, Encoding::little_endian, Encoding::big_endian})
    EXPECT_EQ(unused_of_surface("a.ply", whole_files::ply(encoding)),
              "12 colors of points, 1 elements 'note', 8 values 'label' of polygons");
  EXPECT_EQ(unused_of_surface("a.stl", whole_files::stl(true)), "");
  EXPECT_EQ(unused_of_surface("a.stl", whole_files::stl(false)), "");
  EXPECT_EQ(unused_of_surface("a.obj", whole_files::obj()),
            "1 material files, 12 normals, 1 objects, 12 texture coordinates");
}

TEST(Unused_content, of_points_is_what_is_no_coordinate_nor_normal) {
  EXPECT_EQ(points_of("a.xyz", "0 0 0 1 0 0\n1 0 0 0 1 0\n").second, "");
  EXPECT_EQ(points_of("a.xyz", "0 0 0 7\n1 0 0 7\n").second, "2 lines with additional numbers");
  const auto [colored, unused] = points_of("a.xyz", "0 0 0 255 0 0\n1 0 0 0 0 0\n");
  EXPECT_EQ(unused, "2 colors of points");
  EXPECT_EQ(colored[0].second, CGAL::NULL_VECTOR);
  EXPECT_EQ(points_of("a.ply", whole_files::ply(Encoding::text)).second,
            "12 colors of points, 1 elements 'note', 8 polygons, 8 values 'label' of polygons");
}

TEST(Point_set, may_announce_its_points_and_have_normals_behind_all_of_them) {
  const auto points = points_of("a.pwn", "2\n0 0 0\n1 0 0\n0 0 1\n0 1 0\n").first;
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[1].second, CGAL::IO::Point_and_normal_3::second_type(0, 1, 0));
  EXPECT_EQ(points_of("a.pwn", "1\n0 0 0\n").first.size(), 1u);
  EXPECT_THROW(points_of("a.pwn", "3\n0 0 0\n1 0 0\n"), File_error);
  EXPECT_THROW(points_of("a.xyz", "0 0 inf\n"), File_error);
}

TEST(File_contents, have_no_byte_order_mark) {
  namespace internal = CGAL::Deformable_simplicial_complexes::internal;
  const Temporary_folder folder;
  write_bytes(folder / "a.wkt", "\xef\xbb\xbfPOINT");
  EXPECT_EQ(internal::file_contents(folder / "a.wkt"), "POINT");
  EXPECT_THROW(internal::file_contents(folder / "."), File_error);
  write_bytes(folder / "a.wkt", "");
  EXPECT_THROW(internal::file_contents(folder / "a.wkt"), File_error);
}

} // namespace test_unused_content
