#include "small_meshes.h"
#include "temporary_folder.h"

#include <CGAL/Deformable_simplicial_complex_3/exceptions.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/files.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/little_endian.h>
#include <CGAL/IO/MEDIT_3.h>
#include <CGAL/IO/PVD_series.h>
#include <CGAL/IO/VTU_3.h>
#include <CGAL/IO/labelled_surface_3.h>
#include <CGAL/extract_interface_3.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iomanip>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using CGAL::Deformable_simplicial_complexes::File_error;
using small_meshes::Complex;
using small_meshes::grid;
using small_meshes::make_complex;
using small_meshes::Point;
using Mesh = CGAL::Surface_mesh<Point>;
using Tetrahedra = std::vector<std::array<std::size_t, 4>>;
namespace internal = CGAL::Deformable_simplicial_complexes::internal;
namespace PMP = CGAL::Polygon_mesh_processing;

// Coordinates that show where digits get lost.
void set_awkward_normalization(Complex& dsc) {
  dsc.set_normalization({Complex::Approximate_vector_3(0.1, -100, 1e-7), 1. / 3});
}

struct Measures
{
  double area = 0;
  double volume = 0; // behind the triangles, if they are closed
  long euler_characteristic = 0;
};

template <class Points, class Triangles>
Measures measures(const Points& points, const Triangles& triangles) {
  Measures result;
  std::map<std::pair<std::size_t, std::size_t>, int> edges;
  for (const auto& t : triangles) {
    const auto p = points[t[0]] - CGAL::ORIGIN, q = points[t[1]] - CGAL::ORIGIN,
               r = points[t[2]] - CGAL::ORIGIN;
    result.area += std::sqrt(CGAL::cross_product(q - p, r - p).squared_length()) / 2;
    result.volume += CGAL::cross_product(p, q) * r / 6;
    for (int i = 0; i < 3; ++i)
      ++edges[std::minmax(t[i], t[(i + 1) % 3])];
  }
  result.euler_characteristic = long(points.size()) - long(edges.size()) + long(triangles.size());
  return result;
}

template <class Surface> Measures measures(const Surface& surface) {
  return measures(surface.points, surface.triangles);
}

constexpr double tolerance = 1e-12;

} // namespace

// Extraction

TEST(Extract_interface, of_a_cube) {
  const Complex dsc = make_complex(grid(4, small_meshes::cube));
  const auto surface = CGAL::extract_interface(dsc);
  EXPECT_EQ(surface.points.size(), 26u);
  EXPECT_EQ(surface.triangles.size(), 48u);
  EXPECT_EQ(surface.vertices, dsc.interface_vertices());
  const Measures m = measures(surface);
  EXPECT_NEAR(m.area, 6, tolerance);
  EXPECT_NEAR(m.volume, 1, tolerance); // positive: normals out of label 1
  EXPECT_EQ(m.euler_characteristic, 2);
  for (const auto& labels : surface.labels)
    EXPECT_EQ(labels, (std::array<int, 2>{1, 0}));
}

TEST(Extract_interface, points_out_of_the_first_label_of_a_pair) {
  const Complex dsc = make_complex(grid(4, small_meshes::cube));
  const auto from_cube = CGAL::extract_interface(dsc, 1, 0);
  const auto into_cube = CGAL::extract_interface(dsc, 0, 1);
  EXPECT_EQ(from_cube.triangles, CGAL::extract_interface(dsc).triangles);
  EXPECT_NEAR(measures(from_cube).volume, 1, tolerance);
  EXPECT_NEAR(measures(into_cube).volume, -1, tolerance);
  EXPECT_EQ(into_cube.labels.at(0), (std::array<int, 2>{0, 1}));
}

