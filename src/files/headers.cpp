// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_dataset.h"

#include <CGAL/Mesh_files/internal/text/files.h>

#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>

#include <sys/resource.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <iostream>

namespace dsc_files {
namespace {

namespace fs = std::filesystem;
namespace internal = CGAL::Deformable_simplicial_complexes::internal;

void limit(int resource, double bound) {
  rlimit limits = {};
  getrlimit(resource, &limits);
  limits.rlim_cur = (std::min)(limits.rlim_max, rlim_t((std::min)(bound, 1e18)));
  setrlimit(resource, &limits);
}

/// Returns a number in an attribute of an element; 0 if there is none.
double number_in(vtkXMLDataElement* element, const char* attribute) {
  const char* const text = element->GetAttribute(attribute);
  return text == nullptr ? 0 : (std::max)(0., std::strtod(text, nullptr));
}

/// Ends this process at deeply nested elements, since VTK visits elements by recursion.
class Shallow_parser : public vtkXMLDataParser
{
public:
  static Shallow_parser* New();
  vtkTypeMacro(Shallow_parser, vtkXMLDataParser);

protected:
  void StartElement(const char* name, const char** attributes) override {
    static constexpr int deepest = 64;
    if (++m_depth > deepest)
      end_process("has elements that are nested more than 64 levels deep; is it damaged?");
    vtkXMLDataParser::StartElement(name, attributes);
  }
  void EndElement(const char* name) override {
    --m_depth;
    vtkXMLDataParser::EndElement(name);
  }

private:
  int m_depth = 0;
};
vtkStandardNewMacro(Shallow_parser);

/// The numbers of points and of cells in a part of an image.
struct Sizes
{
  double points = 1, cells = 1;

  explicit Sizes(const char* extent) {
    for (int axis = 0; axis < 3; ++axis) {
      char* rest = nullptr;
      const double first = std::strtod(extent, &rest), last = std::strtod(rest, &rest);
      extent = rest;
      points *= (std::max)(0., last - first + 1);
      cells *= (std::max)(1., last - first);
    }
  }
};

/// Reads the elements of an XML file of VTK.
class Xml_header
{
public:
  Xml_header(const std::string& path, bool may_name_files, Header& header)
      : m_path(path), m_may_name_files(may_name_files), m_header(header) {
    vtkNew<Shallow_parser> parser;
    parser->SetFileName(path.c_str());
    if (parser->Parse() == 0 || parser->GetRootElement() == nullptr)
      throw Failure("is or names a file that is no valid XML file of VTK; is it truncated?");
    visit(parser->GetRootElement(), 0);
    // VTK leaves the values of an image undefined where there is no piece.
    if (m_cells != m_cells_of_pieces)
      throw Failure("has pieces that do not cover its extent; write one piece");
  }

private:
  void visit_piece(vtkXMLDataElement* piece) {
    m_points = number_in(piece, "NumberOfPoints");
    m_items = 0;
    for (const char* kind : {"Cells", "Verts", "Lines", "Strips", "Polys"})
      m_items += number_in(piece, (std::string("NumberOf") + kind).c_str());
    if (const char* const extent = piece->GetAttribute("Extent")) {
      m_points = Sizes(extent).points;
      m_cells_of_pieces += m_items = Sizes(extent).cells;
    }
  }

  /// \param items number of the items of the section around the element
  void visit(vtkXMLDataElement* element, double items) {
    const std::string name = element->GetName();
    if (const char* const whole = element->GetAttribute("WholeExtent"))
      m_cells += Sizes(whole).cells;
    if (name == "Piece")
      visit_piece(element);
    if (const char* const type = element->GetAttribute("type");
        type && (name == "DataArray" || name == "PDataArray")) {
      const double bits = std::strtod(type + std::strcspn(type, "0123456789"), nullptr);
      m_header.content += (1 + items + number_in(element, "NumberOfTuples")) * bits / 8 *
                          (std::max)(1., number_in(element, "NumberOfComponents"));
    }
    const char* const file = element->GetAttribute(name == "Piece" ? "Source" : "file");
    if (m_may_name_files && file != nullptr && (name == "Piece" || name == "DataSet")) {
      const std::string place = m_header.add(m_path, file);
      Xml_header(place, false, m_header);
    }
    items = name == "Points" || name == "PointData" ? m_points : name == "FieldData" ? 0 : m_items;
    for (int i = 0; i < element->GetNumberOfNestedElements(); ++i)
      visit(element->GetNestedElement(i), items);
  }

