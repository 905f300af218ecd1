// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Planar_regions.h"
#include "Translation.h"

#include <vtkAppendFilter.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkDataSetTriangleFilter.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkTriangleFilter.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <sstream>

namespace dsc_files {
namespace {

using Label_names = std::map<int, std::string>;

/// Returns the linear type with the corners of a quadratic, Lagrange or Bezier type; linear types
/// are returned as they are.
/// \throws Failure for other nonlinear types
int linear_type(int type) {
  static constexpr int last_linear = 21;
  switch (type) {
  case VTK_QUADRATIC_EDGE:
  case VTK_LAGRANGE_CURVE:
  case VTK_BEZIER_CURVE:
    return VTK_LINE;
  case VTK_QUADRATIC_TRIANGLE:
  case VTK_LAGRANGE_TRIANGLE:
  case VTK_BEZIER_TRIANGLE:
    return VTK_TRIANGLE;
  case VTK_QUADRATIC_TETRA:
  case VTK_LAGRANGE_TETRAHEDRON:
  case VTK_BEZIER_TETRAHEDRON:
    return VTK_TETRA;
  default:
    if (type >= last_linear)
      throw Failure("contains cells of the type " + std::to_string(type) +
                    " of VTK; write linear cells");
    return type;
  }
}

/// Returns the dimension of the cells of a linear type of VTK.
int dimension_of(int type) {
  switch (type) {
  case VTK_VERTEX:
  case VTK_POLY_VERTEX:
    return 0;
  case VTK_LINE:
  case VTK_POLY_LINE:
    return 1;
  case VTK_TRIANGLE:
  case VTK_TRIANGLE_STRIP:
  case VTK_POLYGON:
  case VTK_PIXEL:
  case VTK_QUAD:
    return 2;
  default:
    return 3;
  }
}

/// Returns the numbers of cells of each dimension.
std::array<std::size_t, 4> numbers_of_cells(vtkDataSet* data) {
  std::array<std::size_t, 4> result = {};
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
    if (data->GetCellType(i) != VTK_EMPTY_CELL)
      ++result[std::size_t(dimension_of(linear_type(data->GetCellType(i))))];
  return result;
}

/// Lists the arrays of points or cells.
/// \param used array that is not left out; may be null
void leave_out_arrays(vtkFieldData* arrays, const std::string& kind, Translation& result,
                      const vtkAbstractArray* used = nullptr) {
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    if (vtkAbstractArray* const array = arrays->GetAbstractArray(i);
        array != used && array->GetName() != nullptr)
      result.unused.push_back(kind + " array (" + array->GetName() + ')');
}

/// Points without repetitions. Pieces of a file repeat the points of their common boundary.
struct Merged_points
{
  std::vector<vtkIdType> index;    ///< of each point among the kept ones
  std::vector<vtkIdType> original; ///< of each kept point
};

Merged_points merge_points(vtkPoints* points) {
  Merged_points result;
  std::map<std::array<double, 3>, vtkIdType> known;
  for (vtkIdType i = 0; points != nullptr && i < points->GetNumberOfPoints(); ++i) {
    std::array<double, 3> p;
    points->GetPoint(i, p.data());
    const bool is_finite = std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
    const auto next = vtkIdType(result.original.size());
    const vtkIdType index = is_finite ? known.emplace(p, next).first->second : next;
    if (index == next)
      result.original.push_back(i);
    result.index.push_back(index);
  }
  return result;
}

/// Removes the arrays of points that have different values at repeated points.
void leave_out_ambiguous_arrays(vtkPointData* arrays, const Merged_points& merged,
                                Translation& result) {
  for (int k = arrays->GetNumberOfArrays(); k-- > 0;) {
    vtkDataArray* const array = arrays->GetArray(k);
    bool is_unique = true;
    for (vtkIdType i = 0; array != nullptr && i < vtkIdType(merged.index.size()); ++i)
      for (int c = 0; c < array->GetNumberOfComponents(); ++c) {
        const double a = array->GetComponent(i, c),
                     b = array->GetComponent(
                         merged.original[std::size_t(merged.index[std::size_t(i)])], c);
        is_unique = is_unique && (a == b || (std::isnan(a) && std::isnan(b)));
      }
    if (is_unique)
      continue;
    const char* const name = array->GetName();
    result.unused.push_back(std::string("point array with several values at a point ('") +
                            (name == nullptr ? "" : name) + "')");
    arrays->RemoveArray(k);
  }
}

/// Returns the cells of a dimension, with their arrays and without repeated points.
vtkSmartPointer<vtkUnstructuredGrid> cells_of(vtkDataSet* data, int dimension,
                                              Translation& translation) {
  vtkNew<vtkAppendFilter> as_grid; // of any dataset
  as_grid->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  as_grid->AddInputData(data);
  as_grid->Update();
  vtkUnstructuredGrid* const all = as_grid->GetOutput();
  const Merged_points merged = merge_points(all->GetPoints());
  if (const std::size_t repeated = merged.index.size() - merged.original.size(); repeated > 0)
    translation.notes.push_back("merged " + std::to_string(repeated) + " repeated " +
                                (repeated == 1 ? "point" : "points"));
  if (dimension == 3) // others leave out all arrays
    leave_out_ambiguous_arrays(all->GetPointData(), merged, translation);
  auto result = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  result->GetPointData()->CopyAllocate(all->GetPointData());
  for (const vtkIdType i : merged.original)
    result->GetPointData()->CopyData(all->GetPointData(), i,
                                     points->InsertNextPoint(all->GetPoint(i)));
  result->SetPoints(points);
  result->GetCellData()->CopyAllocate(all->GetCellData());
  result->Allocate();
  std::size_t curved = 0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < all->GetNumberOfCells(); ++i) {
    if (all->GetCellType(i) == VTK_EMPTY_CELL)
      continue;
    const int type = linear_type(all->GetCellType(i));
    if (dimension_of(type) != dimension)
      continue;
    all->GetCellPoints(i, corners);
    if (type != all->GetCellType(i)) { // the corners come first
      curved += corners->GetNumberOfIds() > dimension + 1;
      corners->SetNumberOfIds(dimension + 1);
    }
    for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
      corners->SetId(k, merged.index[std::size_t(corners->GetId(k))]);
    result->GetCellData()->CopyData(all->GetCellData(), i, result->InsertNextCell(type, corners));
  }
  translation.leave_out(curved, "curved cell, replaced by a straight one",
                        "curved cells, replaced by straight ones");
  return result;
}

bool is_of_type(vtkDataSet* data, int type) {
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
    if (data->GetCellType(i) != type)
      return false;
  return true;
}

/// Adds the names of labels as data of the whole grid, in the form that the package reads.
void add_names(vtkDataSet* data, const Label_names& names) {
  if (names.empty())
    return;
  vtkNew<vtkIntArray> labels;
  vtkNew<vtkStringArray> strings;
  labels->SetName("named_labels");
  strings->SetName("label_names");
  for (const auto& [label, name] : names) {
    labels->InsertNextValue(label);
    strings->InsertNextValue(name);
  }
  data->GetFieldData()->AddArray(labels);
  data->GetFieldData()->AddArray(strings);
}

void write_tetrahedra(vtkSmartPointer<vtkUnstructuredGrid> cells, const Label_names& names,
                      Translation& result) {
  if (!is_of_type(cells, VTK_TETRA)) {
    vtkNew<vtkDataSetTriangleFilter> divided;
    divided->SetInputData(cells);
    divided->TetrahedraOnlyOn();
    divided->Update();
    cells = divided->GetOutput();
  }
  add_names(cells, names);
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(cells);
  writer->SetFileName(result.path.c_str());
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToNone();
  if (writer->Write() == 0)
    throw Failure("cannot be translated: the disk for temporary files is full");
}

bool is_planar(vtkDataSet* data) {
  const double* const bounds = data->GetBounds();
  return bounds[4] == bounds[5];
}

/// Writes an object for each label, by increasing label (.obj).
void write_objects(vtkPolyData* surface, const std::vector<int>& labels, const Label_names& names,
                   const std::string& path) {
  const std::vector<Triangle> triangles = triangles_of(surface);
  std::map<int, std::vector<Triangle>> objects;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    objects[labels[i]].push_back(triangles[i]);
  Output_file out(path);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i) {
    const auto [x, y, z] = point(surface, i);
    out << "v " << x << ' ' << y << ' ' << z << '\n';
  }
  for (const auto& [label, of_label] : objects) {
    const auto name = names.find(label);
    out << "o " << (name == names.end() ? "label " + std::to_string(label) : name->second) << '\n';
    for (const Triangle& t : of_label)
      out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  }
  out.close();
}