TEST(Extract_interface, is_in_user_coordinates) {
  Complex dsc = make_complex(grid(4, small_meshes::cube));
  dsc.set_normalization({Complex::Approximate_vector_3(10, 20, 30), 2});
  const auto surface = CGAL::extract_interface(dsc);
  EXPECT_NEAR(measures(surface).area, 24, tolerance);
  for (std::size_t i = 0; i < surface.points.size(); ++i)
    EXPECT_EQ(surface.points[i], dsc.user_position(surface.vertices[i]));
  const auto box = CGAL::bbox_3(surface.points.begin(), surface.points.end());
  EXPECT_EQ(box, CGAL::Bbox_3(9, 19, 29, 11, 21, 31));
}

TEST(Extract_interface, of_pairs_of_several_labels) {
  const Complex boxes = make_complex(grid(4, small_meshes::two_boxes));
  EXPECT_NEAR(measures(CGAL::extract_interface(boxes)).area, 7, tolerance);
  EXPECT_NEAR(measures(CGAL::extract_interface(boxes, 1, 2)).area, 1, tolerance);
  EXPECT_NEAR(measures(CGAL::extract_interface(boxes, 0, 2)).area, 3, tolerance);
  const auto middle = CGAL::extract_interface(boxes, 1, 2);
  for (const auto& t : middle.triangles)
    EXPECT_GT(CGAL::normal(middle.points[t[0]], middle.points[t[1]], middle.points[t[2]]).x(), 0);

  const Complex phases = make_complex(grid(4, small_meshes::four_phases));
  EXPECT_NEAR(measures(CGAL::extract_interface(phases)).area, 8, tolerance);
  EXPECT_NEAR(measures(CGAL::extract_interface(phases, 3, 1)).area, 2, tolerance);
  EXPECT_TRUE(CGAL::extract_interface(phases, 0, 3).triangles.empty());
}

TEST(Extract_interface, of_two_balls) {
  const Complex dsc = make_complex(grid(16, small_meshes::two_balls));
  const Measures m = measures(CGAL::extract_interface(dsc));
  EXPECT_NEAR(m.volume, dsc.volume(1), tolerance);
  EXPECT_NEAR(m.area, dsc.area(1), tolerance);
  EXPECT_EQ(m.euler_characteristic, dsc.euler_characteristic(1));
}

TEST(Extract_interface, of_one_label_is_empty) {
  const Complex dsc = make_complex(grid(2, small_meshes::uniform));
  EXPECT_TRUE(CGAL::extract_interface(dsc).points.empty());
  Mesh mesh;
  CGAL::interface_to_surface_mesh(CGAL::extract_interface(dsc), mesh);
  EXPECT_TRUE(mesh.is_empty());
}

TEST(Interface_to_surface_mesh, is_closed_and_outward_for_a_cube) {
  const Complex dsc = make_complex(grid(4, small_meshes::cube));
  Mesh mesh;
  CGAL::interface_to_surface_mesh(CGAL::extract_interface(dsc), mesh);
  EXPECT_TRUE(mesh.is_valid());
  ASSERT_TRUE(CGAL::is_closed(mesh));
  EXPECT_TRUE(PMP::is_outward_oriented(mesh));
  EXPECT_NEAR(PMP::volume(mesh), 1, tolerance);
}

TEST(Interface_to_surface_mesh, is_cut_open_along_triple_lines) {
  const Complex dsc = make_complex(grid(4, small_meshes::four_phases));
  const auto surface = CGAL::extract_interface(dsc);
  Mesh mesh;
  CGAL::interface_to_surface_mesh(surface, mesh);
  EXPECT_TRUE(mesh.is_valid());
  ASSERT_EQ(mesh.number_of_faces(), surface.triangles.size());
  // The line in which the four half planes meet has five vertices.
  EXPECT_EQ(mesh.number_of_vertices(), surface.points.size() + 3 * 5);
  for (const auto face : mesh.faces()) {
    const auto& t = surface.triangles[face.idx()];
    const auto normal =
        CGAL::normal(surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]);
    const auto n = PMP::compute_face_normal(face, mesh);
    EXPECT_GT(n.x() * normal.x() + n.y() * normal.y() + n.z() * normal.z(), 0);
  }
}

// VTU

