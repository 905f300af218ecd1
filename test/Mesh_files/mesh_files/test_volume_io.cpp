#include "small_meshes.h"
#include "temporary_folder.h"
#include "test.h"
#include "vtu_grid.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Mesh_files/File_error.h>
#include <CGAL/Mesh_files/MEDIT_3.h>
#include <CGAL/Mesh_files/Mesh_arrays.h>
#include <CGAL/Mesh_files/Mesh_entities.h>
#include <CGAL/Mesh_files/Unused_content.h>
#include <CGAL/Mesh_files/VTU_3.h>
#include <CGAL/Mesh_files/internal/grids/Vtu_reader.h>

namespace test_volume_io {

using CGAL::Deformable_simplicial_complexes::File_error;
using CGAL::Deformable_simplicial_complexes::Invalid_cells_error;
using namespace small_meshes;
namespace internal = CGAL::Deformable_simplicial_complexes::internal;
using vtu_grid::base64;
using vtu_grid::Encoding;
using vtu_grid::Grid;

Labeled_mesh read_vtu(const std::string& path) {
  Labeled_mesh mesh;
  CGAL::IO::read_VTU(path, mesh.points, mesh.tetrahedra, mesh.labels);
  return mesh;
}

Labeled_mesh read_medit(const std::string& path) {
  Labeled_mesh mesh;
  CGAL::IO::read_MEDIT(path, mesh.points, mesh.tetrahedra, mesh.labels);
  return mesh;
}

void expect_equal(const Labeled_mesh& a, const Labeled_mesh& b) {
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.tetrahedra, b.tetrahedra);
  EXPECT_EQ(a.labels, b.labels);
}

const std::vector<double> coordinates = {0, 0, 0, 1, 0, 0, 0, 1. / 3, 0, 0, 0, 1e-7, 1, 1, 1};
const std::vector<std::int64_t> connectivity = {0, 1, 2, 3, 1, 2, 3, 4};
const std::string sizes = "NumberOfPoints=\"5\" NumberOfCells=\"2\"";

Labeled_mesh two_tetrahedra(const std::vector<int>& labels) {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1. / 3, 0}, {0, 0, 1e-7}, {1, 1, 1}},
          {{0, 1, 2, 3}, {1, 2, 3, 4}},
          labels};
}

// Content other than labels.
Grid two_cells(const Encoding& encoding = {}) {
  Grid grid(encoding);
  grid.array("Points", "Float64", "any name", coordinates)
      .array("Cells", "Int64", "connectivity", connectivity)
      .array("Cells", "Int64", "offsets", std::vector<std::int64_t>{4, 8})
      .array("Cells", "UInt8", "types", std::vector<std::uint8_t>{10, 10});
  return grid;
}

Grid labeled_cells(const Encoding& encoding = {}) {
  return two_cells(encoding).array("CellData", "Int32", "label", std::vector<std::int32_t>{3, -7});
}

// Reads a grid, expects this error message, and expects that the complex is unchanged.
void expect_refusal(const std::string& text, const std::string& message) {
  SCOPED_TRACE(message);
  const Temporary_folder folder;
  write_bytes(folder / "a.vtu", text);
  Labeled_mesh mesh = two_tetrahedra({1, 2});
  try {
    CGAL::IO::read_VTU(folder / "a.vtu", mesh.points, mesh.tetrahedra, mesh.labels);
    ADD_FAILURE() << text;
  } catch (const File_error& error) {
    const std::string what = error.what();
    EXPECT_PRED2(contains, what, message);
    EXPECT_EQ(what.find(folder / "a.vtu"), 0u) << what;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    EXPECT_EQ(error.path(), folder / "a.vtu");
  }
  expect_equal(mesh, two_tetrahedra({1, 2}));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t position = text.find(from);
  EXPECT_NE(position, std::string::npos) << from;
  return position == std::string::npos ? text : text.replace(position, from.size(), to);
}

