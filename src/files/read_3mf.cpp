// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_dataset.h"

#ifdef DSC_HAS_LIB3MF

#include <Model/COM/NMR_DLLInterfaces.h>

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace dsc_files {
namespace {

/// An object of lib3mf, which is released at the end.
class Handle
{
public:
  Handle() = default;
  ~Handle() {
    if (m_object != nullptr)
      NMR::lib3mf_release(m_object);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;

  NMR::PLib3MFBase* get() const { return m_object; }
  NMR::PLib3MFBase** out() { return &m_object; }

private:
  NMR::PLib3MFBase* m_object = nullptr;
};

void require(LIB3MFRESULT result, const char* what) {
  if (result != LIB3MF_OK)
    throw Failure("cannot be read by lib3mf: " + std::string(what) + " (error " +
                  std::to_string(static_cast<unsigned>(result)) + ")");
}

/// A map to space: the rows of a matrix, and a translation in the last column.
using Map = std::array<std::array<double, 4>, 3>;
constexpr Map identity = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

/// Returns the map that first does `inner`, then `outer`.
Map product(const Map& outer, const NMR::MODELTRANSFORM& inner) {
  Map result = {};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 3; ++k)
        result[i][j] += outer[i][k] * double(inner.m_fFields[k][j]);
      if (j == 3)
        result[i][j] += outer[i][3];
    }
  return result;
}

/// Collects the triangles of objects.
class Objects_3mf
{
public:
  explicit Objects_3mf(Translation& translation) : m_translation(translation) {
    m_labels->SetName("label");
    m_points->SetDataTypeToDouble();
    m_grid->Allocate();
  }

  /// Adds an object and its components.
  /// \param name of the object that contains it; may be empty
  void add(NMR::PLib3MFBase* object, const Map& map, const std::string& name, int depth = 0) {
    static constexpr int most = 100; // components of components
    if (depth > most)
      throw Failure("has an object that contains itself");
    const std::string own = name_of(object), known = own.empty() ? name : own;
    BOOL is_mesh = 0;
    require(NMR::lib3mf_object_ismeshobject(object, &is_mesh), "an object is of no known kind");
    if (is_mesh)
      return add_mesh(object, map, known);
    DWORD components = 0;
    require(NMR::lib3mf_componentsobject_getcomponentcount(object, &components),
            "an object has no components");
    for (DWORD i = 0; i < components; ++i) {
      Handle component, part;
      NMR::MODELTRANSFORM place;
      require(NMR::lib3mf_componentsobject_getcomponent(object, i, component.out()),
              "a component is missing");
      require(NMR::lib3mf_component_getobjectresource(component.get(), part.out()),
              "the object of a component is missing");
      require(NMR::lib3mf_component_gettransform(component.get(), &place),
              "a component has no place");
      add(part.get(), product(map, place), known, depth + 1);
    }
  }

  vtkSmartPointer<vtkDataSet> result() {
    m_translation.leave_out(m_supports, "support object", "support objects");
    m_translation.leave_out(m_beams, "beam of a lattice", "beams of lattices");
    m_translation.names = m_parts.names();
    m_grid->SetPoints(m_points);
    m_grid->GetCellData()->AddArray(m_labels);
    return m_grid;
  }

private:
  static std::string name_of(NMR::PLib3MFBase* object) {
    std::array<char, 4096> name = {};
    ULONG needed = 0;
    const bool has_name = NMR::lib3mf_object_getnameutf8(object, name.data(), ULONG(name.size()),
                                                         &needed) == LIB3MF_OK;
    return has_name ? std::string(name.data()) : "";
  }

  void add_mesh(NMR::PLib3MFBase* object, const Map& map, const std::string& name) {
    DWORD type = 0, id = 0, beams = 0, vertices = 0, triangles = 0, read = 0;
    require(NMR::lib3mf_object_gettype(object, &type), "an object has no type");
    if (type == NMR::MODELOBJECTTYPE_SUPPORT || type == NMR::MODELOBJECTTYPE_SOLIDSUPPORT) {
      ++m_supports;
      return;
    }
    require(NMR::lib3mf_resource_getresourceid(object, &id), "an object has no number");
    require(NMR::lib3mf_meshobject_getbeamcount(object, &beams), "the beams are invalid");
    m_beams += beams;
    require(NMR::lib3mf_meshobject_getvertexcount(object, &vertices), "the vertices are invalid");
    require(NMR::lib3mf_meshobject_gettrianglecount(object, &triangles),
            "the triangles are invalid");
    std::vector<NMR::MODELMESHVERTEX> points(vertices);
    std::vector<NMR::MODELMESHTRIANGLE> corners(triangles);
    if (vertices == 0 || triangles == 0)
      return;
    require(NMR::lib3mf_meshobject_getvertices(object, points.data(), vertices, &read),
            "the vertices are invalid");
    require(NMR::lib3mf_meshobject_gettriangleindices(object, corners.data(), triangles, &read),
            "the triangles are invalid");
    const vtkIdType first = m_points->GetNumberOfPoints();
    for (const NMR::MODELMESHVERTEX& p : points) {
      std::array<double, 3> q;
      for (std::size_t i = 0; i < 3; ++i)
        q[i] = map[i][0] * double(p.m_fPosition[0]) + map[i][1] * double(p.m_fPosition[1]) +
               map[i][2] * double(p.m_fPosition[2]) + map[i][3];
      m_points->InsertNextPoint(q.data());
    }
    const int label = m_parts.label_of(name, "object " + std::to_string(id));
    for (const NMR::MODELMESHTRIANGLE& triangle : corners) {
      std::array<vtkIdType, 3> indices;
      for (std::size_t i = 0; i < 3; ++i)
        indices[i] = first + vtkIdType(triangle.m_nIndices[i]);
      m_grid->InsertNextCell(VTK_TRIANGLE, 3, indices.data());
      m_labels->InsertNextValue(label);
    }
  }

  Translation& m_translation;
  Names_of_parts m_parts;
  std::size_t m_supports = 0, m_beams = 0;
  vtkNew<vtkPoints> m_points;
  vtkNew<vtkIntArray> m_labels;
  vtkSmartPointer<vtkUnstructuredGrid> m_grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
};

void report_unit(NMR::PLib3MFBase* model, Translation& translation) {
  static constexpr const char* units[] = {"micrometers", "millimeters", "centimeters",
                                          "inches",      "feet",        "meters"};
  DWORD unit = NMR::MODELUNIT_MILLIMETER;
  require(NMR::lib3mf_model_getunit(model, &unit), "the unit is invalid");
  if (unit != NMR::MODELUNIT_MILLIMETER && unit < std::size(units))
    translation.notes.push_back("the coordinates are in " + std::string(units[unit]));
}

} // namespace

