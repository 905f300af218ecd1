// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Translation.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <optional>
#include <sstream>

namespace dsc_files {
namespace {

using Names = std::vector<std::string>;

/// Returns the words between spaces.
Names words_of(const std::string& line) {
  std::istringstream in(line);
  return Names(std::istream_iterator<std::string>(in), std::istream_iterator<std::string>());
}

/// Returns the separator of the columns of a table; a space for any number of spaces.
char separator_of(const std::string& line) {
  for (const char separator : {';', '\t', ','})
    if (line.find(separator) != std::string::npos)
      return separator;
  return ' ';
}

/// Returns the cells of a row. With semicolons, commas are decimal points.
Names cells_of(std::string line, char separator) {
  if (!line.empty() && line.back() == '\r')
    line.pop_back();
  if (separator == ' ')
    return words_of(line);
  if (separator == ';')
    std::replace(line.begin(), line.end(), ',', '.');
  Names result;
  for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
    end = line.find(separator, begin);
    std::string cell = line.substr(begin, end == std::string::npos ? end : end - begin);
    cell.erase(0, cell.find_first_not_of(" \""));
    cell.erase(cell.find_last_not_of(" \"") + 1);
    result.push_back(cell);
  }
  return result;
}

/// Returns the number of a word, which may be nan or inf.
/// \throws Failure
double number_of(const std::string& word) {
  if (word.empty()) // a missing value
    return std::numeric_limits<double>::quiet_NaN();
  char* end = nullptr;
  const double result = std::strtod(word.c_str(), &end);
  if (*end != '\0')
    throw Failure("contains '" + word + "' instead of a number");
  return result;
}

/// The columns of points and of normals in a table.
class Point_columns
{
public:
  /// \param names names of the columns, in any case
  explicit Point_columns(const Names& names) : m_number(names.size()) {
    static const Names points[] = {{"x"}, {"y"}, {"z"}},
                       normals[] = {{"nx", "normal_x"}, {"ny", "normal_y"}, {"nz", "normal_z"}};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      m_columns[axis] = find(names, points[axis]);
      m_columns[axis + 3] = find(names, normals[axis]);
      if (m_columns[axis] == names.size())
        throw Failure("has no column x, y or z");
    }
    m_has_normals = *std::max_element(m_columns.begin() + 3, m_columns.end()) < names.size();
    for (std::size_t i = 0; i < names.size(); ++i)
      if (std::find(m_columns.begin(), m_columns.begin() + (m_has_normals ? 6 : 3), i) ==
          m_columns.begin() + (m_has_normals ? 6 : 3))
        m_unused.push_back("column (" + names[i] + ')');
  }

  /// Opens the translation.
  void open(const std::string& folder) {
    m_result.path = folder + (m_has_normals ? "/points.pwn" : "/points.xyz");
    m_out.emplace(m_result.path);
  }

  /// Writes the point of a row. Only its columns must be numbers.
  void add(const Names& cells) {
    require_length(cells.size());
    std::vector<double> row(cells.size(), 0);
    for (std::size_t i = 0; i < (m_has_normals ? 6U : 3U); ++i)
      row[m_columns[i]] = number_of(cells[m_columns[i]]);
    add(row);
  }
  void add(const std::vector<double>& row) {
    require_length(row.size());
    const auto is_finite = [&](std::size_t column) {
      return std::isfinite(row[m_columns[column]]);
    };
    if (!(is_finite(0) && is_finite(1) && is_finite(2))) {
      ++m_left_out;
      return;
    }
    for (std::size_t i = 0; i < (m_has_normals ? 6U : 3U); ++i)
      *m_out << (i == 0 ? "" : " ") << (is_finite(i) ? row[m_columns[i]] : 0.);
    *m_out << '\n';
  }

  /// Ends the translation.
  Translation close() {
    m_out->close();
    m_result.unused = m_unused;
    m_result.leave_out(m_left_out, "point that is not finite", "points that are not finite");
    return m_result;
  }

private:
  void require_length(std::size_t length) const {
    if (length != m_number)
      throw Failure("has a row with " + std::to_string(length) + " values instead of " +
                    std::to_string(m_number));
  }