void write_surface(vtkPolyData* surface, Translation& result) {
  const std::vector<Triangle> triangles = triangles_of(surface);
  Output_file out(result.path);
  out << "OFF\n" << surface->GetNumberOfPoints() << ' ' << triangles.size() << " 0\n";
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i) {
    const auto [x, y, z] = point(surface, i);
    out << x << ' ' << y << ' ' << z << '\n';
  }
  for (const Triangle& t : triangles)
    out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  out.close();
}

/// Returns the label of each cell: the values of an array, or 1.
std::vector<int> labels_of(vtkDataSet* data, const std::string& name, Translation& result) {
  std::vector<int> labels(std::size_t(data->GetNumberOfCells()), 1);
  vtkDataArray* array = nullptr;
  if (name.empty())
    for (const char* known : {"label", "medit:ref", "gmsh:physical", "MaterialIDs"})
      array = array == nullptr ? data->GetCellData()->GetArray(known) : array;
  else if (name != "none")
    array = data->GetCellData()->GetArray(name.c_str());
  if (array == nullptr && !name.empty() && name != "none")
    throw Failure("has no cell array '" + name + "'");
  leave_out_arrays(data->GetCellData(), "cell", result, array);
  for (std::size_t i = 0; array != nullptr && i < labels.size(); ++i) {
    const double value = array->GetTuple1(vtkIdType(i));
    if (!(value == std::floor(value) && std::abs(value) <= (std::numeric_limits<int>::max)()))
      throw Failure("has labels that are not integers, in the array '" +
                    std::string(array->GetName()) + "'");
    labels[i] = int(value);
  }
  return labels;
}

