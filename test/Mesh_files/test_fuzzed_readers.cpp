#include "mutations.h"
#include "small_meshes.h"
#include "temporary_folder.h"
#include "test.h"
#include "whole_files.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_2.h>
#include <CGAL/Mesh_files/File_error.h>
#include <CGAL/Mesh_files/MEDIT_3.h>
#include <CGAL/Mesh_files/VTU_3.h>
#include <CGAL/Mesh_files/checkpoint.h>
#include <CGAL/Mesh_files/labeled_curves_2.h>
#include <CGAL/Mesh_files/labeled_image_2.h>
#include <CGAL/Mesh_files/labeled_surface_3.h>
#include <CGAL/Mesh_files/point_set_3.h>
#include <CGAL/Mesh_support/Error.h>

#include <atomic>
#include <exception>
#include <iostream>
#include <new>

// Readers accept any input: they read a damaged file or throw an exception of the package. They
// print nothing, and the memory depends on the size of the file, not on sizes that the file
// announces.

// Counting of memory

namespace {

std::atomic<std::size_t> memory_in_use{0}, peak_of_memory{0};
constexpr std::size_t memory_header = alignof(std::max_align_t);

} // namespace

void* operator new(std::size_t size) {
  void* const block = std::malloc(memory_header + size);
  if (block == nullptr)
    throw std::bad_alloc();
  *static_cast<std::size_t*>(block) = size;
  const std::size_t in_use = memory_in_use += size;
  for (std::size_t peak = peak_of_memory;
       peak < in_use && !peak_of_memory.compare_exchange_weak(peak, in_use);)
    continue;
  return static_cast<char*>(block) + memory_header;
}

