#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_WHOLE_FILES_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_WHOLE_FILES_H

#include "vtu_grid.h"

#include <CGAL/Mesh_files/internal/text/File_scanner.h>
#include <CGAL/Mesh_files/internal/text/little_endian.h>

#include <boost/crc.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

// Small files of all input formats, with optional content of each format.
namespace whole_files {

using CGAL::Deformable_simplicial_complexes::internal::append_little_endian;
using CGAL::Deformable_simplicial_complexes::internal::Encoding;

// A prism over an L-shaped hexagon.
inline const std::vector<std::vector<double>> points = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0},
                                                        {1, 2, 0}, {0, 2, 0}, {0, 0, 1}, {2, 0, 1},
                                                        {2, 1, 1}, {1, 1, 1}, {1, 2, 1}, {0, 2, 1}};
inline const std::vector<std::vector<int>> polygons = {
    {5, 4, 3, 2, 1, 0}, {6, 7, 8, 9, 10, 11}, {0, 1, 7, 6},   {1, 2, 8, 7},
    {2, 3, 9, 8},       {3, 4, 10, 9},        {4, 5, 11, 10}, {5, 0, 6, 11}};

template <class Number> std::string encoded(Encoding encoding, Number number) {
  if (encoding == Encoding::text) {
    std::ostringstream text;
    text << ' ' << +number;
    return text.str();
  }
  std::string bytes;
  append_little_endian(bytes, number);
  if (encoding == Encoding::big_endian)
    std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

// With this prefix of OFF, and these numbers after the coordinates of each point.
inline std::string off(const std::string& prefix, std::size_t numbers_behind, bool is_binary) {
  const Encoding encoding = is_binary ? Encoding::big_endian : Encoding::text;
  const std::string line_end = is_binary ? "" : "\n";
  std::string result = "# comment\n" + prefix + (is_binary ? "OFF BINARY\n" : "OFF\n");
  for (const std::size_t n : {points.size(), polygons.size(), std::size_t{0}})
    result += encoded(encoding, std::int32_t(n));
  result += line_end;
  for (const auto& p : points) {
    for (const double x : p)
      result += encoded(encoding, float(x));
    for (std::size_t i = 0; i < numbers_behind; ++i)
      result += encoded(encoding, 1.f);
    result += line_end;
  }
  for (const auto& polygon : polygons) {
    result += encoded(encoding, std::int32_t(polygon.size()));
    for (const int corner : polygon)
      result += encoded(encoding, std::int32_t(corner));
    result += is_binary ? encoded(encoding, std::int32_t(0)) : " 0.5 1 0 # colour\n";
  }
  return result;
}

inline std::string obj() {
  std::string result = "# comment\nmtllib a.mtl\no prism\n";
  for (const auto& p : points)
    result += "v" + encoded(Encoding::text, p[0]) + encoded(Encoding::text, p[1]) +
              encoded(Encoding::text, p[2]) + "\nvt 0 0.5\nvn 0 0 1\n";
  for (const auto& polygon : polygons) {
    result += "f";
    for (const int corner : polygon)
      result += corner % 2 == 0 ? " " + std::to_string(corner + 1) + "/1/2"
                                : " " + std::to_string(corner - 12);
    result += "\n";
  }
  return result;
}

inline std::string stl(bool is_binary) {
  const Encoding encoding = is_binary ? Encoding::little_endian : Encoding::text;
  std::string result =
      is_binary ? std::string(80, ' ') + encoded(encoding, std::uint32_t(8)) : "solid prism\n";
  for (const auto& polygon : polygons) {
    result += is_binary ? std::string(12, '\0') : "facet normal 0 0 1\nouter loop\n";
    for (std::size_t i = 0; i < 3; ++i) {
      result += is_binary ? "" : "vertex";
      for (const double x : points[std::size_t(polygon[i])])
        result += encoded(encoding, float(x));
      result += is_binary ? "" : "\n";
    }
    result += is_binary ? std::string(2, '\0') : "endloop\nendfacet\n";
  }
  return result + (is_binary ? "" : "endsolid prism\n");
}

inline std::string ply(Encoding encoding) {
  const std::string format = encoding == Encoding::text            ? "ascii"
                             : encoding == Encoding::little_endian ? "binary_little_endian"
                                                                   : "binary_big_endian",
                    line_end = encoding == Encoding::text ? "\n" : "";
  std::string result = "ply\nformat " + format +
                       " 1.0\ncomment a prism\nelement vertex 12\nproperty double x\n"
                       "property float y\nproperty float64 z\nproperty uchar red\n"
                       "element note 1\nproperty list ushort short text\n"
                       "element face 8\nproperty list uchar int vertex_indices\n"
                       "property int16 label\nend_header\n";
  for (const auto& p : points)
    result += encoded(encoding, p[0]) + encoded(encoding, float(p[1])) + encoded(encoding, p[2]) +
              encoded(encoding, std::uint8_t(200)) + line_end;
  result += encoded(encoding, std::uint16_t(2)) + encoded(encoding, std::int16_t(-1)) +
            encoded(encoding, std::int16_t(1)) + line_end;
  for (const auto& polygon : polygons) {
    result += encoded(encoding, std::uint8_t(polygon.size()));
    for (const int corner : polygon)
      result += encoded(encoding, std::int32_t(corner));
    result += encoded(encoding, std::int16_t(7)) + line_end;
  }
  return result;
}

inline std::string vtu(const std::string& format, const std::string& header_type) {
  vtu_grid::Encoding encoding;
  encoding.format = format;
  encoding.header_type = header_type;
  vtu_grid::Grid grid(encoding);
  grid.array("Points", "Float64", "points",
             std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1})
      .array("Cells", "Int64", "connectivity", std::vector<std::int64_t>{0, 1, 2, 3, 1, 2, 3, 4})
      .array("Cells", "Int32", "offsets", std::vector<std::int32_t>{4, 8})
      .array("Cells", "UInt8", "types", std::vector<std::uint8_t>{10, 10})
      .array("CellData", "Int16", "label", std::vector<std::int16_t>{3, -7});
  return grid.text("NumberOfPoints=\"5\" NumberOfCells=\"2\"");
}

inline const std::string medit =
    "MeshVersionFormatted 2\n# comment\nDimension 3\nVertices\n5\n0 0 0 0\n"
    "1 0 0 0\n0 1 0 0\n0 0 1 0\n1 1 1 0\nEdges 1\n1 2 5\nTetrahedra\n2\n"
    "1 2 3 4 3\n2 3 4 5 -7\nEnd\n";

// The bytes of a checkpoint before its metadata.
constexpr std::size_t checkpoint_header_size = 24;

// Returns the bytes of a checkpoint with a correct size and checksum, so that the reader examines
// them.
inline std::string signed_checkpoint(std::string bytes) {
  constexpr std::size_t begin_of_checksum = 12;
  if (bytes.size() < checkpoint_header_size)
    return bytes;
  const std::string payload = bytes.substr(checkpoint_header_size);
  boost::crc_32_type crc;
  crc.process_bytes(payload.data(), payload.size());
  bytes.resize(begin_of_checksum);
  append_little_endian(bytes, std::uint32_t(crc.checksum()));
  append_little_endian(bytes, std::uint64_t(payload.size()));
  return bytes + payload;
}

} // namespace whole_files

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_WHOLE_FILES_H