void write_points(vtkDataSet* data, Translation& result) {
  vtkDataArray* const normals = data->GetPointData()->GetNormals();
  Output_file out(result.path);
  std::size_t left_out = 0;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    const auto [x, y, z] = point(data, i);
    if (!(std::isfinite(x) && std::isfinite(y) && std::isfinite(z))) {
      ++left_out;
      continue;
    }
    out << x << ' ' << y << ' ' << z;
    for (int axis = 0; normals != nullptr && axis < 3; ++axis)
      out << ' ' << normals->GetComponent(i, axis);
    out << '\n';
  }
  out.close();
  result.leave_out(left_out, "point that is not finite", "points that are not finite");
}

/// Returns what a user can do so that triangles of label 0 are the outer part of the domain.
std::string note_on_domain(const double* bounds) {
  std::ostringstream note;
  note.precision(std::numeric_limits<double>::max_digits10);
  note << "label 0 fills the domain around the other labels; --domain " << bounds[0] << ','
       << bounds[2] << ',' << bounds[1] << ',' << bounds[3] << " gives the bounds of the triangles";
  return note.str();
}

void write_triangles(vtkDataSet* data, const Label_names& names, const Options& options,
                     Translation& result) {
  const auto faces = cells_of(data, 2, result);
  vtkIdType expected = 0; // number of triangles
  for (vtkIdType i = 0; i < faces->GetNumberOfCells(); ++i)
    expected += faces->GetCells()->GetCellSize(i) - 2;
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(faces);
  vtkNew<vtkTriangleFilter> triangulated;
  triangulated->SetInputConnection(surface->GetOutputPort());
  triangulated->PassLinesOff();
  triangulated->PassVertsOff();
  triangulated->Update();
  vtkPolyData* const triangles = triangulated->GetOutput();
  if (triangles->GetNumberOfCells() != expected)
    throw Failure("contains polygons that cannot be divided into triangles");
  leave_out_arrays(triangles->GetPointData(), "point", result);
  if (is_planar(triangles)) {
    result.path = options.folder + "/regions.poly";
    result.leave_out(names.size(), "name of a label", "names of labels");
    const Planar_regions regions(triangles, labels_of(triangles, options.labels, result));
    regions.write(result.path);
    if (regions.has_label_0_outside())
      result.notes.push_back(note_on_domain(triangles->GetBounds()));
  } else {
    if (!options.labels.empty() && options.labels != "none")
      throw Failure(
          "is a surface, whose triangles have no labels; leave out --labels, or give none");
    if (!names.empty() && options.labels.empty()) {
      result.path = options.folder + "/surface.obj";
      return write_objects(triangles, labels_of(triangles, "", result), names, result.path);
    }
    result.path = options.folder + "/surface.off";
    leave_out_arrays(triangles->GetCellData(), "cell", result);
    write_surface(triangles, result);
  }
}

} // namespace

Translation write_cells(vtkDataSet* data, const Label_names& names, const Options& options) {
  Translation result;
  const std::array<std::size_t, 4> numbers = numbers_of_cells(data);
  const char* const kinds[][2] = {
      {"vertex cell", "vertex cells"}, {"line", "lines"}, {"face", "faces"}};
  const int dimension = numbers[3] > 0 ? 3 : numbers[2] > 0 ? 2 : 0;
  for (int d = 0; d < dimension; ++d)
    result.leave_out(numbers[std::size_t(d)], kinds[d][0], kinds[d][1]);
  if (dimension == 3) {
    result.path = options.folder + "/cells.vtu";
    write_tetrahedra(cells_of(data, 3, result), names, result);
  } else if (dimension == 2) {
    write_triangles(data, names, options, result);
  } else if (data->GetNumberOfPoints() > 0) {
    result.path = options.folder +
                  (data->GetPointData()->GetNormals() == nullptr ? "/points.xyz" : "/points.pwn");
    result.leave_out(numbers[1], kinds[1][0], kinds[1][1]);
    result.leave_out(names.size(), "name of a part", "names of parts");
    leave_out_arrays(data->GetPointData(), "point", result, data->GetPointData()->GetNormals());
    write_points(data, result);
  } else {
    throw Failure("contains no points");
  }
  return result;
}

} // namespace dsc_files