namespace {

// A VTU file, taken apart without VTK.
struct Vtu
{
  struct Array
  {
    std::string section, type;
    std::size_t components;
    std::string bytes;

    template <class Number> std::vector<Number> values() const {
      std::vector<Number> result;
      for (std::size_t i = 0; i + sizeof(Number) <= bytes.size(); i += sizeof(Number))
        result.push_back(internal::little_endian<Number>(bytes.data() + i));
      return result;
    }
  };

  explicit Vtu(const std::string& path) {
    const std::string file = file_bytes(path), begin = "<AppendedData encoding=\"raw\">\n_",
                      end = "\n  </AppendedData>\n</VTKFile>\n";
    const std::size_t data_begin = file.find(begin) + begin.size(),
                      data_end = file.size() - end.size();
    EXPECT_EQ(file.substr(data_end), end);
    std::istringstream xml(file.substr(0, data_begin) + end);
    boost::property_tree::ptree tree;
    boost::property_tree::read_xml(xml, tree);
    EXPECT_EQ(tree.get<std::string>("VTKFile.<xmlattr>.type"), "UnstructuredGrid");
    EXPECT_EQ(tree.get<std::string>("VTKFile.<xmlattr>.byte_order"), "LittleEndian");
    EXPECT_EQ(tree.get<std::string>("VTKFile.<xmlattr>.header_type"), "UInt64");
    const auto& piece = tree.get_child("VTKFile.UnstructuredGrid.Piece");
    number_of_points = piece.get<std::size_t>("<xmlattr>.NumberOfPoints");
    number_of_cells = piece.get<std::size_t>("<xmlattr>.NumberOfCells");
    std::size_t position = data_begin;
    for (const auto& section : piece)
      for (const auto& array : section.second)
        if (array.first == "DataArray") {
          EXPECT_EQ(array.second.get<std::string>("<xmlattr>.format"), "appended");
          EXPECT_EQ(array.second.get<std::size_t>("<xmlattr>.offset"), position - data_begin);
          const auto size = internal::little_endian<std::uint64_t>(file.data() + position);
          EXPECT_LE(size, data_end - position - 8);
          arrays[array.second.get<std::string>("<xmlattr>.Name")] = {
              section.first, array.second.get<std::string>("<xmlattr>.type"),
              array.second.get<std::size_t>("<xmlattr>.NumberOfComponents"),
              file.substr(position + 8, size)};
          position += 8 + size;
        }
    EXPECT_EQ(position, data_end);
  }

  // Whether an array is there and has this many bytes.
  bool has(const std::string& name, const std::string& section, const std::string& type,
           std::size_t components, std::size_t size) const {
    const auto i = arrays.find(name);
    return i != arrays.end() && i->second.section == section && i->second.type == type &&
           i->second.components == components && i->second.bytes.size() == size;
  }

  std::size_t number_of_points, number_of_cells;
  std::map<std::string, Array> arrays;
};

} // namespace

