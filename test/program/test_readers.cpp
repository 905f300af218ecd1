// Files as other programs write, damage or rename them. Their content is used, reported as unused,
// or rejected with a reason.
#include "program.h"
#include "test.h"

#include <cstring>

namespace {

using program::Outcome;

const std::string off_numbers = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                                "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                        "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

const std::string ply = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float "
                        "y\nproperty float z\nelement face 4\nproperty list uchar int "
                        "vertex_indices\nend_header\n" +
                        off_numbers;

// A tetrahedron of volume 1/6.
std::string stl() {
  const int points[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
            facets[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  std::ostringstream text;
  text << "solid a facet\n";
  for (const auto& facet : facets) {
    text << "facet normal 0 0 0\nouter loop\n";
    for (const int v : facet)
      text << "vertex " << points[v][0] << ' ' << points[v][1] << ' ' << points[v][2] << '\n';
    text << "endloop\nendfacet\n";
  }
  text << "endsolid\n";
  return text.str();
}

// The same tetrahedron with a binary header that looks like text.
std::string binary_stl(std::uint32_t announced, std::uint16_t attribute = 0) {
  const float points[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const int facets[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  std::string bytes = "solid of bytes" + std::string(66, ' ');
  const auto append = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  append(announced);
  for (const auto& facet : facets) {
    bytes += std::string(12, '\0');
    for (const int v : facet)
      append(points[v]);
    append(attribute);
  }
  return bytes;
}

std::string with_line_ends(std::string text, const std::string& line_end) {
  for (std::size_t i = 0; (i = text.find('\n', i)) != std::string::npos; i += line_end.size())
    text.replace(i, 1, line_end);
  return text;
}

std::string in_capitals(std::string text) {
  for (char& c : text)
    c = 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return text;
}

std::string inr(const std::string& lines, std::size_t bytes) {
  return "#INRIMAGE-4#{\n" + lines + "##}\n" + std::string(bytes, '\1');
}

const std::string inr_size = "XDIM=20\nYDIM=20\nZDIM=20\n",
                  inr_type = "VDIM=1\nTYPE=unsigned fixed\nPIXSIZE=8 bits\nCPU=decm\n";

class Readers : public program::Program_test
{
protected:
  void expect_tetrahedron(const std::string& name, const std::string& bytes,
                          const std::string& unused = "") {
    SCOPED_TRACE(bytes);
    write(name, bytes);
    const Outcome outcome = run("info " + name);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_PRED2(contains, outcome.out, "triangles             4\n");
    EXPECT_PRED2(contains, outcome.out, "volume                0.16666");
    EXPECT_EQ(outcome.err, unused.empty() ? "" : "dsc: " + name + ": not used: " + unused + "\n");
  }

  void expect_cause(const std::string& command, const std::string& name, const std::string& bytes,
                    const std::string& cause) {
    SCOPED_TRACE(name + ":\n" + bytes);
    write(name, bytes);
    const std::string arguments = command + ' ' + name;
    expect_error(arguments, 1);
    EXPECT_PRED2(contains, run(arguments).err, cause);
  }
};

TEST_F(Readers, skip_byte_order_marks_and_take_all_line_ends) {
  const std::string mark = "\xef\xbb\xbf";
  for (const std::string line_end : {"\n", "\r\n", "\r"}) {
    expect_tetrahedron("a.off", mark + with_line_ends("OFF\n4 4 6\n" + off_numbers, line_end));
    expect_tetrahedron("a.obj", mark + with_line_ends(obj, line_end));
    expect_tetrahedron("a.ply", mark + with_line_ends(ply, line_end));
    expect_tetrahedron("a.stl", mark + with_line_ends(stl(), line_end));
  }
  write("a.wkt", mark + "POLYGON ((0 0, 1 0, 0 1, 0 0))\n");
  expect_success("info a.wkt");
}

TEST_F(Readers, take_headers_of_other_programs) {
  expect_tetrahedron("a.off", "OFF4 4 6\n" + off_numbers);
  expect_tetrahedron("a.off", "OFF\n4 4\n" + off_numbers);
  expect_tetrahedron("a.off", "OFF\n4\n4\n6\n" + off_numbers);
  expect_tetrahedron("a.off", "OFF\n4 4 # no edges\n\n6\n" + off_numbers);
  expect_tetrahedron("a.stl", in_capitals(stl()));
  expect_tetrahedron("a.stl", binary_stl(4));
  expect_tetrahedron("a.obj", "v 0 0 0\nv 1 0 \\\n0\nv 0 1 0\nv 0 0 1\nf 1 \\\n3 2\nfo 1 2 4\n"
                              "f -4 -1 -2\nf 2 3 4\n");
}

TEST_F(Readers, name_what_they_do_not_use) {
  expect_tetrahedron("a.off",
                     "COFF\n4 4 6\n0 0 0 255 0 0\n1 0 0 255 0 0\n0 1 0 255 0 0\n"
                     "0 0 1 255 0 0\n3 0 2 1 9\n3 0 1 3 9\n3 0 3 2\n3 1 2 3\n",
                     "4 colors of points, 2 colors of polygons");
  expect_tetrahedron("a.off",
                     "NOFF\n5 5 6\n0 0 0 1 0 0\n1 0 0 1 0 0\n0 1 0 1 0 0\n0 0 1 1 0 0\n"
                     "5 5 5 1 0 0\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n2 0 1\nthe end\n",
                     "1 lines after the last polygon, 5 normals of points, "
                     "1 points without polygons, 1 polygons with fewer than three corners");
  expect_tetrahedron("a.obj",
                     "mtllib a.mtl\no a\ng b\ng c\nusemtl d\ns 1\nvt 0 0\nvn 0 0 1\nl 1 2\np 1\n"
                     "cstype bezier\n" +
                         obj,
                     "2 groups, 1 lines, 1 material files, 1 materials of polygons, 1 normals, "
                     "1 point elements, 1 smoothing groups, 1 statements 'cstype', "
                     "1 texture coordinates");
  expect_tetrahedron("a.ply",
                     "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float "
                     "y\nproperty float z\nproperty uchar red\nproperty uchar green\nproperty "
                     "float nx\nproperty float quality\nelement face 4\nproperty list uchar int "
                     "vertex_indices\nproperty int label\nelement edge 1\nproperty int "
                     "vertex1\nend_header\n0 0 0 1 1 0 5\n1 0 0 1 1 0 5\n0 1 0 1 1 0 5\n"
                     "0 0 1 1 1 0 5\n3 0 2 1 7\n3 0 1 3 7\n3 0 3 2 7\n3 1 2 3 7\n0\n",
                     "4 colors of points, 1 elements 'edge', 4 normals of points, "
                     "4 values 'label' of polygons, 4 values 'quality' of points");
  expect_tetrahedron("a.stl", binary_stl(4, 31) + "more",
                     "4 attributes of triangles, 4 bytes after the last triangle");
  const std::string text = stl();
  expect_tetrahedron("a.stl", text + "solid b\nendsolid b\n");

  write("a.off", "OFF\n4 4 6\n" + off_numbers + "the end");
  const std::string motion = " --axis 0,0,1 --angle 5 --steps 1";
  EXPECT_EQ(run("rotate a.off" + motion).err,
            "dsc: a.off: not used: 1 lines after the last polygon\n");
  EXPECT_EQ(run("rotate a.off --quiet" + motion).err, "");
}

TEST_F(Readers, refuse_what_would_change_the_surface) {
  expect_cause("info", "a.obj", obj + "surf 0 1 0 1 1 2 3 4\n",
               "line 9: 'surf' describes a surface");
  expect_cause("info", "a.obj", "call b.obj\n" + obj, "line 1: 'call'");
  expect_cause("info", "a.ply", "ply\nelement tristrips 1\n", "line 2: the element 'tristrips'");
  expect_cause("info", "a.off", "OFF\n4 3 6\n" + off_numbers, "line 10: the header announces 4");
  expect_cause("info", "a.off", "OFF\n4 5 6\n" + off_numbers, "is the file truncated?");
  expect_cause("info", "a.ply", ply + "3 0 1 2\n", "line 18: there are more numbers");
  expect_cause("info", "a.stl", binary_stl(3), "3 triangles and has bytes for 4");
  expect_cause("info", "a.stl", binary_stl(5), "5 triangles and lacks their last 50 bytes");
}

TEST_F(Readers, name_the_cause_of_an_error) {
  const std::vector<std::pair<std::string, std::string>> coordinates = {
      {"nan", "line 3: a coordinate of point 0 is not a finite number"},
      {"inf", "line 3: a coordinate of point 0 is not a finite number"},
      {"1,5", "line 3: '1,5' has a comma"},
      {"1e5000", "line 3: '1e5000' is too large"},
      {"0x10", "line 3: '0x10' is hexadecimal"},
      {"1d-3", "line 3: '1d-3' has a Fortran exponent"},
      {"one", "line 3: 'one' should be a number"}};
  for (const auto& [coordinate, cause] : coordinates)
    expect_cause("info", "a.off", "OFF\n1 1 0\n" + coordinate + " 0 0\n", cause);
  expect_cause("info", "a.off", "OFF\n3000000000 1 0\n",
               "line 2: '3000000000' should be an integer from -2147483648 to 2147483647");
  expect_cause("info", "a.off", "OFF\n1.5 1 0\n", "line 2: '1.5' should be an integer");
  expect_cause("info", "a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n",
               "line 6: polygon 0 refers to a point that does not exist");
  expect_cause("info", "a.stl", stl().substr(0, 70), "line 2: this facet does not end");
}

TEST_F(Readers, name_files_of_another_kind) {
  expect_cause("info", "a.off", "", "a.off is empty");
  expect_cause("info", "a.obj", std::string("\x1f\x8b\x08", 3), "decompress it with gunzip");
  expect_cause("info", "a.off", std::string("\xff\xfeO\0F\0F\0", 8), "save it in UTF-8");
  expect_cause("info", "a.off", ply, "is a PLY file; rename it to .ply");
  expect_cause("info", "a.obj", stl(), "is an STL file; rename it to .stl");
  expect_cause("info", "a.wkt", "OFF\n", "is an OFF file");
  expect_cause("reconstruct -o b.off", "a.xyz", "$MeshFormat\n", "is a Gmsh mesh");
  write("b.off", "OFF\n4 4 6\n" + off_numbers);
  write("b.dsc", "OFF\n4 4 6\n" + off_numbers);
  EXPECT_PRED2(contains, run("convert b.dsc c.ply").err, "is an OFF file");
  expect_success("convert b.off c.ply --quiet");
  expect_error("convert b.off c.vtu", 2);
  fs::create_directory(path("folder.off"));
  expect_error("info folder.off", 1);
  EXPECT_PRED2(contains, run("info folder.off").err, "it is a folder");
  EXPECT_PRED2(contains, run("info missing.off").err, "it does not exist");
}

TEST_F(Readers, tell_why_images_of_voxels_cannot_be_read) {
  const std::string rotate = "rotate --axis 0,0,1 --angle 5";
  const std::string header = inr_size + inr_type;
  for (const auto& [bytes, cause] : std::vector<std::pair<std::string, std::string>>{
           {inr(header, 6000), "lacks 2000 of the 8000 bytes"},
           {inr(inr_type, 0), "has no XDIM"},
           {inr(inr_size + "TYPE=unsigned fixed\nPIXSIZE=64 bits\nCPU=decm\n", 0), "'64 bits'"},
           {inr(inr_size + "TYPE=complex\nPIXSIZE=8 bits\nCPU=decm\n", 0), "type 'complex'"},
           {inr(header + "VX=0\n", 8000), "VX is not positive"},
           {inr("XDIM=0\nYDIM=20\nZDIM=20\n" + inr_type, 0), "has XDIM='0'"},
           {with_line_ends(inr(header, 8000), "\r\n"), "Windows line endings"},
           {"OFF\n4 4 6\n" + off_numbers, "does not begin with #INRIMAGE-4#{"},
           {"#INRIMAGE-4#{\n" + header, "without the line ##}"}})
    expect_cause(rotate, "a.inr", bytes, cause);
}

TEST_F(Readers, take_images_of_voxels_in_both_byte_orders) {
  const std::string size = "XDIM=3\nYDIM=1\nZDIM=1\n", // VDIM is 1 unless it is given
      type = "TYPE=unsigned fixed\nPIXSIZE=16 bits\n";
  for (const auto& [order, voxels] : std::vector<std::pair<std::string, std::string>>{
           {"decm", {'\2', '\1', '\7', '\0', '\7', '\0'}},
           {"sun", {'\1', '\2', '\0', '\7', '\0', '\7'}}}) {
    write("a.inr", inr(size + type + "CPU=" + order + "\n", 0) + voxels);
    const Outcome outcome = run("info a.inr");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_PRED2(contains, outcome.out, "label 7: 2 voxels\nlabel 258: 1 voxel");
  }
}

TEST_F(Readers, take_points_as_other_programs_write_them) {
  // Points of a box, so that there is a reconstruction; only the messages are tested.
  expect_cause("reconstruct -o b.off", "a.xyz", "5\n0 0 0\n1 0 0\n", "announces 5 points, but 2");
  expect_cause("reconstruct -o b.off", "a.xyz", "0 0 nan\n", "line 1: a coordinate of point 0");
  expect_cause("reconstruct -o b.off", "a.xyz", "0,0,1\n", "line 1: '0,0,1' has a comma");
}

} // namespace
