#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_VTU_GRID_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_VTU_GRID_H

#include "test.h"

#include <CGAL/Mesh_files/internal/text/little_endian.h>

#include <iomanip>

// Files `.vtu` as other programs write them.
namespace vtu_grid {

using CGAL::Deformable_simplicial_complexes::internal::append_little_endian;

inline std::string base64(const std::string& bytes) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t j = 0; j < 3; ++j)
      bits = bits << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0);
    for (std::size_t j = 0; j < 4; ++j)
      text += i + j <= bytes.size() ? digits[bits >> (18 - 6 * j) & 63] : '=';
  }
  return text;
}

// The encoding of numbers in a grid.
struct Encoding
{
  std::string format = "ascii"; // or binary, raw, base64; raw and base64 are appended data
  std::string header_type = "UInt32";
  bool separates_header = false; // in base64: header and data are encoded separately
  std::string line_end = "\n";
};

// A grid as other programs write it, array by array.
class Grid
{
public:
  explicit Grid(Encoding encoding = {}) : m_encoding(std::move(encoding)) {}

  template <class Number>
  Grid& array(const std::string& section, const std::string& type, const std::string& name,
              const std::vector<Number>& values) {
    const std::string& end = m_encoding.line_end;
    const bool is_appended = m_encoding.format == "raw" || m_encoding.format == "base64";
    std::string& xml = m_sections[section];
    xml += "<DataArray type=\"" + type + "\" Name=\"" + name + "\" format=\"" +
           (is_appended ? "appended" : m_encoding.format) + "\"";
    if (is_appended)
      xml += " offset=\"" + std::to_string(m_data.size()) + "\"";
    xml += ">" + end;
    if (is_appended)
      m_data += block(values);
    else
      xml += (m_encoding.format == "ascii" ? text(values) : block(values)) + end;
    // as VTK writes them
    xml += "<InformationKey name=\"L2_NORM_RANGE\" location=\"vtkDataArray\" length=\"1\">" + end +
           "<Value index=\"0\">1.5</Value></InformationKey>" + end;
    xml += "</DataArray>" + end;
    return *this;
  }

  std::string text(const std::string& numbers_of_elements,
                   const std::string& more_attributes = "") const {
    const std::string& end = m_encoding.line_end;
    std::string result =
        "<?xml version=\"1.0\"?>" + end + "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" " +
        "header_type=\"" + m_encoding.header_type + "\" " + more_attributes + ">" + end +
        "<!-- a comment --><UnstructuredGrid>" + end + "<Piece " + numbers_of_elements + ">" + end;
    for (const auto& [section, xml] : m_sections)
      result += "<" + section + ">" + end + xml + "</" + section + ">" + end;
    result += "</Piece></UnstructuredGrid>" + end;
    if (!m_data.empty())
      result += "<AppendedData encoding=\"" + m_encoding.format + "\">" + end + "   _" + m_data +
                end + "</AppendedData>" + end;
    return result + "</VTKFile>" + end;
  }

private:
  template <class Number> static std::string text(const std::vector<Number>& values) {
    std::ostringstream out;
    out << std::setprecision(std::numeric_limits<double>::max_digits10);
    for (const Number value : values)
      out << ' ' << +value;
    return out.str();
  }

  template <class Number> std::string block(const std::vector<Number>& values) const {
    std::string header, bytes;
    for (const Number value : values)
      append_little_endian(bytes, value);
    if (m_encoding.header_type == "UInt64")
      append_little_endian(header, std::uint64_t(bytes.size()));
    else
      append_little_endian(header, std::uint32_t(bytes.size()));
    return m_encoding.format == "raw"    ? header + bytes
           : m_encoding.separates_header ? base64(header) + base64(bytes)
                                         : base64(header + bytes);
  }

  Encoding m_encoding;
  std::map<std::string, std::string> m_sections;
  std::string m_data;
};

} // namespace vtu_grid

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_VTU_GRID_H