TEST(Vtu, of_the_volume_has_all_arrays) {
  const Temporary_folder folder;
  Complex dsc = make_complex(grid(4, small_meshes::two_boxes));
  set_awkward_normalization(dsc);
  CGAL::IO::write_VTU(folder / "a.vtu", dsc);
  EXPECT_EQ(folder.number_of_files(), 1);

  Vtu vtu(folder / "a.vtu");
  const std::size_t n = 125, m = 384;
  EXPECT_EQ(vtu.number_of_points, n);
  EXPECT_EQ(vtu.number_of_cells, m);
  EXPECT_EQ(vtu.arrays.size(), 8u);
  EXPECT_TRUE(vtu.has("boundary_class", "PointData", "UInt8", 1, n));
  EXPECT_TRUE(vtu.has("interface", "PointData", "UInt8", 1, n));
  EXPECT_TRUE(vtu.has("label", "CellData", "Int32", 1, 4 * m));
  EXPECT_TRUE(vtu.has("quality", "CellData", "Float64", 1, 8 * m));
  EXPECT_TRUE(vtu.has("points", "Points", "Float64", 3, 24 * n));
  EXPECT_TRUE(vtu.has("connectivity", "Cells", "Int64", 1, 32 * m));
  EXPECT_TRUE(vtu.has("offsets", "Cells", "Int64", 1, 8 * m));
  EXPECT_TRUE(vtu.has("types", "Cells", "UInt8", 1, m));

  const auto coordinates = vtu.arrays["points"].values<double>();
  const auto interface_flags = vtu.arrays["interface"].values<std::uint8_t>();
  const auto vertices = dsc.vertices();
  for (std::size_t i = 0; i < n; ++i) {
    const auto p = dsc.user_position(vertices[i]);
    EXPECT_EQ(coordinates[3 * i], p.x());
    EXPECT_EQ(coordinates[3 * i + 1], p.y());
    EXPECT_EQ(coordinates[3 * i + 2], p.z());
    EXPECT_EQ(interface_flags[i] != 0, dsc.is_interface(vertices[i]));
  }
  const auto connectivity = vtu.arrays["connectivity"].values<std::int64_t>();
  const auto offsets = vtu.arrays["offsets"].values<std::int64_t>();
  const auto labels = vtu.arrays["label"].values<std::int32_t>();
  const auto qualities = vtu.arrays["quality"].values<double>();
  const auto types = vtu.arrays["types"].values<std::uint8_t>();
  const auto cells = dsc.cells();
  for (std::size_t i = 0; i < m; ++i) {
    for (int j = 0; j < 4; ++j)
      EXPECT_EQ(vertices.at(std::size_t(connectivity[4 * i + j])), cells[i]->vertex(j));
    EXPECT_EQ(offsets[i], std::int64_t(4 * (i + 1)));
    EXPECT_EQ(types[i], 10);
    EXPECT_EQ(labels[i], dsc.label(cells[i]));
    EXPECT_EQ(qualities[i], dsc.quality(cells[i]));
  }
}

TEST(Vtu, of_the_interface_has_all_arrays) {
  const Temporary_folder folder;
  const Complex dsc = make_complex(grid(4, small_meshes::two_boxes));
  CGAL::IO::write_interface_VTU(folder / "a.vtu", dsc);
  const auto surface = CGAL::extract_interface(dsc);
  Vtu vtu(folder / "a.vtu");
  const std::size_t n = surface.points.size(), m = surface.triangles.size();
  EXPECT_EQ(vtu.number_of_points, n);
  EXPECT_EQ(vtu.number_of_cells, m);
  EXPECT_EQ(vtu.arrays.size(), 5u);
  EXPECT_TRUE(vtu.has("label_pair", "CellData", "Int32", 2, 8 * m));
  EXPECT_TRUE(vtu.has("points", "Points", "Float64", 3, 24 * n));
  EXPECT_TRUE(vtu.has("connectivity", "Cells", "Int64", 1, 24 * m));
  EXPECT_TRUE(vtu.has("offsets", "Cells", "Int64", 1, 8 * m));
  EXPECT_TRUE(vtu.has("types", "Cells", "UInt8", 1, m));
  const auto pairs = vtu.arrays["label_pair"].values<std::int32_t>();
  const auto connectivity = vtu.arrays["connectivity"].values<std::int64_t>();
  for (std::size_t i = 0; i < m; ++i) {
    EXPECT_EQ(pairs[2 * i], surface.labels[i][0]);
    EXPECT_EQ(pairs[2 * i + 1], surface.labels[i][1]);
    for (std::size_t j = 0; j < 3; ++j)
      EXPECT_EQ(std::size_t(connectivity[3 * i + j]), surface.triangles[i][j]);
  }
}

TEST(Vtu, without_interface_has_no_cells) {
  const Temporary_folder folder;
  CGAL::IO::write_interface_VTU(folder / "a.vtu", make_complex(grid(2, small_meshes::uniform)));
  const Vtu vtu(folder / "a.vtu");
  EXPECT_EQ(vtu.number_of_points, 0u);
  EXPECT_EQ(vtu.number_of_cells, 0u);
}