// The library of tests uses this form in some versions.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  try {
    return operator new(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

void operator delete(void* memory) noexcept {
  if (memory == nullptr)
    return;
  void* const block = static_cast<char*>(memory) - memory_header;
  memory_in_use -= *static_cast<std::size_t*>(block);
  std::free(block);
}

void operator delete(void* memory, std::size_t) noexcept { operator delete(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { operator delete(memory); }

namespace {

namespace internal = CGAL::Deformable_simplicial_complexes::internal;
using internal::Encoding;
using namespace whole_files;

std::string checkpoint() {
  const Temporary_folder folder;
  const auto dsc = small_meshes::make_complex(small_meshes::grid(2, small_meshes::four_phases));
  CGAL::IO::write_checkpoint(folder / "a.dsc", dsc.state(), "metadata");
  return file_bytes(folder / "a.dsc");
}

// A format: how it is read, and sample files.
struct Format
{
  std::string name, extension;
  std::vector<std::string> files;
  std::function<void(const std::string& path)> read;
};

void read_surface(const std::string& path) { CGAL::IO::read_labeled_surface(path); }

template <class Read> void read_tetrahedra(const std::string& path, const Read& read) {
  small_meshes::Labeled_mesh mesh;
  read(path, mesh.points, mesh.tetrahedra, mesh.labels);
}

void read_medit(const std::string& path) {
  read_tetrahedra(path, [](auto&... arguments) { CGAL::IO::read_MEDIT(arguments...); });
}

void read_vtu(const std::string& path) {
  read_tetrahedra(path, [](auto&... arguments) { CGAL::IO::read_VTU(arguments...); });
}

void read_checkpoint(const std::string& path) {
  small_meshes::Complex().restore(CGAL::IO::read_checkpoint(path).state);
}

// In the plane, complexes are built, too: builders must accept everything that readers accept.

using Planar_complex = CGAL::Deformable_simplicial_complex_2<>;

// Many curves through the same points take a minute with sanitizers, so only the long runs
// of scripts/check_more.sh build them.
void build_from_wkt(const std::string& path) {
  static constexpr std::size_t many_segments = 300;
  const auto curves = CGAL::IO::read_labeled_curves(path);
  std::size_t n = 0;
  for (const auto& curve : curves)
    n += curve.segments.size();
  if (n < many_segments || std::getenv("DSC_FUZZ_MUTATIONS") != nullptr)
    DSC::make_deformable_simplicial_complex_2<Planar_complex>(curves);
}

void build_from_poly(const std::string& path) {
  DSC::make_deformable_simplicial_complex_2<Planar_complex>(CGAL::IO::read_seeded_segments(path));
}

void read_planar_checkpoint(const std::string& path) {
  Planar_complex().restore(CGAL::IO::read_checkpoint_2(path).state);
}

const char* const wkt = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 1, 2 2, 1 2, 1 1))\n"
                        "MULTIPOLYGON (((4 0, 6 0, 6 1, 4 0)), ((5 2, 6 2, 6 3, 5 2)))\n"
                        "LINESTRING (7 0, 8.5 0, 8 1e0, 7 0)\n";

const char* const poly = "# a square of two halves\n6 2 1 1\n1 0 0 9 1\n2 2 0 9 1\n3 2 2 9 1\n"
                         "4 0 2 9 1\n5 1 0 9 0\n6 1.25 2 9 0\n7 1\n1 1 5 1\n2 5 2 1\n3 2 3 1\n"
                         "4 3 6 1\n5 6 4 1\n6 4 1 1\n7 5 6\n1\n1 1.5 .1\n1\n1 .1 1.5 7 -1\n";

const char* const pgm = "P2\n# comment\n4 3\n300\n0 1 2 3\n4 5 300 7\n8 9 10 11\n";

std::string planar_checkpoint() {
  const Temporary_folder folder;
  write_bytes(folder / "a.wkt", wkt);
  const auto dsc = DSC::make_deformable_simplicial_complex_2<Planar_complex>(
      CGAL::IO::read_labeled_curves(folder / "a.wkt"));
  CGAL::IO::write_checkpoint(folder / "a.dsc", dsc.state(), "metadata");
  return file_bytes(folder / "a.dsc");
}

// Collects the output that is printed during its lifetime.
class Printed
{
public:
  Printed() : m_out(std::cout.rdbuf(m_text.rdbuf())), m_err(std::cerr.rdbuf(m_text.rdbuf())) {}
  ~Printed() {
    std::cout.rdbuf(m_out);
    std::cerr.rdbuf(m_err);
  }

  std::string text() const { return m_text.str(); }

private:
  std::ostringstream m_text;
  std::streambuf* m_out;
  std::streambuf* m_err;
};

// Returns the peak memory of reading the bytes.
std::size_t memory_of_reading(const Format& format, const std::string& bytes) {
  const Temporary_folder folder;
  const std::string path = folder / ("a" + format.extension);
  write_bytes(path, bytes);
  const std::size_t memory_before = memory_in_use;
  peak_of_memory = memory_before;
  EXPECT_THROW(format.read(path), CGAL::Deformable_simplicial_complexes::File_error) << bytes;
  return peak_of_memory - memory_before;
}

std::size_t number_of_mutations(std::size_t in_a_test) {
  const char* const wanted = std::getenv("DSC_FUZZ_MUTATIONS");
  return wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : in_a_test;
}

// Damages files of a format and reads them.
void expect_survival(const Format& format,
                     const std::function<std::string(std::string)>& finish = nullptr) {
  constexpr std::size_t free_memory = std::size_t{64} << 20, copies_of_file = 10;
  constexpr std::size_t mutations_in_a_test = 400;
  const std::size_t n = number_of_mutations(mutations_in_a_test);
  const Temporary_folder folder;
  const std::string path = folder / ("a" + format.extension);
  std::size_t number_read = 0, largest_excess = 0;

  for (const std::string& file : format.files) {
    write_bytes(path, file);
    EXPECT_NO_THROW(format.read(path)) << format.name;
  }
  for (std::size_t i = 0; i < n; ++i) {
    std::string bytes = Mutator(i)(format.files[i % format.files.size()]);
    if (finish)
      bytes = finish(bytes);
    write_bytes(path, bytes);
    SCOPED_TRACE(format.name + ", mutation " + std::to_string(i));
    const std::size_t memory_before = memory_in_use;
    peak_of_memory = memory_before;
    const Printed printed;
    try {
      format.read(path);
      ++number_read;
    } catch (const CGAL::Deformable_simplicial_complexes::Error& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.find('\n'), message.npos) << message;
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what();
    }
    const std::size_t memory = peak_of_memory - memory_before;
    EXPECT_LE(memory, free_memory + copies_of_file * bytes.size());
    EXPECT_EQ(printed.text(), "");
    largest_excess = (std::max)(largest_excess, memory - (std::min)(memory, bytes.size()));
  }
  if (std::getenv("DSC_FUZZ_MUTATIONS") != nullptr)
    std::cout << "| " << format.name << " | " << n << " | " << number_read << " | "
              << n - number_read << " | " << largest_excess / 1024 << " KiB |" << std::endl;
}

} // namespace

// Whole files