TEST(Base64, is_decoded) {
  const std::string bytes("\0\xff\x10 any\n\x80", 9);
  for (std::size_t n = 0; n <= bytes.size(); ++n) {
    const std::string text = base64(bytes.substr(0, n));
    EXPECT_EQ(internal::bytes_of_base64(text, 100), bytes.substr(0, n));
    EXPECT_EQ(internal::bytes_of_base64("\n " + text + "\r\n<", 100), bytes.substr(0, n));
    EXPECT_EQ(internal::bytes_of_base64(text, n / 2), bytes.substr(0, n / 2));
    EXPECT_EQ(internal::bytes_of_base64(text + base64(bytes), 100), bytes.substr(0, n) + bytes);
  }
}

TEST(Read_vtu, round_trip_is_exact) {
  const Temporary_folder folder;
  Complex dsc = make_complex(grid(4, small_meshes::four_phases));
  dsc.set_normalization({Complex::Vector_3(0.1, -100, 1e-7), 1. / 3});
  CGAL::IO::write_VTU(folder / "a.vtu", dsc);
  CGAL::IO::write_MEDIT(folder / "a.mesh", dsc);
  const Labeled_mesh read = read_vtu(folder / "a.vtu");
  EXPECT_EQ(read.tetrahedra.size(), 384u);
  expect_equal(read, read_medit(folder / "a.mesh"));
  EXPECT_TRUE(make_complex(read).is_valid(true));
}

TEST(Read_vtu, all_encodings_agree) {
  const Temporary_folder folder;
  for (const std::string format : {"ascii", "binary", "base64", "raw"})
    for (const std::string header_type : {"UInt32", "UInt64"})
      for (const bool separates_header : {false, true})
        for (const std::string line_end : {"\n", "\r\n"}) {
          SCOPED_TRACE(format + header_type + line_end);
          const Encoding encoding = {format, header_type, separates_header, line_end};
          write_bytes(folder / "a.vtu", labeled_cells(encoding).text(sizes));
          expect_equal(read_vtu(folder / "a.vtu"), two_tetrahedra({3, -7}));
        }
}

TEST(Read_vtu, binary_data_may_look_like_anything) {
  const Temporary_folder folder;
  Encoding encoding;
  encoding.format = "raw";
  Grid grid = labeled_cells(encoding);
  std::vector<std::uint8_t> bytes;
  for (const char c : std::string("</AppendedData>\0<AppendedData>", 30))
    bytes.push_back(static_cast<std::uint8_t>(c));
  grid.array("FieldData", "UInt8", "bytes", bytes);
  write_bytes(folder / "a.vtu", grid.text(sizes));
  expect_equal(read_vtu(folder / "a.vtu"), two_tetrahedra({3, -7}));
}

TEST(Read_vtu, numbers_may_have_any_type) {
  const Temporary_folder folder;
  for (const std::string format : {"ascii", "binary", "base64", "raw"}) {
    SCOPED_TRACE(format);
    Encoding encoding;
    encoding.format = format;
    const auto expect_labels = [&](const std::string& type, const auto& labels) {
      SCOPED_TRACE(type);
      write_bytes(folder / "a.vtu",
                  two_cells(encoding).array("CellData", type, "label", labels).text(sizes));
      expect_equal(read_vtu(folder / "a.vtu"), two_tetrahedra({int(labels[0]), int(labels[1])}));
    };
    expect_labels("Int8", std::vector<std::int8_t>{-128, 127});
    expect_labels("UInt8", std::vector<std::uint8_t>{0, 255});
    expect_labels("Int16", std::vector<std::int16_t>{-32768, 32767});
    expect_labels("UInt16", std::vector<std::uint16_t>{0, 65535});
    expect_labels("Int32", std::vector<std::int32_t>{-2147483647 - 1, 2147483647});
    expect_labels("UInt32", std::vector<std::uint32_t>{0, 2147483647});
    expect_labels("Int64", std::vector<std::int64_t>{-5, 2147483647});
    expect_labels("UInt64", std::vector<std::uint64_t>{5, 2147483647});
    expect_labels("Float32", std::vector<float>{-1, 7});
    expect_labels("Float64", std::vector<double>{-1, 7});
  }
}

