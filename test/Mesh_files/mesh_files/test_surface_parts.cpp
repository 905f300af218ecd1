#include "temporary_folder.h"
#include "test.h"

#include <CGAL/Mesh_files/Surface_parts.h>
#include <CGAL/Mesh_files/Unused_content.h>
#include <CGAL/Mesh_files/internal/grids/Vtu_document.h>
#include <CGAL/Mesh_files/internal/grids/Vtu_reader.h>
#include <CGAL/Mesh_files/labeled_surface_3.h>

namespace test_surface_parts {

using CGAL::Deformable_simplicial_complexes::Label_names;
using CGAL::Deformable_simplicial_complexes::Surface_parts;
using CGAL::Deformable_simplicial_complexes::Unused_content;
using Complex = CGAL::Deformable_simplicial_complex_3<>;

constexpr int facets[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}; // of a tetrahedron

// Returns the text of a tetrahedron as OBJ. The number is the number of tetrahedra before it.
std::string obj_tetrahedron(int number) {
  std::ostringstream text;
  const int x = 3 * number, first = 4 * number + 1;
  text << "v " << x << " 0 0\nv " << x + 1 << " 0 0\nv " << x << " 1 0\nv " << x << " 0 1\n";
  for (const auto& f : facets)
    text << "f " << first + f[0] << ' ' << first + f[1] << ' ' << first + f[2] << '\n';
  return text.str();
}

std::string stl_solid(const std::string& name, int number) {
  const int x = 3 * number, points[4][3] = {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}, {x, 0, 1}};
  std::ostringstream text;
  text << "solid " << name << '\n';
  for (const auto& f : facets) {
    text << "facet normal 0 0 0\nouter loop\n";
    for (const int corner : f)
      text << "vertex " << points[corner][0] << ' ' << points[corner][1] << ' ' << points[corner][2]
           << '\n';
    text << "endloop\nendfacet\n";
  }
  return text.str() + "endsolid " + name + '\n';
}

struct Read
{
  std::vector<std::string> names;
  std::vector<std::size_t> triangles; // of the separate surfaces
  std::string unused;

  friend bool operator==(const Read& a, const Read& b) {
    return a.names == b.names && a.triangles == b.triangles && a.unused == b.unused;
  }
  friend std::ostream& operator<<(std::ostream& out, const Read& read) {
    for (const std::string& name : read.names)
      out << '\'' << name << "' ";
    for (const std::size_t n : read.triangles)
      out << n << ' ';
    return out << read.unused;
  }
};

Read read(const std::string& path) {
  Unused_content unused;
  Surface_parts parts;
  const auto surface = CGAL::IO::read_labeled_surface(path, 1, &unused, &parts);
  EXPECT_EQ(parts.of_triangles.size(), surface.triangles.size());
  Read result{parts.names, {}, unused.text()};
  int label = 1;
  for (const auto& part : separate_parts(surface, parts)) {
    result.triangles.push_back(part.triangles.size());
    EXPECT_EQ(part.label, label++);
    for (const auto& triangle : part.triangles)
      for (const std::size_t corner : triangle)
        EXPECT_LT(corner, part.points.size());
  }
  return result;
}

Read parts_of(const std::string& name, const std::string& text) {
  const Temporary_folder folder;
  write_bytes(folder / name, text);
  return read(folder / name);
}

std::string obj(const std::string& head, const std::string& second, const std::string& third = "") {
  return head + obj_tetrahedron(0) + second + obj_tetrahedron(1) + third + obj_tetrahedron(2);
}

TEST(Surface_parts, are_solids_of_STL_text) {
  EXPECT_EQ(parts_of("a.stl", stl_solid("b", 0) + stl_solid("a  c", 1)),
            (Read{{"b", "a c"}, {4, 4}, ""}));
  EXPECT_EQ(parts_of("a.stl", stl_solid("part #1", 0) + stl_solid("part #2", 1)),
            (Read{{"part #1", "part #2"}, {4, 4}, ""}));
  EXPECT_EQ(parts_of("a.stl", stl_solid("a", 0) + stl_solid("b", 1) + stl_solid("a", 2)),
            (Read{{"a", "b"}, {8, 4}, ""}));
  EXPECT_EQ(parts_of("a.stl", stl_solid("", 0) + stl_solid("", 1)), (Read{{""}, {8}, ""}));
  std::string one_line = stl_solid("x y", 0) + stl_solid("z", 1);
  std::replace(one_line.begin(), one_line.end(), '\n', ' ');
  EXPECT_EQ(parts_of("a.stl", one_line).names.front(), "x y");
}

