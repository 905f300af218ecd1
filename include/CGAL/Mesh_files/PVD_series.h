// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_PVD_SERIES_H
#define CGAL_MESH_FILES_PVD_SERIES_H

#include <CGAL/Mesh_files/File_error.h>
#include <CGAL/Mesh_files/internal/text/Xml_element.h>
#include <CGAL/Mesh_files/replace_file.h>

#include <cmath>
#include <limits>

namespace CGAL::IO {

/*!
\ingroup PkgMeshFilesRef

A ParaView collection: a file that lists data files with their times, to be opened as one animation.

\sa `write_VTU()`
\sa `write_interface_VTU()`
*/
class PVD_series
{
public:
  /// Constructs an empty series. Nothing is written yet.
  ///
  /// \param path name of the collection, usually with the extension `.pvd`
  explicit PVD_series(std::string path) : m_path(std::move(path)) {}

  /// \brief Adds a data file and writes the collection, which is complete and valid after each
  /// call.
  ///
  /// \param time time of the data file; it should be larger than all times added before
  /// \param file name of the data file, relative to the working directory. The collection stores it
  ///        relative to its own folder, so that both can be moved together.
  ///
  /// \throws Deformable_simplicial_complexes::File_error if the time is not finite or the
  ///         collection cannot be written; an older collection and the series are then unchanged
  ///
  /// Linear in the number of data files.
  void append(double time, const std::string& file) { append({{time, file}}); }

  /// Adds several data files, each with its time, and writes the collection once. Otherwise the
  /// function is the same as the overload above.
  void append(const std::vector<std::pair<double, std::string>>& files) {
    std::vector<Entry> entries = m_entries;
    for (const auto& [time, file] : files) {
      if (!std::isfinite(time))
        throw Deformable_simplicial_complexes::File_error(
            "the time of " + file + " is not a finite number and cannot be written to " + m_path +
                ": correct it",
            m_path);
      entries.push_back({time, relative_to_collection(file)});
    }
    Deformable_simplicial_complexes::replace_file(m_path,
                                                  [&](std::ostream& out) { write(out, entries); });
    m_entries.swap(entries);
  }

  /// Returns the name of the collection.
  const std::string& path() const { return m_path; }

private:
  struct Entry
  {
    double time;
    std::string file;
  };

  std::string relative_to_collection(const std::string& file) const {
    namespace fs = std::filesystem;
    const auto normal = [](const std::string& path) {
      std::error_code error; // without a working directory
      const fs::path absolute = fs::absolute(path, error);
      return (error ? fs::path(path) : absolute).lexically_normal();
    };
    return normal(file).lexically_proximate(normal(m_path).parent_path()).generic_string();
  }

  static void write(std::ostream& out, const std::vector<Entry>& entries) {
    out.precision(std::numeric_limits<double>::max_digits10);
    out << "<?xml version=\"1.0\"?>\n"
           "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
           "  <Collection>\n";
    for (const Entry& entry : entries)
      out << "    <DataSet timestep=\"" << entry.time << "\" group=\"\" part=\"0\" file=\""
          << Deformable_simplicial_complexes::internal::xml_escaped(entry.file) << "\"/>\n";
    out << "  </Collection>\n"
           "</VTKFile>\n";
  }

  std::string m_path;
  std::vector<Entry> m_entries;
};

} // namespace CGAL::IO

#endif // CGAL_MESH_FILES_PVD_SERIES_H