TEST(Read_vtu, labels_have_the_first_of_several_names) {
  const Temporary_folder folder;
  const std::string path = folder / "a.vtu";
  write_bytes(path, two_cells().text(sizes));
  expect_equal(read_vtu(path), two_tetrahedra({1, 1}));
  Grid grid = two_cells();
  grid.array("CellData", "Float64", "quality", std::vector<double>{0.5, 0.25});
  grid.array("PointData", "Int32", "label", std::vector<int>{1, 2, 3, 4, 5});
  write_bytes(path, grid.text(sizes));
  expect_equal(read_vtu(path), two_tetrahedra({1, 1}));
  int label = 10;
  for (const char* name : {"MaterialIDs", "gmsh:physical", "medit:ref", "label"}) {
    label += 10;
    grid.array("CellData", "Int32", name, std::vector<int>{label, label + 1});
    write_bytes(path, grid.text(sizes));
    expect_equal(read_vtu(path), two_tetrahedra({label, label + 1}));
  }
}

// Compressed files of programs that can compress.
TEST(Read_vtu, compression_of_text_does_not_matter) {
  const Temporary_folder folder;
  const std::string attributes = "compressor=\"vtkZLibDataCompressor\" byte_order=\"BigEndian\"";
  write_bytes(folder / "a.vtu", labeled_cells().text(sizes, attributes));
  expect_equal(read_vtu(folder / "a.vtu"), two_tetrahedra({3, -7}));
}

TEST(Read_vtu, other_files_are_refused) {
  EXPECT_THROW(read_vtu("/no/such/file.vtu"), File_error);
  const std::string text = labeled_cells().text(sizes);
  expect_refusal("", "is empty");
  expect_refusal("MeshVersionFormatted 2\n", "is a MEDIT mesh");
  expect_refusal("<html></html>", "no element VTKFile");
  expect_refusal(text.substr(0, text.size() / 2), "is it a complete VTK XML file?");
  expect_refusal("<VTKFile type=\"PolyData\"><PolyData/></VTKFile>", "type 'PolyData'");
  expect_refusal("<VTKFile type=\"UnstructuredGrid\"></VTKFile>", "no element UnstructuredGrid");
  expect_refusal(replaced(text, "<Piece", "<Piece NumberOfPoints=\"0\"></Piece><Piece"),
                 "there are 2 pieces");
  expect_refusal(replaced(replaced(text, "<Piece", "<Part"), "</Piece", "</Part"),
                 "there are 0 pieces");
  expect_refusal(two_cells().text("NumberOfPoints=\"5\" NumberOfCells=\"0\""),
                 "there are no cells");
}

// The reader does not recurse.
TEST(Read_vtu, elements_nested_without_end_are_refused) {
  std::string text;
  for (int i = 0; i < 30000; ++i)
    text += "<a>";
  expect_refusal(text, "line 1: elements are nested more than 64 levels deep");
  for (int i = 0; i < 30000; ++i)
    text += "</a>";
  expect_refusal(text, "elements are nested");
}

TEST(Read_vtu, xml_may_be_written_in_any_way) {
  const Temporary_folder folder;
  std::string text = labeled_cells().text(sizes);
  text = replaced(text, "<Points>", "<!-- > <Points> \" --><?a <b> ?><Points\n>");
  text = replaced(text, "</Points>", "<![CDATA[</Points>]]></Points >");
  text = replaced(text, "NumberOfPoints=\"5\"", "Name=\"a>b='c'\"\n\tNumberOfPoints =\r\n '5'");
  text = replaced(text, " 3 -7", " 3<!-- 5 --> <Note/>-7");
  write_bytes(folder / "a.vtu", text);
  expect_equal(read_vtu(folder / "a.vtu"), two_tetrahedra({3, -7}));
}