vtkSmartPointer<vtkDataSet> read_3mf(const std::string& path, Translation& translation) {
  Handle model, reader, items;
  require(NMR::lib3mf_createmodel(model.out()), "there is no memory");
  require(NMR::lib3mf_model_queryreader(model.get(), "3mf", reader.out()), "there is no reader");
  require(NMR::lib3mf_reader_readfromfileutf8(reader.get(), path.c_str()),
          "it is no valid 3MF file");
  report_unit(model.get(), translation);
  require(NMR::lib3mf_model_getbuilditems(model.get(), items.out()), "there are no items");
  Objects_3mf objects(translation);
  for (BOOL has_next = 0;;) {
    require(NMR::lib3mf_builditemiterator_movenext(items.get(), &has_next), "an item is missing");
    if (!has_next)
      break;
    Handle item, object;
    NMR::MODELTRANSFORM place;
    require(NMR::lib3mf_builditemiterator_getcurrent(items.get(), item.out()),
            "an item is missing");
    require(NMR::lib3mf_builditem_getobjectresource(item.get(), object.out()),
            "the object of an item is missing");
    require(NMR::lib3mf_builditem_getobjecttransform(item.get(), &place), "an item has no place");
    objects.add(object.get(), product(identity, place), "");
  }
  return objects.result();
}

} // namespace dsc_files

#else

namespace dsc_files {

vtkSmartPointer<vtkDataSet> read_3mf(const std::string&, Translation&) {
  throw Failure("cannot be read: the program was built without lib3mf (Debian: lib3mf-dev)");
}

} // namespace dsc_files

#endif