TEST(Pvd_series, is_valid_after_each_file) {
  const Temporary_folder folder;
  CGAL::IO::PVD_series series(folder / "run.pvd");
  const std::vector<std::pair<double, std::string>> entries = {
      {0, "run_0.vtu"}, {0.1, "frames/run_1.vtu"}, {1. / 3, "a&b <\"c\">.vtu"}};
  for (std::size_t n = 1; n <= entries.size(); ++n) {
    series.append(entries[n - 1].first, folder / entries[n - 1].second);
    boost::property_tree::ptree tree;
    boost::property_tree::read_xml(series.path(), tree);
    EXPECT_EQ(tree.get<std::string>("VTKFile.<xmlattr>.type"), "Collection");
    std::size_t i = 0;
    for (const auto& data_set : tree.get_child("VTKFile.Collection")) {
      if (data_set.first != "DataSet")
        continue;
      EXPECT_EQ(data_set.second.get<double>("<xmlattr>.timestep"), entries.at(i).first);
      EXPECT_EQ(data_set.second.get<std::string>("<xmlattr>.file"), entries.at(i).second);
      ++i;
    }
    EXPECT_EQ(i, n);
  }
  EXPECT_EQ(folder.number_of_files(), 1);
}

// MEDIT

TEST(Medit, round_trip_is_exact) {
  const Temporary_folder folder;
  Complex dsc = make_complex(grid(4, small_meshes::four_phases));
  set_awkward_normalization(dsc);
  CGAL::IO::write_MEDIT(folder / "a.mesh", dsc);
  EXPECT_EQ(folder.number_of_files(), 1);

  std::vector<Point> points;
  Tetrahedra tetrahedra;
  std::vector<int> labels;
  CGAL::IO::read_MEDIT(folder / "a.mesh", points, tetrahedra, labels);
  const auto vertices = dsc.vertices();
  const auto cells = dsc.cells();
  ASSERT_EQ(points.size(), vertices.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto p = dsc.user_position(vertices[i]);
    EXPECT_EQ(points[i], Point(p.x(), p.y(), p.z()));
  }
  ASSERT_EQ(tetrahedra.size(), cells.size());
  ASSERT_EQ(labels.size(), cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    EXPECT_EQ(labels[i], dsc.label(cells[i]));
    for (int j = 0; j < 4; ++j)
      EXPECT_EQ(vertices[tetrahedra[i][std::size_t(j)]], cells[i]->vertex(j));
  }
  Complex again;
  again.assign(points, tetrahedra, labels);
  EXPECT_TRUE(again.is_valid(true));
}

TEST(Medit, triangles_refer_to_pairs_of_labels) {
  const Complex dsc = make_complex(grid(4, small_meshes::two_boxes));
  std::ostringstream out;
  out << std::hex << std::showpos; // must not matter
  CGAL::IO::write_MEDIT(out, dsc);
  const std::string text = out.str();
  for (const char* pair : {"reference 1 have normals from label 1 to label 0",
                           "reference 2 have normals from label 2 to label 0",
                           "reference 3 have normals from label 2 to label 1"})
    EXPECT_NE(text.find(pair), std::string::npos) << pair;

  const auto surface = CGAL::extract_interface(dsc);
  std::istringstream triangles(text.substr(text.find("Triangles\n") + 10));
  std::size_t n;
  triangles >> n;
  ASSERT_EQ(n, surface.triangles.size());
  for (const auto& labels : surface.labels) {
    std::size_t v[3];
    int reference = 0;
    triangles >> v[0] >> v[1] >> v[2] >> reference;
    EXPECT_EQ(reference, labels[0] + labels[1]);
  }
  std::string end;
  triangles >> end;
  EXPECT_EQ(end, "End");
}