TEST(Read_vtu, what_is_no_xml_is_refused_with_its_line) {
  expect_refusal("\n<a><b></a></b>", "line 2: a closing tag does not match the last open element");
  expect_refusal("</a>", "line 1: a closing tag does not match");
  expect_refusal("\n\n<>", "line 3: a tag has no name");
  expect_refusal("<a", "a tag does not end");
  expect_refusal("<a b='>", "a tag does not end");
  expect_refusal("<!-- ", "<!-- does not end");
}

TEST(Read_vtu, arrays_must_be_complete) {
  const std::string text = labeled_cells().text(sizes);
  for (const char* name : {"connectivity", "offsets", "types"})
    expect_refusal(replaced(text, std::string("\"") + name, "\"x"),
                   std::string("no array '") + name);
  expect_refusal(replaced(replaced(text, "<Points>", "<Pts>"), "</Points>", "</Pts>"),
                 "the section Points has no array");
  for (const char* other :
       {"NumberOfPoints=\"4\" NumberOfCells=\"2\"", "NumberOfPoints=\"5\" NumberOfCells=\"1\"",
        "NumberOfPoints=\"5\" NumberOfCells=\"3\"",
        "NumberOfPoints=\"12297829382473034416\" NumberOfCells=\"2\""}) // times 3 overflows
    expect_refusal(labeled_cells().text(other), "is the file truncated?");
  for (const char* other : {"NumberOfPoints=\"5\"", "NumberOfPoints=\"-5\" NumberOfCells=\"2\"",
                            "NumberOfPoints=\"5\" NumberOfCells=\"2.0\"",
                            "NumberOfPoints=\"99999999999999999999999\" NumberOfCells=\"2\""})
    expect_refusal(labeled_cells().text(other), "should be a number");
  Grid grid = two_cells();
  grid.array("CellData", "Int32", "label", std::vector<int>{1, 2, 3});
  expect_refusal(grid.text(sizes), "the array 'label' of CellData has 3 numbers instead of 2");
  expect_refusal(replaced(text, " 3 -7", " 3 seven"), "is not a number");
  expect_refusal(replaced(text, "format=\"ascii\"", "format=\"morse\""), "format 'morse'");
}

TEST(Read_vtu, values_must_make_sense) {
  const std::string text = labeled_cells().text(sizes);
  for (const char* bad : {" nan", " inf", " -inf"})
    expect_refusal(replaced(text, " 1 1 1\n", std::string(" 1 1") + bad + "\n"),
                   "a coordinate of point 4 is not a finite number");
  for (const char* bad : {" 5", " -1", " 0.5", " nan", " 1e300"})
    expect_refusal(replaced(text, " 1 2 3 4\n", std::string(" 1 2 3") + bad + "\n"),
                   "cell 1 has a vertex that does not exist");
  for (const char* bad : {" 1.5", " nan", " inf", " 2147483648"})
    expect_refusal(replaced(text, " 3 -7", std::string(" 3") + bad),
                   "the label of cell 1 is not a 32-bit integer");
  expect_refusal(replaced(text, " 4 8\n", " 4 9\n"), "cell 1 does not have four vertices");
  for (const auto& [type, name] :
       std::vector<std::pair<std::string, std::string>>{{" 12", "a hexahedron"},
                                                        {" 24", "a quadratic tetrahedron"},
                                                        {" 200", "of an unknown type"},
                                                        {" nan", "of an unknown type"}})
    expect_refusal(replaced(text, " 10 10\n", " 10" + type + "\n"),
                   "cell 1 is " + name + " and not a tetrahedron");
}

