#include "surface_measures.h"
#include "temporary_folder.h"
#include "test.h"

#include <CGAL/Interface_remeshing/extract_interface_3.h>
#include <CGAL/Mesh_files/File_error.h>
#include <CGAL/Mesh_files/MEDIT_3.h>
#include <CGAL/Mesh_files/PVD_series.h>
#include <CGAL/Mesh_files/VTU_3.h>
#include <CGAL/Mesh_files/internal/text/files.h>
#include <CGAL/Mesh_files/internal/text/little_endian.h>
#include <CGAL/Mesh_files/labeled_surface_3.h>
#include <CGAL/Mesh_files/replace_file.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <sys/resource.h>

#include <csignal>
#include <iomanip>

namespace test_io {

using CGAL::Deformable_simplicial_complexes::File_error;
using small_meshes::grid;
using small_meshes::make_complex;
using small_meshes::Point;
using namespace surface_measures;
using Tetrahedra = std::vector<std::array<std::size_t, 4>>;
namespace internal = CGAL::Deformable_simplicial_complexes::internal;

// VTU

// Parses a VTU file without VTK.
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

  // Returns whether an array exists and has this number of bytes.
  bool has(const std::string& name, const std::string& section, const std::string& type,
           std::size_t components, std::size_t size) const {
    const auto i = arrays.find(name);
    return i != arrays.end() && i->second.section == section && i->second.type == type &&
           i->second.components == components && i->second.bytes.size() == size;
  }

  std::size_t number_of_points, number_of_cells;
  std::map<std::string, Array> arrays;
};

TEST(Vtu, of_the_volume_has_all_arrays) {
  const Temporary_folder folder;
  const Complex dsc = complex_with_long_coordinates(small_meshes::two_boxes);
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
  const auto surface = DSC::extract_interface(dsc);
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

TEST(Vtu, of_the_interface_has_given_arrays) {
  const Temporary_folder folder;
  const Complex dsc = make_complex(grid(4, small_meshes::two_boxes));
  DSC::Mesh_arrays arrays;
  arrays.points = {{"velocity", "Float64", 3, {}}};
  arrays.cells = {{"area", "Float64", 1, {}}, {"label_pair", "Float64", 1, {}}};
  for (const auto v : dsc.interface_vertices())
    for (int axis = 0; axis < 3; ++axis)
      arrays.points[0].values.push_back(2 * dsc.user_position(v)[axis]);
  for (const auto& f : dsc.interface_facets())
    arrays.cells[0].values.push_back(dsc.measure(f));
  arrays.cells[1].values = arrays.cells[0].values;
  CGAL::IO::write_interface_VTU(folder / "a.vtu", dsc, arrays);
  Vtu vtu(folder / "a.vtu");
  const std::size_t n = dsc.interface_vertices().size(), m = dsc.interface_facets().size();
  EXPECT_EQ(vtu.arrays.size(), 7u);
  EXPECT_TRUE(vtu.has("velocity", "PointData", "Float64", 3, 24 * n));
  EXPECT_TRUE(vtu.has("area", "CellData", "Float64", 1, 8 * m));
  EXPECT_TRUE(vtu.has("label_pair", "CellData", "Int32", 2, 8 * m)); // the array that is computed
  std::vector<double> points = vtu.arrays["points"].values<double>();
  for (double& x : points)
    x *= 2;
  EXPECT_EQ(vtu.arrays["velocity"].values<double>(), points);
  EXPECT_EQ(vtu.arrays["area"].values<double>(), arrays.cells[0].values);
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

TEST(Pvd_series, refuses_a_time_that_is_not_finite) {
  const Temporary_folder folder;
  CGAL::IO::PVD_series series(folder / "run.pvd");
  series.append(0, folder / "0.vtu");
  const std::string before = file_bytes(series.path());
  for (const double time : {std::numeric_limits<double>::infinity(), std::nan("")})
    EXPECT_THROW(series.append(time, folder / "1.vtu"), File_error);
  EXPECT_EQ(file_bytes(series.path()), before);
}

// MEDIT

TEST(Medit, round_trip_is_exact) {
  const Temporary_folder folder;
  const Complex dsc = complex_with_long_coordinates(small_meshes::four_phases);
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
  out << std::hex << std::showpos; // the order must not matter
  CGAL::IO::write_MEDIT(out, dsc);
  const std::string text = out.str();
  for (const char* pair : {"reference 1 have normals from label 1 to label 0",
                           "reference 2 have normals from label 2 to label 0",
                           "reference 3 have normals from label 2 to label 1"})
    EXPECT_PRED2(contains, text, pair) << pair;

  const auto surface = DSC::extract_interface(dsc);
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
      EXPECT_PRED2(contains, std::string(error.what()), message) << error.what();
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

// All files

TEST(Replace_file, keeps_the_older_file_on_failure) {
  const Temporary_folder folder;
  const std::string path = folder / "a.txt";
  write_bytes(path, "old");
  const auto fail = [](std::ostream& out) {
    out << "half of the new";
    out.setstate(std::ios::failbit);
  };
  const auto interrupt = [](std::ostream& out) {
    out << "half of the new" << std::flush;
    throw std::runtime_error("interrupted");
  };
  const auto succeed = [](std::ostream& out) { out << "new"; };
  EXPECT_THROW(DSC::replace_file(path, fail), File_error);
  EXPECT_THROW(DSC::replace_file(path, interrupt), std::runtime_error);
  EXPECT_EQ(file_bytes(path), "old");
  EXPECT_EQ(folder.number_of_files(), 1);
  DSC::replace_file(path, succeed);
  EXPECT_EQ(file_bytes(path), "new");
  EXPECT_EQ(folder.number_of_files(), 1);
}

// A full disk, simulated by a limit on the size of files.
TEST(Replace_file, keeps_the_older_file_on_a_full_disk) {
  const Temporary_folder folder;
  const std::string path = folder / "a.txt";
  write_bytes(path, "old");
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit before;
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit small = {1000, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const auto write = [](std::ostream& out) { out << std::string(200000, 'x'); };
  EXPECT_THROW(DSC::replace_file(path, write), File_error);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(file_bytes(path), "old");
  EXPECT_EQ(folder.number_of_files(), 1);
}

// A link with the name of the result is replaced, and what it names stays.
TEST(Replace_file, does_not_follow_links) {
  const Temporary_folder folder;
  write_bytes(folder / "victim.txt", "precious");
  std::filesystem::create_symlink("victim.txt", folder / "a.txt");
  DSC::replace_file(folder / "a.txt", [](std::ostream& out) { out << "new"; });
  EXPECT_EQ(file_bytes(folder / "a.txt"), "new");
  EXPECT_EQ(file_bytes(folder / "victim.txt"), "precious");
}

// What a killed process left is removed, and nothing else.
TEST(Replace_file, leftovers_are_removed) {
  const Temporary_folder folder;
  write_bytes(folder / ".partial-0123456789abcdef", "left");
  write_bytes(folder / ".partial-own", "precious");
  std::filesystem::create_symlink("none", folder / ".partial-fedcba9876543210");
  DSC::replace_file(folder / "a.txt", [&](std::ostream& out) {
    out << "new" << std::flush;
    DSC::internal::remove_partial_files(folder / ""); // not the file of a living process
  });
  EXPECT_EQ(file_bytes(folder / "a.txt"), "new");
  EXPECT_EQ(folder.number_of_files(), 3);
  EXPECT_FALSE(std::filesystem::exists(folder / ".partial-0123456789abcdef"));
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

} // namespace test_io