TEST(Medit, comments_and_other_sections_are_skipped) {
  std::istringstream in("\r\n# a comment\nMeshVersionFormatted 1 # another\r\n\r\nDimension\n3\n"
                        "Tetrahedra 1\n1 2 3\n4 -7\n"
                        "Corners 2 1 4\nVerticesX\n2\n1 0 0 1 2.5e-1 nan-free\nRidges 0\n"
                        "Vertices\t4\n0 0 0 9 +1 0 0 9#c\n0 1.5E0 0 9\n0 0 .25 9\n"
                        "End\nanything may follow");
  std::vector<Point> points(7);
  Tetrahedra tetrahedra(7);
  std::vector<int> labels(7);
  CGAL::IO::read_MEDIT(in, points, tetrahedra, labels);
  EXPECT_EQ(points, (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1.5, 0}, {0, 0, .25}}));
  EXPECT_EQ(tetrahedra, (Tetrahedra{{0, 1, 2, 3}}));
  EXPECT_EQ(labels, std::vector<int>{-7});
}

TEST(Medit, bad_text_is_refused_with_its_line) {
  const std::string head = "MeshVersionFormatted 2\nDimension 3\n",
                    vertices = "Vertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "line 0"},
      {"OFF\n4 4 6\n", "line 1: the file does not begin"},
      {"MeshVersionFormatted 2\nDimension 2\n", "line 2: the dimension"},
      {head + "Vertices 4\n0 0 0 0\n1 0 0 0\n", "line 5: a number is missing"},
      {head + "Vertices -1\n", "line 3: '-1'"},
      {head + "Vertices 99999999999999999999999\n", "line 3"},
      {head + "Vertices 4000000000000\n0 0 0 0\n", "line 4: a number is missing"},
      {head + "Vertices 1\n0 0 inf 0\n", "line 4: a coordinate"},
      {head + "Vertices 1\n0 0 1e999 0\n", "line 4: '1e999'"},
      {head + "Vertices 1\n0 0 1x 0\n", "line 4: '1x'"},
      {head + vertices, "line 7: there are no tetrahedra"},
      {head + vertices + "Tetrahedra 1\n0 1 2 3 1\nEnd\n", "line 9: indices"},
      {head + vertices + "Tetrahedra 2\n1 2 3 4 1\n1 2 3 5 1\nEnd\n",
       "line 10: there is no vertex 5"},
      {head + "Tetrahedra 1\n1 2 3 5 1\n" + vertices + "End\n", "line 4: there is no vertex 5"},
      {head + vertices + "Tetrahedra 1\n1 2 3 4 1.5\n", "line 9: '1.5'"},
      {head + vertices + "Tetrahedra 1\n1 2 3 4 1\n1 2 3 4 1\n", "line 10: '1' is not expected"}};
  for (const auto& [text, message] : cases) {
    std::istringstream in(text);
    std::vector<Point> points(7);
    Tetrahedra tetrahedra(7);
    std::vector<int> labels(7);
    try {
      CGAL::IO::read_MEDIT(in, points, tetrahedra, labels);
      ADD_FAILURE() << text;
    } catch (const File_error& error) {
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
    }
    EXPECT_EQ(points.size(), 7u);
    EXPECT_EQ(tetrahedra.size(), 7u);
    EXPECT_EQ(labels.size(), 7u);
  }
  std::vector<Point> points;
  Tetrahedra tetrahedra;
  std::vector<int> labels;
  EXPECT_THROW(CGAL::IO::read_MEDIT("/no/such/file.mesh", points, tetrahedra, labels), File_error);
}

// Surfaces