// Reads a grid with this array of labels.
Labeled_mesh read_with(const std::string& path, const std::string& label_array,
                       CGAL::Deformable_simplicial_complexes::Mesh_arrays* arrays = nullptr,
                       CGAL::Deformable_simplicial_complexes::Unused_content* unused = nullptr) {
  Labeled_mesh mesh;
  CGAL::IO::read_VTU(path, mesh.points, mesh.tetrahedra, mesh.labels, label_array, arrays, unused);
  return mesh;
}

Grid unnamed_labels() {
  Grid grid = two_cells();
  grid.array("CellData", "Int32", "material", std::vector<std::int32_t>{4, 9})
      .array("CellData", "Float64", "p", std::vector<double>{0.5, -2})
      .array("CellData", "Float64", "f", std::vector<double>{7, 8});
  return grid;
}

TEST(Read_vtu, labels_are_not_guessed) {
  const std::string text = unnamed_labels().text(sizes);
  for (const char* part : {"'material' (Int32, integers from 4 to 9)",
                           "'p' (Float64, not labels, values from -2 to 0.5)",
                           "'f' (Float64, integers from 7 to 8)", "'none'"})
    expect_refusal(text, part);
  const Temporary_folder folder;
  const std::string path = folder / "a.vtu";
  write_bytes(path, text);
  expect_equal(read_with(path, "material"), two_tetrahedra({4, 9}));
  expect_equal(read_with(path, "f"), two_tetrahedra({7, 8}));
  expect_equal(read_with(path, "none"), two_tetrahedra({1, 1}));
  for (const char* name : {"p", "x"}) // labels with fractions, and missing labels
    EXPECT_THROW(read_with(path, name), File_error);
  // Arrays that cannot be labels do not make the choice ambiguous.
  write_bytes(
      path,
      two_cells().array("CellData", "Float64", "p", std::vector<double>{0.5, -2}).text(sizes));
  expect_equal(read_vtu(path), two_tetrahedra({1, 1}));
}

// The two tetrahedra with points of their own, and a point of a triangle.
TEST(Read_vtu, repeated_corners_are_merged) {
  std::vector<double> repeated = {0, 1. / 3, 0};
  for (const std::int64_t v : connectivity)
    repeated.insert(repeated.end(), coordinates.begin() + 3 * v, coordinates.begin() + 3 * v + 3);
  Grid grid;
  grid.array("Points", "Float64", "", repeated)
      .array("Cells", "Int64", "connectivity", std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8, 0, 1, 2})
      .array("Cells", "Int64", "offsets", std::vector<int>{4, 8, 11})
      .array("Cells", "UInt8", "types", std::vector<int>{10, 10, 5})
      .array("CellData", "Int32", "label", std::vector<int>{3, -7, 0})
      .array("PointData", "Float64", "same", std::vector<int>{99, 4, 5, 6, 7, 5, 6, 7, 8})
      .array("PointData", "Float64", "several", std::vector<int>{99, 4, 5, 6, 7, 5, 6, 8, 8});
  const Temporary_folder folder;
  const std::string path = folder / "a.vtu";
  write_bytes(path, grid.text("NumberOfPoints=\"9\" NumberOfCells=\"3\""));
  CGAL::Deformable_simplicial_complexes::Mesh_arrays arrays;
  CGAL::Deformable_simplicial_complexes::Unused_content unused;
  expect_equal(read_with(path, "", &arrays, &unused), two_tetrahedra({3, -7}));
  ASSERT_EQ(arrays.points.size(), 1u);
  EXPECT_EQ(arrays.points[0].values, (std::vector<double>{4, 5, 6, 7, 8}));
  EXPECT_EQ(unused.text(), "1 point array with several values at a point ('several'), 1 triangles");
}