TEST(Surface_formats, agree) {
  const Temporary_folder folder;
  const auto read = [&](const std::string& extension, const std::string& bytes) {
    write_bytes(folder / ("a" + extension), bytes);
    return CGAL::IO::read_labeled_surface(folder / ("a" + extension));
  };
  const auto expect_equal = [](const auto& a, const auto& b) {
    EXPECT_EQ(a.points, b.points);
    EXPECT_EQ(a.triangles, b.triangles);
  };
  const auto prism = read(".off", off("", 0, false));
  EXPECT_EQ(prism.points.size(), 12u);
  EXPECT_EQ(prism.points[10], small_meshes::Point(1, 2, 1));
  EXPECT_EQ(prism.triangles.size(), 20u);
  expect_equal(prism, read(".off", off("C", 4, false)));
  expect_equal(prism, read(".off", off("STCN4", 10, false)));
  expect_equal(prism, read(".off", off("", 0, true)));
  expect_equal(prism, read(".off", off("STCN", 9, true)));
  expect_equal(prism, read(".obj", obj()));
  for (const Encoding encoding : {Encoding::text, Encoding::little_endian, Encoding::big_endian})
    expect_equal(prism, read(".ply", ply(encoding)));
  const auto triangles = read(".stl", stl(false));
  EXPECT_EQ(triangles.points.size(), 12u);
  EXPECT_EQ(triangles.triangles.size(), 8u);
  expect_equal(triangles, read(".stl", stl(true)));
}

TEST(Surface_formats, numbers_in_ply_may_have_any_type) {
  const Temporary_folder folder;
  for (const std::string type :
       {"char", "uchar", "short", "ushort", "int", "uint", "float", "double", "int8", "uint8",
        "int16", "uint16", "int32", "uint32", "float32", "float64"}) {
    write_bytes(folder / "a.ply",
                "ply\nformat ascii 1.0\nelement vertex 3\nproperty " + type + " x\nproperty " +
                    type + " y\nproperty " + type + " z\nelement faces 1\nproperty list " + type +
                    " " + type + " vertex_index\nend_header\n0 0 0\n1 0 0\n0 1 100\n3 0 1 2\n");
    const auto surface = CGAL::IO::read_labeled_surface(folder / "a.ply");
    EXPECT_EQ(surface.points[2], small_meshes::Point(0, 1, 100)) << type;
    EXPECT_EQ(surface.triangles.size(), 1u) << type;
  }
}

// Malicious files

TEST(Fuzzed_readers, announced_elements_take_no_memory) {
  constexpr std::size_t little_memory = 1 << 20;
  const std::string many = " 2000000000 ", ply_begin = "ply\nformat ascii 1.0\nelement vertex";
  const std::string huge(4, '\x7f');
  const Format off_format{"", ".off", {}, read_surface}, ply_format{"", ".ply", {}, read_surface},
      stl_format{"", ".stl", {}, read_surface}, medit_format{"", ".mesh", {}, read_medit},
      vtu_format{"", ".vtu", {}, read_vtu};
  for (const auto& [format, bytes] : std::vector<std::pair<Format, std::string>>{
           {off_format, "OFF" + many + "1 0\n0 0 0\n"},
           {off_format, "OFF 1" + many + "0\n0 0 0\n"},
           {off_format, "OFF 1 1 0\n0 0 0\n" + many},
           {off_format, "OFF BINARY\n" + huge + huge + huge + "0000"},
           {ply_format, ply_begin + many +
                            "\nproperty int x\nproperty int y\nproperty int z\n"
                            "end_header\n0 0 0\n"},
           {ply_format, ply_begin + " 0\nelement face 99999999999999\nend_header\n"},
           {ply_format, ply_begin + " 0\nelement none 99999999999999\nend_header\n"},
           {stl_format, std::string(80, ' ') + huge + std::string(100, '0')},
           {medit_format, "MeshVersionFormatted 2\nDimension 3\nVertices" + many},
           {vtu_format, "<VTKFile type='UnstructuredGrid'><UnstructuredGrid><Piece NumberOfPoints="
                        "'2000000000' NumberOfCells='2000000000'/></UnstructuredGrid></VTKFile>"}})
    EXPECT_LT(memory_of_reading(format, bytes), little_memory) << bytes;
}

// A star whose sides intersect half of the other sides.
TEST(Fuzzed_readers, polygons_that_meet_themselves_take_no_memory) {
  constexpr std::size_t little_memory = 1 << 20;
  constexpr int n = 999;
  std::ostringstream file;
  file << "OFF " << n << " 1 0\n";
  for (int i = 0; i < n; ++i)
    file << std::cos(2 * CGAL_PI * i / n) << ' ' << std::sin(2 * CGAL_PI * i / n) << " 0\n";
  file << n;
  for (int i = 0; i < n; ++i)
    file << ' ' << i * 250 % n;
  EXPECT_LT(memory_of_reading({"", ".off", {}, read_surface}, file.str()), little_memory);
}

