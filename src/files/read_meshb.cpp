// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_dataset.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <cstdint>
#include <cstring>
#include <filesystem>

namespace dsc_files {
namespace {

/// The numbers of a binary file. The version of the format determines their sizes.
class Meshb_file
{
public:
  explicit Meshb_file(const std::string& path)
      : m_file(path, std::ios::binary), m_size(std::filesystem::file_size(path)) {
    if (number<std::int32_t>() != 1)
      throw Failure("is no little-endian file in the Gamma Mesh Format (.meshb)");
    m_version = number<std::int32_t>();
    if (m_version < 1 || m_version > 4)
      throw Failure("has the unknown version " + std::to_string(m_version) + " of its format");
  }

  int keyword() { return number<std::int32_t>(); }
  double real() { return m_version == 1 ? double(number<float>()) : number<double>(); }
  std::int64_t integer() {
    return m_version == 4 ? number<std::int64_t>() : std::int64_t(number<std::int32_t>());
  }
  std::uint64_t place() {
    return m_version >= 3 ? number<std::uint64_t>() : std::uint64_t(number<std::uint32_t>());
  }

  /// Reads the number of items of a section.
  std::int64_t count() {
    const std::int64_t result = integer();
    if (result < 0 || std::uint64_t(result) > m_size)
      fail();
    return result;
  }

  /// Goes forward to a place of the file.
  void go_to(std::uint64_t place) {
    if (place > m_size || place < std::uint64_t(m_file.tellg()))
      fail();
    m_file.seekg(std::streamoff(place));
  }

  [[noreturn]] static void fail() { throw Failure("is truncated or damaged; write it again"); }

private:
  template <class Number> Number number() {
    char bytes[sizeof(Number)];
    if (!m_file.read(bytes, sizeof bytes))
      fail();
    Number result;
    std::memcpy(&result, bytes, sizeof result);
    return result;
  }

  std::ifstream m_file;
  std::uint64_t m_size;
  int m_version = 0;
};

enum Keyword { dimension = 3, vertices = 4, edges = 5, triangles = 6, tetrahedra = 8, end = 54 };

/// Builds a grid from the sections of a file.
class Meshb_grid
{
public:
  Meshb_grid(Meshb_file& file, Translation& translation)
      : m_file(file), m_translation(translation) {
    m_points->SetDataTypeToDouble();
    m_references->SetName("medit:ref");
    m_grid->Allocate();
  }

  vtkSmartPointer<vtkUnstructuredGrid> read() {
    for (int keyword; (keyword = m_file.keyword()) != end;) {
      const std::uint64_t next = m_file.place();
      if (keyword == dimension)
        m_dimension = m_file.keyword();
      else if (keyword == vertices)
        read_vertices();
      else if (keyword == edges)
        read_cells(VTK_LINE, 2);
      else if (keyword == triangles)
        read_cells(VTK_TRIANGLE, 3);
      else if (keyword == tetrahedra)
        read_cells(VTK_TETRA, 4);
      else
        m_translation.unused.push_back("section (keyword " + std::to_string(keyword) + ')');
      if (next == 0)
        break;
      m_file.go_to(next);
    }
    m_grid->SetPoints(m_points);
    m_grid->GetCellData()->AddArray(m_references);
    return m_grid;
  }

private:
  void read_vertices() {
    if (m_dimension != 2 && m_dimension != 3)
      throw Failure("has no dimension before its vertices");
    std::size_t references = 0;
    for (std::int64_t i = m_file.count(); i > 0; --i) {
      double p[3] = {0, 0, 0};
      for (int axis = 0; axis < m_dimension; ++axis)
        p[axis] = m_file.real();
      m_points->InsertNextPoint(p);
      references += m_file.integer() != 0;
    }
    m_translation.leave_out(references, "vertex reference", "vertex references");
  }

  void read_cells(int type, int corners) {
    for (std::int64_t i = m_file.count(); i > 0; --i) {
      vtkIdType indices[4];
      for (int k = 0; k < corners; ++k) {
        indices[k] = vtkIdType(m_file.integer()) - 1;
        if (indices[k] < 0 || indices[k] >= m_points->GetNumberOfPoints())
          throw Failure("has a cell with an unknown vertex; is it damaged?");
      }
      m_grid->InsertNextCell(type, corners, indices);
      m_references->InsertNextValue(int(m_file.integer()));
    }
  }

  Meshb_file& m_file;
  Translation& m_translation;
  int m_dimension = 0;
  vtkNew<vtkPoints> m_points;
  vtkNew<vtkIntArray> m_references;
  vtkSmartPointer<vtkUnstructuredGrid> m_grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
};

} // namespace

vtkSmartPointer<vtkUnstructuredGrid> read_meshb(const std::string& path, Translation& translation) {
  Meshb_file file(path);
  return Meshb_grid(file, translation).read();
}

} // namespace dsc_files