TEST(Read_medit, repeated_corners_are_merged) {
  const std::string text = "MeshVersionFormatted 2\nDimension 3\nVertices 8\n0 0 0 1\n1 0 0 2\n"
                           "0 0.5 0 3\n0 0 1 4\n1 0 0 2\n0 0.5 0 3\n-0 0 1 4\n1 1 1 5\n"
                           "Tetrahedra 2\n1 2 3 4 3\n5 6 7 8 -7\nTriangles 1\n5 6 7 9\n"
                           "RequiredVertices 2\n2\n5\nEnd\n";
  for (const bool is_same : {true, false}) {
    std::istringstream in(is_same ? text : replaced(text, "-0 0 1 4", "-0 0 1 6"));
    Labeled_mesh mesh;
    CGAL::Deformable_simplicial_complexes::Mesh_entities entities;
    CGAL::Deformable_simplicial_complexes::Unused_content unused;
    CGAL::IO::read_MEDIT(in, mesh.points, mesh.tetrahedra, mesh.labels, "text", &entities, &unused);
    EXPECT_EQ(mesh.points.size(), 5u);
    EXPECT_EQ(mesh.tetrahedra, two_tetrahedra({3, -7}).tetrahedra);
    EXPECT_EQ(entities.vertex_references,
              is_same ? std::vector<int>({1, 2, 3, 4, 5}) : std::vector<int>());
    EXPECT_EQ(entities.triangles.at(0).vertices, (std::array<std::size_t, 3>{1, 2, 3}));
    EXPECT_EQ(entities.required_vertices, std::vector<std::size_t>{1});
    EXPECT_EQ(unused.text(), is_same ? "" : "8 vertex references, which differ at equal points");
  }
}

TEST(Read_vtu, labels_beyond_53_bits_are_refused) {
  Grid grid = two_cells();
  grid.array("CellData", "Int64", "label", std::vector<std::int64_t>{1, std::int64_t(1) << 60});
  expect_refusal(grid.text(sizes), "the label of cell 1 is not a 32-bit integer");
}

TEST(Read_vtu, a_second_array_of_labels_is_told) {
  const Temporary_folder folder;
  Grid grid = labeled_cells();
  grid.array("CellData", "Int32", "MaterialIDs", std::vector<std::int32_t>{3, 5});
  write_bytes(folder / "a.vtu", grid.text(sizes));
  CGAL::Deformable_simplicial_complexes::Unused_content unused;
  expect_equal(read_with(folder / "a.vtu", "", nullptr, &unused), two_tetrahedra({3, -7}));
  EXPECT_PRED2(contains, unused.text(), "'MaterialIDs'");
}

TEST(Read_vtu, other_arrays_are_read_and_written) {
  const Temporary_folder folder;
  const std::string path = folder / "a.vtu";
  Grid grid = unnamed_labels();
  grid.array("PointData", "Float32", "t", std::vector<float>{1, 2, 3.5, 4, 5})
      .array("PointData", "UInt8", "marker", std::vector<std::uint8_t>{0, 255, 0, 1, 2})
      .array("PointData", "String", "names", std::vector<int>{1});
  write_bytes(path, grid.text(sizes));
  CGAL::Deformable_simplicial_complexes::Mesh_arrays arrays, again;
  CGAL::Deformable_simplicial_complexes::Unused_content unused;
  const Labeled_mesh mesh = read_with(path, "material", &arrays, &unused);
  EXPECT_EQ(arrays.labels.name, "material");
  ASSERT_EQ(arrays.cells.size(), 2u);
  ASSERT_EQ(arrays.points.size(), 2u);
  EXPECT_EQ(arrays.points[0].values, (std::vector<double>{1, 2, 3.5, 4, 5}));
  EXPECT_TRUE(arrays.points[1].is_integer());
  EXPECT_EQ(unused.text(), "1 array without numbers ('names')");

  Complex dsc;
  dsc.assign(mesh.points, mesh.tetrahedra, mesh.labels);
  CGAL::IO::write_VTU(path, dsc, arrays);
  EXPECT_EQ(read_with(path, "material").labels, read_with(path, "label").labels);
  read_with(path, "material", &again);
  for (const auto& array : arrays.points) {
    const auto same = std::find_if(again.points.begin(), again.points.end(),
                                   [&](const auto& other) { return other.name == array.name; });
    ASSERT_NE(same, again.points.end()) << array.name;
    EXPECT_EQ(same->type, array.type);
    EXPECT_EQ(same->values, array.values);
  }
}