TEST(Labelled_surface, of_a_written_interface_is_the_interface) {
  const Temporary_folder folder;
  Complex dsc = make_complex(grid(4, small_meshes::cube));
  set_awkward_normalization(dsc);
  const auto surface = CGAL::extract_interface(dsc);
  for (const std::string extension : {"off", "obj", "ply", "stl", "OFF"}) {
    const std::string path = folder / ("a." + extension);
    CGAL::IO::write_interface(path, dsc);
    const auto read = CGAL::IO::read_labelled_surface(path, 5);
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

TEST(Labelled_surface, of_a_pair_is_written) {
  const Temporary_folder folder;
  const Complex dsc = make_complex(grid(4, small_meshes::two_boxes));
  CGAL::IO::write_interface(folder / "a.off", dsc, 2, 1);
  EXPECT_NEAR(measures(CGAL::IO::read_labelled_surface(folder / "a.off")).area, 1, tolerance);
}

TEST(Labelled_surface, polygons_are_triangulated) {
  const Temporary_folder folder;
  // a prism over the L-shaped hexagon of area 3, of height 1
  write_bytes(folder / "a.off", "OFF\n12 8 0\n"
                                "0 0 0\n2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n"
                                "0 0 1\n2 0 1\n2 1 1\n1 1 1\n1 2 1\n0 2 1\n"
                                "6 5 4 3 2 1 0\n6 6 7 8 9 10 11\n"
                                "4 0 1 7 6\n4 1 2 8 7\n4 2 3 9 8\n4 3 4 10 9\n4 4 5 11 10\n"
                                "4 5 0 6 11\n");
  const auto surface = CGAL::IO::read_labelled_surface(folder / "a.off");
  EXPECT_EQ(surface.label, 1);
  EXPECT_EQ(surface.triangles.size(), 20u);
  const Measures m = measures(surface);
  EXPECT_NEAR(m.volume, 3, tolerance);
  EXPECT_NEAR(m.area, 14, tolerance);
  EXPECT_EQ(m.euler_characteristic, 2);
}

TEST(Labelled_surface, polygons_of_any_size_are_triangulated) {
  const Temporary_folder folder;
  for (const std::string e : {"-200", "-9", "0", "9", "200"}) {
    const std::string one = "1e" + e;
    write_bytes(folder / "a.off", "OFF\n5 1 0\n0 0 0\n" + one + " 0 0\n" + one + " " + one +
                                      " 0\n0 " + one + " 0\n0 0.5e" + e + " 0\n5 0 1 2 3 4\n");
    EXPECT_EQ(CGAL::IO::read_labelled_surface(folder / "a.off").triangles.size(), 3u) << one;
  }
}

TEST(Labelled_surface, bad_files_are_refused) {
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
    EXPECT_THROW(CGAL::IO::read_labelled_surface(folder / name), File_error) << name;
}

// All files

TEST(Replace_file, keeps_the_older_file_on_failure) {
  const Temporary_folder folder;
  const std::string path = folder / "a.txt";
  write_bytes(path, "old");
  const auto fail = [](const std::string& temporary) {
    write_bytes(temporary, "half of the new");
    return false;
  };
  const auto interrupt = [](const std::string& temporary) -> bool {
    write_bytes(temporary, "half of the new");
    throw std::runtime_error("interrupted");
  };
  const auto succeed = [](const std::string& temporary) {
    write_bytes(temporary, "new");
    return true;
  };
  EXPECT_THROW(internal::replace_file(path, fail), File_error);
  EXPECT_THROW(internal::replace_file(path, interrupt), std::runtime_error);
  EXPECT_EQ(file_bytes(path), "old");
  EXPECT_EQ(folder.number_of_files(), 1);
  internal::replace_file(path, succeed);
  EXPECT_EQ(file_bytes(path), "new");
  EXPECT_EQ(folder.number_of_files(), 1);
}

TEST(Replace_file, refuses_what_is_no_file) {
  const Temporary_folder folder;
  const Complex dsc = make_complex(grid(2, small_meshes::uniform));
  EXPECT_THROW(CGAL::IO::write_VTU(folder / "missing/a.vtu", dsc), File_error);
  EXPECT_THROW(CGAL::IO::write_MEDIT(folder / ".", dsc), File_error);
  EXPECT_THROW(CGAL::IO::write_VTU("/dev/null", dsc), File_error);
  EXPECT_THROW(CGAL::IO::write_interface(folder / "a.xyz", dsc), File_error);
  EXPECT_EQ(folder.number_of_files(), 0);
}
