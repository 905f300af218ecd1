// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/formats.h"

#include "input/files.h"
#include "input/translations.h"
#include "programs/errors.h"

#include <CGAL/Mesh_files/internal/text/files.h>

#include <cstring>

namespace dsc {
namespace {

/// The contents of formats: what is read and written by `dsc`, and through `dsc-files`.
struct Formats
{
  const char* extensions; ///< between spaces
  unsigned read, read_by_files, written, written_by_files;
};

const auto& all_formats() {
  using namespace content;
  constexpr unsigned image = voxels | pixels, cells = tetrahedra | surface | regions | points;
  static constexpr Formats result[] = {{" off ply ", surface | points, 0, surface, 0},
                                       {" obj stl ", surface, 0, surface, 0},
                                       {" mesh ", tetrahedra, 0, tetrahedra, 0},
                                       {" vtu ", tetrahedra | states, surface | regions | points,
                                        tetrahedra | regions | triangles, 0},
                                       {" inr ", voxels, 0, 0, image},
                                       {" inr.gz ", voxels, 0, 0, 0},
                                       {" wkt poly ", regions, 0, regions, 0},
                                       {" pgm ", pixels, 0, 0, 0},
                                       {" png ", pixels, pixels, picture, pixels},
                                       {" svg ", 0, 0, regions | drawing, 0},
                                       {" xyz pwn ", points, 0, 0, 0},
                                       {" dsc ", complex, 0, complex, 0},
                                       {" json ", scene, 0, report, 0},
                                       {" pvd ", states, 0, 0, 0},
                                       {" html ", 0, 0, page, 0},
                                       {" vtk ", 0, cells | image, 0, surface | tetrahedra | image},
                                       {" vtp ", 0, surface | regions | points, 0, surface},
                                       {" vti nii nii.gz mha tif tiff ", 0, image, 0, image},
                                       {" mhd nrrd nhdr ", 0, image, 0, 0},
                                       {" vts vtr pvtu msh ", 0, cells, 0, 0},
                                       {" vtm meshb ", 0, tetrahedra | surface, 0, 0},
                                       {" 3mf ", 0, surface, 0, 0},
                                       {" ppm ", 0, pixels, 0, 0},
                                       {" csv pcd ", 0, points, 0, 0},
                                       {" geojson ", 0, regions, 0, 0}};
  return result;
}

/// Returns the formats of the extension of a file; null if it is unknown.
const Formats* formats_of(const std::string& path) {
  std::string last = extension(path);
  if (last == "gz")
    last = extension(path.substr(0, path.size() - 3)) + ".gz";
  for (const Formats& formats : all_formats())
    if (last.find_first_of(" ") == std::string::npos && !last.empty() &&
        std::strstr(formats.extensions, (' ' + last + ' ').c_str()) != nullptr)
      return &formats;
  return nullptr;
}

bool contains(const Formats& format, Use use, unsigned native, unsigned foreign) {
  return use == Use::read
             ? (format.read & native) != 0 || (format.read_by_files & foreign) != 0
             : (format.written & native) != 0 || (format.written_by_files & foreign) != 0;
}

} // namespace

std::string formats_with(Use use, unsigned native, unsigned foreign) {
  std::string result, word;
  for (const Formats& formats : all_formats())
    if (std::istringstream words(formats.extensions); contains(formats, use, native, foreign))
      while (words >> word)
        result += (result.empty() ? "." : ", .") + word;
  return result;
}

bool has_format(const std::string& path, Use use, unsigned native, unsigned foreign) {
  const Formats* const formats = formats_of(path);
  return formats != nullptr && contains(*formats, use, native, foreign);
}

void require_format(const std::string& path, Use use, unsigned native, unsigned foreign) {
  std::error_code error;
  if (use == Use::read && std::filesystem::is_directory(path, error))
    throw Input_error("cannot open '" + path + "': it is a folder; name a file in it");
  if (!has_format(path, use, native, foreign))
    throw Usage_error("the extension of '" + path + "' is not supported here; supported are " +
                      formats_with(use, native, foreign));
}

bool is_foreign(const std::string& path) {
  return has_format(path, Use::read, 0, content::all) && !has_format(path, Use::read, content::all);
}

std::string format_of_content(const std::string& path) {
  static constexpr std::string_view signatures[][2] = {
      {"\211DS", "dsc"},
      {"{", "json"},
      {"v ", "obj"},
      {"solid\n", "stl"},
      {"POLYGON", "wkt"},
      {"MULTIPOLYGON", "wkt"},
      {"# vtk DataFile", "vtk"},
      {"$MeshFormat", "msh"},
      {"<VTKFile type=\"UnstructuredGrid\"", "vtu"}};
  std::string begin(512, '\0');
  std::ifstream file(path, std::ios::binary);
  begin.resize(std::size_t(file.read(&begin[0], std::streamsize(begin.size())).gcount()));
  static constexpr std::size_t header = 84, triangle = 50; // bytes of a binary STL file
  if (std::uint32_t triangles = 0; begin.size() >= header) {
    std::memcpy(&triangles, &begin[header - sizeof triangles], sizeof triangles);
    std::error_code error;
    if (std::filesystem::file_size(path, error) == header + triangle * std::uintmax_t(triangles))
      return "stl";
  }
  DSC::internal::remove_byte_order_mark(begin);
  if (const std::size_t end = begin.find("?>\n");
      begin.rfind("<?xml", 0) == 0 && end < begin.size())
    begin.erase(0, end + 3);
  for (const auto& [bytes, format] : signatures)
    if (begin.compare(0, bytes.size(), bytes) == 0)
      return std::string(format);
  const DSC::internal::File_signature* const known = DSC::internal::find_signature(begin);
  if (known == nullptr)
    return begin.find("\nv ") == std::string::npos ? "" : "obj"; // after comments
  return known->extension.empty() ? "" : std::string(known->extension.substr(1));
}

} // namespace dsc