TEST(Read_vtu, cells_of_lower_dimension_are_left_out) {
  const Temporary_folder folder;
  Grid grid;
  grid.array("Points", "Float64", "any name", coordinates)
      .array("Cells", "Int64", "connectivity",
             std::vector<std::int64_t>{0, 0, 1, 2, 3, 0, 1, 2, 1, 2, 3, 4})
      .array("Cells", "Int64", "offsets", std::vector<std::int64_t>{1, 5, 8, 12})
      .array("Cells", "UInt8", "types", std::vector<std::uint8_t>{1, 10, 5, 10})
      .array("CellData", "Int32", "label", std::vector<std::int32_t>{8, 3, 9, -7});
  write_bytes(folder / "a.vtu", grid.text("NumberOfPoints=\"5\" NumberOfCells=\"4\""));
  CGAL::Deformable_simplicial_complexes::Unused_content unused;
  expect_equal(read_with(folder / "a.vtu", "", nullptr, &unused), two_tetrahedra({3, -7}));
  EXPECT_EQ(unused.text(), "1 triangles, 1 vertices");
  const std::string text = labeled_cells().text(sizes);
  expect_refusal(replaced(text, " 10 10\n", " 5 9\n"), "there are no tetrahedra among the cells");
}

// MEDIT

const std::string medit_head = "MeshVersionFormatted 2\nDimension 3\nVertices 5\n0 0 0 0\n1 0 0 6\n"
                               "0 1 0 0\n0 0 1 0\n1 1 1 0\nTetrahedra 2\n1 2 3 4 3\n2 3 4 5 3\n";

TEST(Read_medit, entities_are_read_and_written) {
  std::istringstream in(medit_head +
                        "Triangles 2\n2 3 4 7\n1 2 3 -8\nEdges 2\n1 2 5\n2 3 6\nCorners 1\n1\n"
                        "RequiredVertices 2\n3 5\nRidges 1\n2\nRequiredEdges 1\n1\n"
                        "RequiredTriangles 1\n2\nNormals 2\n1 0 0\n0 1 0\nEnd\n");
  Labeled_mesh mesh;
  CGAL::Deformable_simplicial_complexes::Mesh_entities entities, again;
  CGAL::Deformable_simplicial_complexes::Unused_content unused;
  CGAL::IO::read_MEDIT(in, mesh.points, mesh.tetrahedra, mesh.labels, "a.mesh", &entities, &unused);
  EXPECT_EQ(unused.text(), "2 elements of Normals");
  EXPECT_EQ(entities.vertex_references, (std::vector<int>{0, 6, 0, 0, 0}));
  const Complex dsc = make_complex(mesh);
  std::ostringstream out;
  CGAL::IO::write_MEDIT(out, dsc, entities);
  std::istringstream written(out.str());
  CGAL::IO::read_MEDIT(written, mesh.points, mesh.tetrahedra, mesh.labels, "b.mesh", &again);
  EXPECT_EQ(again.vertex_references, entities.vertex_references);
  ASSERT_EQ(again.triangles.size(), 2u);
  EXPECT_EQ(again.triangles[1].vertices, (std::array<std::size_t, 3>{0, 1, 2}));
  EXPECT_EQ(again.triangles[1].reference, -8);
  ASSERT_EQ(again.edges.size(), 2u);
  EXPECT_EQ(again.edges[0].reference, 5);
  EXPECT_EQ(again.corners, entities.corners);
  EXPECT_EQ(again.required_vertices, (std::vector<std::size_t>{2, 4}));
  EXPECT_EQ(again.ridges, entities.ridges);
  EXPECT_EQ(again.required_edges, entities.required_edges);
  EXPECT_EQ(again.required_triangles, entities.required_triangles);
}