  static std::size_t find(const Names& names, const Names& known) {
    const auto is_known = [&](std::string name) {
      std::transform(name.begin(), name.end(), name.begin(),
                     [](unsigned char c) { return char(std::tolower(c)); });
      return std::find(known.begin(), known.end(), name) != known.end();
    };
    return std::size_t(std::find_if(names.begin(), names.end(), is_known) - names.begin());
  }

  std::size_t m_number; // of columns
  std::array<std::size_t, 6> m_columns;
  bool m_has_normals = false;
  std::size_t m_left_out = 0;
  Names m_unused;
  std::optional<Output_file> m_out;
  Translation m_result;
};

/// A field of the points of a PCD file.
struct Pcd_field
{
  std::size_t size;
  char type; ///< I, U or F
};

double read_number(std::istream& in, const Pcd_field& field) {
  char bytes[8];
  if (!in.read(bytes, std::streamsize(field.size)))
    throw Failure("is truncated: it lacks points that its header announces");
  const auto as = [&](auto number) {
    std::memcpy(&number, bytes, sizeof number);
    return double(number);
  };
  switch (field.type) {
  case 'F':
    return field.size == 4 ? as(float()) : as(double());
  case 'U':
    return field.size == 1   ? as(std::uint8_t())
           : field.size == 2 ? as(std::uint16_t())
           : field.size == 4 ? as(std::uint32_t())
                             : as(std::uint64_t());
  default:
    return field.size == 1   ? as(std::int8_t())
           : field.size == 2 ? as(std::int16_t())
           : field.size == 4 ? as(std::int32_t())
                             : as(std::int64_t());
  }
}

constexpr auto none = static_cast<std::size_t>(-1);

std::size_t count_of(const std::string& word) {
  std::istringstream in(word);
  std::size_t result = 0;
  if (!(in >> result))
    throw Failure("has the number of points '" + word + "' in its header");
  return result;
}

/// The header of a PCD file.
struct Pcd_header
{
  Names names; ///< one for each number of a point
  std::vector<Pcd_field> fields;
  std::size_t points = none;
  std::string data; ///< ascii, binary or binary_compressed
};

Pcd_header read_header(std::istream& in) {
  Names fields, sizes, types, counts;
  Pcd_header header;
  for (std::string line; header.data.empty() && std::getline(in, line);) {
    Names words = words_of(line);
    if (words.empty() || words[0][0] == '#')
      continue;
    const std::string key = words[0];
    words.erase(words.begin());
    if (key == "FIELDS")
      fields = words;
    else if (key == "SIZE")
      sizes = words;
    else if (key == "TYPE")
      types = words;
    else if (key == "COUNT")
      counts = words;
    else if (key == "POINTS" && words.size() == 1)
      header.points = count_of(words[0]);
    else if (key == "DATA" && words.size() == 1)
      header.data = words[0];
  }
  if (header.data.empty() || header.points == none || fields.empty() ||
      sizes.size() != fields.size() || types.size() != fields.size() ||
      (!counts.empty() && counts.size() != fields.size()))
    throw Failure("has no complete PCD header");
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const double size = number_of(sizes[i]), count = counts.empty() ? 1 : number_of(counts[i]);
    if (!(size == 1 || size == 2 || size == 4 || size == 8) || !(count >= 0 && count <= 1024) ||
        (types[i] == "F" && size < 4))
      throw Failure("has an unknown type of the field " + fields[i]);
    for (int k = 0; k < int(count); ++k) {
      header.names.push_back(fields[i] + (count > 1 ? std::to_string(k) : ""));
      header.fields.push_back({std::size_t(size), types[i][0]});
    }
  }
  return header;
}

using Json = nlohmann::json;

/// Writes items in parentheses, with commas between them.
template <class Write> void write_list(const Json& items, Output_file& out, const Write& write) {
  const char* separator = "(";
  for (const Json& item : items) {
    out << separator;
    write(item);
    separator = ", ";
  }
  out << ')';
}

/// Writes the rings of a polygon.
void write_rings(const Json& rings, Output_file& out) {
  write_list(rings, out, [&](const Json& ring) {
    write_list(ring, out, [&](const Json& point) {
      out << point.at(0).get<double>() << ' ' << point.at(1).get<double>();
    });
  });
}

