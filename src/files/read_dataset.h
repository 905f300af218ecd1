// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FILES_READ_DATASET_H
#define DSC_FILES_READ_DATASET_H

#include "Translation.h"

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <initializer_list>

namespace dsc_files {

/// A dataset of VTK and what its reader knows about it.
struct Dataset
{
  vtkSmartPointer<vtkDataSet> data;
  Translation translation; ///< the unused contents so far
  double slice_order = 1;  ///< -1 if the file stores the slices of a NIfTI image in reverse
};

/// Reads a file. Images have their direction matrix, and scaled values.
/// \param folder folder for copies, which exists
/// \throws Failure if the format is unknown, the file cannot be read or is damaged
Dataset read_dataset(const std::string& path, const std::string& folder);

/// Prints the message of a failure and ends this process, for callbacks of libraries.
[[noreturn]] void end_process(const std::string& message);

/// What a file promises before it is read.
struct Header
{
  double bytes;       ///< of the file and of the files that it names
  double content = 0; ///< bytes of arrays of VTK, and of the parts of 3MF files

  /// Reads the header of a file.
  /// \throws Failure if it cannot be read, or names files that may not be read
  Header(const std::string& path, const std::string& format);

  /// Adds a file that a header names, and returns its path.
  /// \throws Failure unless it is a regular file in the folder of the header, or below it
  std::string add(const std::string& path, const std::string& file);
};

/// Limits the memory and the processor time of this process by the content of a file, in addition
/// to the files before.
/// \param content, bytes what the file promises, and its size, in bytes
/// \throws Failure if the file promises too much, see `why_too_large()` in files.h
void accept_content(double content, double bytes);

/// Returns the value of the first of some keys in the text header of a file; empty if there is
/// none. The keys are in lower case.
std::string header_value(const std::string& path, char separator,
                         std::initializer_list<const char*> keys);

/// From now on, errors of VTK are told as errors of a disk on which this program writes.
void expect_errors_of_disk();

/// Returns the extension in lower case, without the dot; of compressed NIfTI files `nii.gz`.
std::string format_of(const std::string& path);

/// Reads the objects of a 3MF file as one surface, at the places of the items that are to be built.
/// The labels of the triangles are the numbers of their objects, beginning with 1, in the order of
/// the items; objects with the same name have the same label.
/// \throws Failure if the file cannot be read, or the program was built without lib3mf
vtkSmartPointer<vtkDataSet> read_3mf(const std::string& path, Translation& translation);

/// Reads the blocks of a multi-block file of VTK (.vtm) as one grid. The labels of the cells are
/// the numbers of their blocks, beginning with 1, in the order of the file; blocks with the same
/// name have the same label.
/// \throws Failure if the file contains no blocks, or blocks that are images
vtkSmartPointer<vtkDataSet> read_blocks(const std::string& path, Translation& translation);

/// Reads a mesh of Gmsh (.msh). The cell array `gmsh:physical` contains the physical group of each
/// cell, and 0 for cells without a group; without groups, the tags of the entities.
/// \param folder new folder
/// \param translation receives the unused contents
/// \throws Failure if it cannot be read, or the program was built without Gmsh
vtkSmartPointer<vtkUnstructuredGrid> read_gmsh(const std::string& path, const std::string& folder,
                                               Translation& translation);

/// Reads a binary mesh in the Gamma Mesh Format (.meshb): vertices, edges, triangles and
/// tetrahedra. The cell array `medit:ref` contains their references.
/// \param translation receives the unused contents
/// \throws Failure if it cannot be read
vtkSmartPointer<vtkUnstructuredGrid> read_meshb(const std::string& path, Translation& translation);

/// Checks whether a file has all bytes that its header announces, for formats whose readers in VTK
/// accept truncated files: MetaImage (.mha, .mhd) and TIFF. Checks the numbers of NIfTI headers.
/// \throws Failure if bytes are missing
void require_complete(const std::string& path, const std::string& format);

/// The labels of the parts of a file: 1, 2 and so on. Parts with the same name have the same label.
class Names_of_parts
{
public:
  /// Returns the label of a part.
  /// \param otherwise the name of a part without name
  int label_of(std::string name, const std::string& otherwise) {
    for (char& c : name)
      if (c == '\n' || c == '\r')
        c = ' ';
    if (name.empty())
      name = otherwise;
    const auto [place, is_new] = m_labels.emplace(name, int(m_labels.size()) + 1);
    if (is_new)
      m_names.emplace(place->second, name);
    return place->second;
  }

  /// Returns the names by their labels.
  const std::map<int, std::string>& names() const { return m_names; }

private:
  std::map<std::string, int> m_labels;
  std::map<int, std::string> m_names;
};

} // namespace dsc_files

#endif // DSC_FILES_READ_DATASET_H