TEST(Read_medit, what_changes_the_result_is_refused) {
  const auto expect_message = [](const std::string& text, const std::string& message) {
    std::istringstream in(text);
    Labeled_mesh mesh;
    try {
      CGAL::IO::read_MEDIT(in, mesh.points, mesh.tetrahedra, mesh.labels);
      ADD_FAILURE() << message;
    } catch (const File_error& error) {
      EXPECT_PRED2(contains, std::string(error.what()), message) << error.what();
    }
  };
  expect_message(medit_head + "Hexahedra 1\n1 2 3 4 5 1 2 3 0\nEnd\n",
                 "1 elements of 'Hexahedra'; divide them into tetrahedra");
  expect_message(medit_head + "TetrahedraP2 1\n1 2 3 4 5 1 2 3 4 5 0\nEnd\n", "'TetrahedraP2'");
  expect_message(medit_head + "Tetrahedra 1\n1 2 3 4 3000000000\nEnd\n",
                 "line 13: '3000000000' is not a 32-bit integer");
  expect_message(medit_head + "Ridges 1\n1\nEnd\n", "line 13: there is no edge 1");
  expect_message(medit_head + "Triangles 1\n1 2 9 0\nEnd\n", "line 13: there is no vertex 9");
}

TEST(Read_vtu, damaged_binary_data_are_refused) {
  for (const std::string format : {"binary", "base64", "raw"}) {
    SCOPED_TRACE(format);
    Encoding encoding;
    encoding.format = format;
    const std::string text = labeled_cells(encoding).text(sizes);
    expect_refusal(labeled_cells(encoding).text(sizes, "compressor=\"vtkZLibDataCompressor\""),
                   "the numbers are compressed");
    expect_refusal(labeled_cells(encoding).text(sizes, "byte_order=\"BigEndian\""), "big-endian");
    expect_refusal(replaced(text, "\"UInt32\"", "\"UInt16\""), "header_type 'UInt16'");
    expect_refusal(replaced(text, "\"UInt32\"", "\"UInt64\""), "ends too early");
    expect_refusal(replaced(text, "Float64", "Float80"), "unknown type 'Float80'");
    expect_refusal(replaced(text, "Float64", "Float32"), "has 30 numbers instead of 3 times 5");
  }
  Encoding encoding;
  encoding.format = "raw";
  const std::string text = labeled_cells(encoding).text(sizes);
  expect_refusal(text.substr(0, text.size() - 40), "the section AppendedData does not end");
  expect_refusal(replaced(text, "   _", "   "), "does not begin with '_'");
  expect_refusal(replaced(text, "offset=\"0\"", "offset=\"100000\""), "begins after the end");
  expect_refusal(replaced(text, "offset=\"0\"", "offset=\"x\""), "offset should be a number");
}

// The builder, not the reader, decides whether the cells form a mesh.
TEST(Read_vtu, tetrahedra_are_turned_or_refused_by_the_builder) {
  const Temporary_folder folder;
  const std::string text = labeled_cells().text(sizes), path = folder / "a.vtu";
  const auto make = [&] {
    const Labeled_mesh mesh = read_vtu(path);
    return DSC::make_deformable_simplicial_complex_3<Complex>(
        mesh.points, mesh.tetrahedra, mesh.labels, parameters::improve(false));
  };
  write_bytes(path, replaced(text, " 0 1 2 3 1 2 3 4\n", " 1 0 2 3 1 2 3 4\n"));
  EXPECT_EQ(make().number_of_cells(), 2u);
  EXPECT_EQ(make().labels(), (std::vector<int>{-7, 3}));
  write_bytes(path, replaced(text, " 0 1 2 3 1 2 3 4\n", " 0 1 2 2 1 2 3 4\n"));
  EXPECT_THROW(make(), Invalid_cells_error);
}

} // namespace test_volume_io
