// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_dataset.h"

#ifdef DSC_HAS_GMSH

#include <gmsh.h>

#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace dsc_files {
namespace {

/// A type of elements of Gmsh, and the linear type of VTK with the same corners.
struct Element_type
{
  int gmsh, vtk, corners;
};
constexpr Element_type element_types[] = {
    {15, VTK_VERTEX, 1}, {1, VTK_LINE, 2},  {2, VTK_TRIANGLE, 3},   {3, VTK_QUAD, 4},
    {4, VTK_TETRA, 4},   {6, VTK_WEDGE, 6}, {5, VTK_HEXAHEDRON, 8}, {7, VTK_PYRAMID, 5}};

const Element_type& type_of(int gmsh) {
  for (const Element_type& type : element_types)
    if (type.gmsh == gmsh)
      return type;
  throw Failure("contains elements of the Gmsh type " + std::to_string(gmsh) +
                "; write linear elements");
}

/// Throws unless a file is a mesh. Gmsh executes other files as scripts.
void require_mesh(const std::string& path) {
  const std::string begin = "$MeshFormat";
  std::string line;
  std::ifstream file(path, std::ios::binary);
  std::getline(file, line);
  if (line != begin && line != begin + '\r')
    throw Failure("does not begin with $MeshFormat; write a mesh of Gmsh, version 2 or later");
}

/// A Gmsh session with one mesh.
class Gmsh_model
{
public:
  /// \param folder new folder for a copy of the file: Gmsh executes scripts beside a file
  Gmsh_model(const std::string& path, const std::string& folder) {
    require_mesh(path);
    const std::string copy = folder + "/mesh.msh";
    std::filesystem::copy_file(path, copy);
    gmsh::initialize(0, nullptr, false); // without the configuration of the user
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::merge(copy);
  }
  ~Gmsh_model() { gmsh::finalize(); }
  Gmsh_model(const Gmsh_model&) = delete;
  Gmsh_model& operator=(const Gmsh_model&) = delete;
};

/// Returns the label of the elements of an entity: its first physical group, or 0. If the dimension
/// has no groups, returns the number of the entity.
int label_of(int dimension, int entity, const gmsh::vectorpair& groups, Translation& translation) {
  const bool has_groups = std::any_of(groups.begin(), groups.end(),
                                      [&](const auto& group) { return group.first == dimension; });
  if (!has_groups)
    return entity;
  std::vector<int> physical;
  gmsh::model::getPhysicalGroupsForEntity(dimension, entity, physical);
  if (physical.size() > 1)
    translation.leave_out(physical.size() - 1, "further physical group of an entity",
                          "further physical groups of an entity");
  if (physical.empty() && dimension >= 2)
    translation.notes.push_back("entity " + std::to_string(entity) + " of dimension " +
                                std::to_string(dimension) + " has no physical group: label 0");
  return physical.empty() ? 0 : physical.front();
}

vtkSmartPointer<vtkUnstructuredGrid> grid_of_model(Translation& translation) {
  std::vector<std::size_t> tags;
  std::vector<double> coordinates, parameters;
  gmsh::model::mesh::getNodes(tags, coordinates, parameters);
  std::map<std::size_t, vtkIdType> index;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (std::size_t i = 0; i < tags.size(); ++i)
    index[tags[i]] = points->InsertNextPoint(&coordinates[3 * i]);
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->Allocate();
  vtkNew<vtkIntArray> labels;
  labels->SetName("gmsh:physical");
  gmsh::vectorpair groups, entities;
  gmsh::model::getPhysicalGroups(groups);
  gmsh::model::getEntities(entities);
  int largest = 0; // dimension of elements
  for (const auto& [dimension, entity] : entities) {
    const int label = label_of(dimension, entity, groups, translation);
    std::vector<int> types;
    std::vector<std::vector<std::size_t>> elements, nodes;
    gmsh::model::mesh::getElements(types, elements, nodes, dimension, entity);
    if (!types.empty())
      largest = (std::max)(largest, dimension);
    for (std::size_t t = 0; t < types.size(); ++t) {
      const Element_type& type = type_of(types[t]);
      for (std::size_t i = 0; i < elements[t].size(); ++i) {
        vtkIdType corners[8];
        for (int k = 0; k < type.corners; ++k)
          corners[k] = index.at(nodes[t][std::size_t(type.corners) * i + std::size_t(k)]);
        grid->InsertNextCell(type.vtk, type.corners, corners);
        labels->InsertNextValue(label);
      }
    }
  }
  grid->GetCellData()->AddArray(labels);
  for (const auto& [dimension, group] : groups) {
    std::string name;
    if (dimension == largest)
      gmsh::model::getPhysicalName(dimension, group, name);
    if (!name.empty())
      translation.names[group] = name;
  }
  return grid;
}

} // namespace

vtkSmartPointer<vtkUnstructuredGrid> read_gmsh(const std::string& path, const std::string& folder,
                                               Translation& translation) {
  try {
    const Gmsh_model model(path, folder);
    std::vector<int> views;
    gmsh::view::getTags(views);
    translation.leave_out(views.size(), "view with values", "views with values");
    return grid_of_model(translation);
  } catch (const Failure&) {
    throw;
  } catch (const std::string& error) { // Gmsh 4.8 throws strings, too
    throw Failure("cannot be read by Gmsh: " + error);
  } catch (const std::exception& error) {
    throw Failure(std::string("cannot be read by Gmsh: ") + error.what());
  }
}

} // namespace dsc_files

#else

namespace dsc_files {

vtkSmartPointer<vtkUnstructuredGrid> read_gmsh(const std::string&, const std::string&,
                                               Translation&) {
  throw Failure("cannot be read: the program was built without Gmsh (Debian: libgmsh-dev)");
}

} // namespace dsc_files

#endif