// Corners on a few lines and circles, in planes without exact coordinates.
TEST(Fuzzed_readers, polygons_become_triangles_or_are_refused) {
  std::mt19937_64 random(1);
  const auto any_of = [&](std::size_t n) { return static_cast<double>(random() % n); };
  std::size_t number_of_triangulated = 0;
  for (int i = 0; i < 20000; ++i) {
    const std::size_t n = 5 + random() % 8;
    const double a = any_of(1000) / 999, b = any_of(1000) / 999, noise = std::pow(10, -any_of(20));
    std::vector<small_meshes::Point> corners;
    for (std::size_t j = 0; j < n; ++j) {
      const double angle = 2 * CGAL_PI * double(j) / double(n), radius = (1 + any_of(3)) / 3,
                   x = i % 2 == 0 ? any_of(4) : radius * std::cos(angle),
                   y = i % 2 == 0 ? any_of(4) : radius * std::sin(angle);
      corners.emplace_back(x, y, a * x + b * y + noise * any_of(2));
    }
    const auto triangles = internal::triangulated_polygon(corners);
    if (!triangles.empty()) {
      ++number_of_triangulated;
      EXPECT_EQ(triangles.size(), n - 2) << i;
    }
  }
  EXPECT_GT(number_of_triangulated, 5000u);
}

// Mutations: | format | mutations | read | refused | peak memory above the file's size |

TEST(Fuzzed_readers, off) {
  expect_survival({"OFF, text",
                   ".off",
                   {off("", 0, false), off("C", 4, false), off("STCN4", 10, false)},
                   read_surface});
}

TEST(Fuzzed_readers, off_binary) {
  expect_survival({"OFF, binary", ".off", {off("", 0, true), off("CN", 7, true)}, read_surface});
}

TEST(Fuzzed_readers, obj) { expect_survival({"OBJ", ".obj", {obj()}, read_surface}); }

TEST(Fuzzed_readers, stl) { expect_survival({"STL, text", ".stl", {stl(false)}, read_surface}); }

TEST(Fuzzed_readers, stl_binary) {
  expect_survival({"STL, binary", ".stl", {stl(true)}, read_surface});
}

TEST(Fuzzed_readers, ply) {
  expect_survival({"PLY, text", ".ply", {ply(Encoding::text)}, read_surface});
}

TEST(Fuzzed_readers, ply_binary) {
  expect_survival({"PLY, binary",
                   ".ply",
                   {ply(Encoding::little_endian), ply(Encoding::big_endian)},
                   read_surface});
}

TEST(Fuzzed_readers, vtu) {
  expect_survival({"VTU, text and base64",
                   ".vtu",
                   {vtu("ascii", "UInt32"), vtu("binary", "UInt32")},
                   read_vtu});
}

TEST(Fuzzed_readers, vtu_appended) {
  expect_survival(
      {"VTU, appended", ".vtu", {vtu("raw", "UInt64"), vtu("base64", "UInt32")}, read_vtu});
}

TEST(Fuzzed_readers, medit) { expect_survival({"MEDIT", ".mesh", {medit}, read_medit}); }

TEST(Fuzzed_readers, checkpoint) {
  expect_survival({"checkpoint", ".dsc", {checkpoint()}, read_checkpoint});
}

TEST(Fuzzed_readers, signed_checkpoint) {
  expect_survival({"checkpoint, checksum corrected", ".dsc", {checkpoint()}, read_checkpoint},
                  signed_checkpoint);
}

TEST(Fuzzed_readers, well_known_text) {
  expect_survival({"well-known text", ".wkt", {wkt}, build_from_wkt});
}

TEST(Fuzzed_readers, poly) {
  expect_survival({"Triangle's .poly", ".poly", {poly}, build_from_poly});
}

TEST(Fuzzed_readers, pgm) {
  expect_survival(
      {"PGM",
       ".pgm",
       {pgm, std::string("P5 4 3 255\n0123456789ab"), std::string("P5 2 1 999\n\1\2\3\3")},
       [](const std::string& path) { CGAL::IO::read_labeled_image(path); }});
}

TEST(Fuzzed_readers, points) {
  const auto read = [](const std::string& path) { CGAL::IO::read_point_set(path); };
  expect_survival(
      {"points as text",
       ".xyz",
       {std::string("1 2 3\n4 5 6\n"), std::string("2\n1 2 3 0 0 1 # a comment\n4 5 6 1 0 0\n")},
       read});
  expect_survival({"points in PLY",
                   ".ply",
                   {std::string("ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
                                "property float y\nproperty float z\nproperty float nx\n"
                                "property float ny\nproperty float nz\nend_header\n"
                                "1 2 3 1 0 0\n4 5 6 0 0 1\n")},
                   read});
  expect_survival(
      {"points in OFF", ".off", {std::string("NOFF\n2 0 0\n1 2 3 1 0 0\n4 5 6 0 0 1\n")}, read});
}

TEST(Fuzzed_readers, planar_checkpoint) {
  expect_survival({"planar checkpoint", ".dsc", {planar_checkpoint()}, read_planar_checkpoint});
}

TEST(Fuzzed_readers, signed_planar_checkpoint) {
  expect_survival({"planar checkpoint, checksum corrected",
                   ".dsc",
                   {planar_checkpoint()},
                   read_planar_checkpoint},
                  signed_checkpoint);
}