/// Writes a geometry. Returns the number of its parts that are no polygons.
std::size_t write_geometry(const Json& geometry, Output_file& out) {
  if (geometry.is_null())
    return 0;
  const std::string type = geometry.at("type");
  std::size_t others = 0;
  if (type == "Polygon") {
    out << "POLYGON ";
    write_rings(geometry.at("coordinates"), out);
    out << '\n';
  } else if (type == "MultiPolygon") { // one region: its polygons share a label
    out << "MULTIPOLYGON ";
    write_list(geometry.at("coordinates"), out,
               [&](const Json& polygon) { write_rings(polygon, out); });
    out << '\n';
  } else if (type == "GeometryCollection") {
    for (const Json& part : geometry.at("geometries"))
      others += write_geometry(part, out);
  } else {
    others = 1;
  }
  return others;
}

} // namespace

Translation translate_csv(const Options& options) {
  std::ifstream in(options.input);
  std::string line;
  if (!std::getline(in, line))
    throw Failure("is empty");
  const char separator = separator_of(line);
  const Names first = cells_of(line, separator);
  const bool has_names = std::any_of(first.begin(), first.end(), [](const std::string& cell) {
    return !cell.empty() && std::isalpha(static_cast<unsigned char>(cell[0])) != 0 &&
           cell != "nan" && cell != "inf";
  });
  Names names = first;
  if (!has_names) {
    if (first.size() != 3 && first.size() != 6)
      throw Failure("has no names of columns, and neither three nor six columns");
    names = {"x", "y", "z", "nx", "ny", "nz"};
    names.resize(first.size());
  }
  Point_columns columns(names);
  columns.open(options.folder);
  if (!has_names)
    columns.add(first);
  while (std::getline(in, line))
    if (line.find_first_not_of(" \t\r") != std::string::npos)
      columns.add(cells_of(line, separator));
  return columns.close();
}

Translation translate_pcd(const Options& options) {
  std::ifstream in(options.input, std::ios::binary);
  const Pcd_header header = read_header(in);
  Point_columns columns(header.names);
  columns.open(options.folder);
  if (header.data != "ascii" && header.data != "binary")
    throw Failure("has the data format " + header.data + "; write ascii or binary");
  for (std::size_t i = 0; i < header.points; ++i) {
    if (header.data == "ascii") {
      std::string line;
      if (!std::getline(in, line))
        throw Failure("is truncated: it lacks points that its header announces");
      columns.add(words_of(line));
    } else {
      std::vector<double> row;
      for (const Pcd_field& field : header.fields)
        row.push_back(read_number(in, field));
      columns.add(row);
    }
  }
  Translation result = columns.close();
  if (std::string word; in >> word)
    result.unused.push_back("content after the last point");
  return result;
}

Translation translate_geojson(const Options& options) {
  Translation result;
  result.path = options.folder + "/regions.wkt";
  Output_file out(result.path);
  std::size_t others = 0;
  try {
    static constexpr int deepest = 64; // parts are written by recursion
    const Json json = Json::parse(std::ifstream(options.input), [](int depth, auto, const Json&) {
      if (depth > deepest)
        throw Failure("is nested more than 64 levels deep; is it damaged?");
      return true;
    });
    const std::string type = json.at("type");
    if (json.dump().find("\"properties\":{\"") != std::string::npos)
      result.unused.push_back("properties of features");
    if (type == "FeatureCollection")
      for (const Json& feature : json.at("features"))
        others += write_geometry(feature.at("geometry"), out);
    else
      others = write_geometry(type == "Feature" ? json.at("geometry") : json, out);
  } catch (const Json::exception& error) {
    const std::string message = error.what(); // begins with its number in brackets
    throw Failure("is not valid GeoJSON: " + message.substr(message.find("] ") + 2));
  }
  if (out.tellp() == std::streampos(0))
    throw Failure("contains no polygons; give regions as polygons");
  result.leave_out(others, "geometry that is no polygon", "geometries that are no polygons");
  out.close();
  return result;
}

} // namespace dsc_files