  const std::string& m_path;
  bool m_may_name_files;
  Header& m_header;
  double m_points = 0, m_items = 0; // of the present piece; the items are cells
  double m_cells = 0, m_cells_of_pieces = 0;
};

/// Returns the bytes of all files in a zip archive when they are decompressed.
double content_of_zip(const std::string& path) {
  std::ostringstream content;
  content << std::ifstream(path, std::ios::binary).rdbuf();
  const std::string bytes = content.str();
  static constexpr std::size_t place = 24; // of the size in an entry of the directory
  double result = 0;
  for (std::size_t at = 0; (at = bytes.find("PK\1\2", at)) != std::string::npos; at += 4)
    if (at + place + 4 <= bytes.size())
      for (std::size_t i = 0; i < 4; ++i)
        result += double(static_cast<unsigned char>(bytes[at + place + i])) * double(1U << 8 * i);
  return result;
}

} // namespace

void end_process(const std::string& message) {
  std::cerr << message << std::endl;
  std::_Exit(1); // without destructors
}

std::string Header::add(const std::string& path, const std::string& file) {
  const fs::path folder = fs::absolute(path).parent_path().lexically_normal(),
                 place = (folder / file).lexically_normal(),
                 below = place.lexically_relative(folder);
  if (file.find('%') != std::string::npos || file.compare(0, 4, "LIST") == 0)
    throw Failure("has its data in several files; write one file");
  if (below.empty() || *below.begin() == "..")
    throw Failure("names the file " + internal::in_quotes(file) +
                  ", which is outside of its folder; move it into the folder");
  std::error_code error;
  if (!fs::is_regular_file(place, error))
    throw Failure("has its data in the file " + internal::in_quotes(file) +
                  ", which cannot be opened; copy it into the same folder");
  bytes += fs::file_size(place);
  return place.string();
}

Header::Header(const std::string& path, const std::string& format) : bytes(fs::file_size(path)) {
  const bool is_meta_image = format == "mha" || format == "mhd";
  if (is_meta_image || format == "nrrd" || format == "nhdr") {
    const std::string file =
        header_value(path, is_meta_image ? '=' : ':', {"elementdatafile", "data file", "datafile"});
    if (!file.empty() && file != "LOCAL")
      add(path, file);
  } else if (format == "3mf") {
    content = content_of_zip(path);
  } else if (format.size() > 2 && format != "vtk" &&
             (format.compare(0, 2, "vt") == 0 || format.compare(0, 3, "pvt") == 0)) {
    Xml_header(path, format == "vtm" || format == "pvtu", *this);
  }
}

std::string header_value(const std::string& path, char separator,
                         std::initializer_list<const char*> keys) {
  std::ifstream file(path, std::ios::binary);
  for (std::string line; std::getline(file, line) && !line.empty() && line != "\r";) {
    const std::size_t mark = line.find(separator);
    std::string key = line.substr(0, mark);
    if (separator == '=') // a name of MetaImage is one word
      std::istringstream(line.substr(0, mark)) >> key;
    key.erase(key.find_last_not_of(" \t") + 1);
    std::transform(key.begin(), key.end(), key.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    if (mark != std::string::npos && std::find(keys.begin(), keys.end(), key) != keys.end()) {
      line.erase(0, line.find_first_not_of(" \t", mark + 1));
      return line.erase(line.find_last_not_of(" \t\r") + 1);
    }
    if (key == "elementdatafile")
      break;
  }
  return "";
}

void accept_content(double content, double bytes) {
  static constexpr double seconds = 4, bytes_per_second = 1 << 18, // of processor time
      memory = 5e8, memory_of_byte = 32;
  const std::string refusal = internal::why_too_large(content, bytes);
  if (!refusal.empty())
    throw Failure(refusal);
  static double accepted = 0;
  accepted += (std::max)(content, bytes);
  limit(RLIMIT_CPU, seconds + accepted / bytes_per_second);
#ifdef __linux__ // memory that is written; RLIMIT_AS would include the libraries
  limit(RLIMIT_DATA, memory + accepted * memory_of_byte);
#endif
}

} // namespace dsc_files