TEST(Surface_parts, are_objects_or_groups_of_OBJ) {
  EXPECT_EQ(parts_of("a.obj", obj("", "", "")), (Read{{""}, {12}, ""}));
  EXPECT_EQ(parts_of("a.obj", obj("o A#1\n", "o part #2\n", "o A#1\n")),
            (Read{{"A#1", "part #2"}, {8, 4}, ""}));
  EXPECT_EQ(parts_of("a.obj", obj("", "g late\n")), (Read{{"", "late"}, {4, 8}, ""}));
  EXPECT_EQ(parts_of("a.obj", obj("o X\ng m1\n", "g m2\n")),
            (Read{{"m1", "m2"}, {4, 8}, "1 objects"}));
  EXPECT_EQ(parts_of("a.obj", obj("o X\ng m1\n", "g m2\n", "o Y\n")),
            (Read{{"X", "Y"}, {8, 4}, "2 groups"}));
}

TEST(Surface_parts, that_close_each_other_are_one_surface) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  for (const auto& f : facets)
    text += "g patch_" + std::to_string(f[2]) + "\nf " + std::to_string(f[0] + 1) + ' ' +
            std::to_string(f[1] + 1) + ' ' + std::to_string(f[2] + 1) + '\n';
  EXPECT_EQ(parts_of("a.obj", text).triangles, std::vector<std::size_t>{4});
  // A hole of a solid is not closed by another solid.
  std::string open = obj_tetrahedron(0);
  open.resize(open.rfind('f'));
  EXPECT_EQ(parts_of("a.obj", "o a\n" + open + "o b\n" + obj_tetrahedron(1)).triangles,
            (std::vector<std::size_t>{3, 4}));
}

TEST(Surface_parts, are_written_with_their_names) {
  CGAL::Deformable_simplicial_complexes::Interface_surface_3<Complex> surface;
  for (const auto& p : {std::array<double, 3>{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}})
    surface.points.emplace_back(p[0], p[1], p[2]);
  // two tetrahedra with a common facet
  surface.triangles = {{0, 2, 1}, {0, 1, 3}, {2, 0, 3}, {1, 2, 3}, {1, 2, 4}, {2, 3, 4}, {3, 1, 4}};
  surface.labels = {{1, 0}, {1, 0}, {1, 0}, {1, 7}, {7, 0}, {7, 0}, {7, 0}};
  const Temporary_folder folder;
  for (const std::string name : {"a.stl", "a.obj"}) {
    CGAL::IO::write_named_interface(folder / name, surface, Label_names{{1, "one # a"}});
    EXPECT_EQ(read(folder / name), (Read{{"one # a", "label 7"}, {4, 4}, ""})) << name;
    CGAL::IO::write_named_interface(folder / name, surface, Label_names());
    EXPECT_EQ(read(folder / name).triangles, std::vector<std::size_t>{7}) << name;
  }
}

TEST(Label_names, are_field_data_of_VTU_files) {
  namespace internal = CGAL::Deformable_simplicial_complexes::internal;
  const Temporary_folder folder;
  const Label_names names = {{-3, "x y"}, {1, "<&\"\xc3\xbc"}, {7, "7"}};
  for (const Label_names& written : {names, Label_names()}) {
    internal::Vtu_document document(0, 0);
    document.label_names(written);
    std::ostringstream text;
    document.write(text);
    write_bytes(folder / "a.vtu", text.str());
    EXPECT_EQ(internal::Vtu_reader(folder / "a.vtu").label_names(), written);
    EXPECT_EQ(internal::Vtu_reader(folder / "a.vtu").number_of_global_arrays(), 0u);
    std::string damaged = text.str();
    if (const std::size_t label = damaged.find(" 7<"); label != damaged.npos)
      damaged.replace(label, 2, " 1");
    write_bytes(folder / "a.vtu", damaged);
    EXPECT_TRUE(internal::Vtu_reader(folder / "a.vtu").label_names().empty());
    EXPECT_EQ(internal::Vtu_reader(folder / "a.vtu").number_of_global_arrays(),
              written.empty() ? 0u : 2u);
  }
}

TEST(Label_names, of_a_file_are_different_and_not_empty) {
  CGAL::Deformable_simplicial_complexes::internal::Label_name_list list;
  for (const auto& [label, name] : Label_names{{1, " a\tb"},
                                               {2, "a  b\n"},
                                               {3, " "},
                                               {4, "a b (3)"},
                                               {5, "a b"},
                                               {6, "a b (2)"},
                                               {7, "A b"}})
    list.add(label, name);
  EXPECT_EQ(list.names, (Label_names{{1, "a b"},
                                     {2, "a b (2)"},
                                     {4, "a b (3)"},
                                     {5, "a b (4)"},
                                     {6, "a b (2) (2)"},
                                     {7, "A b"}}));
}

} // namespace test_surface_parts
