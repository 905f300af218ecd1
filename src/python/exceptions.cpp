// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Guarded.h"
#include "arrays.h"
#include "module.h"

#include "programs/errors.h"

#include <CGAL/Complex_construction/Tetrahedralization_3.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Incompressible_fluids_3/fluid_errors.h>
#include <CGAL/Mesh_files/File_error.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Solid_reconstruction_3/Invalid_points_error.h>
#include <CGAL/Triangle_soup_repair/Invalid_surface_error.h>

namespace dsc_python {
namespace {

namespace DSC = CGAL::Deformable_simplicial_complexes;

/// Raises an exception of a class of the Python package, which has attributes.
void raise(const char* name, const std::exception& error, const py::dict& attributes = py::dict()) {
  const py::object type = py::module_::import("dsc._errors").attr(name);
  const py::object exception = type(error.what());
  for (const auto& [key, value] : attributes)
    py::setattr(exception, key, value);
  PyErr_SetObject(type.ptr(), exception.ptr());
}

void translate(std::exception_ptr exception) {
  using namespace pybind11::literals;
  if (exception == nullptr)
    return;
  try {
    std::rethrow_exception(exception);
  } catch (const DSC::Interrupted_error& error) {
    raise("Interrupted", error);
  } catch (const Busy_error& error) {
    raise("BusyError", error);
  } catch (const DSC::Invalid_surface_error& error) {
    raise("InvalidSurfaceError", error,
          py::dict("surface"_a = error.surface(), "other_surface"_a = error.other_surface(),
                   "facets"_a = array_of_indices(error.facets()),
                   "vertices"_a = array_of_indices(error.vertices())));
  } catch (const DSC::Invalid_cells_error& error) {
    raise("InvalidCellsError", error,
          py::dict("cells"_a = array_of_indices(error.tetrahedra()),
                   "vertices"_a = array_of_indices(error.vertices())));
  } catch (const DSC::Invalid_points_error& error) {
    raise("InvalidPointsError", error, py::dict("points"_a = array_of_indices(error.points())));
  } catch (const DSC::Invalid_destination_error& error) {
    raise("InvalidDestinationError", error,
          py::dict("vertices"_a = array_of_indices(error.vertices())));
  } catch (const DSC::Tetrahedralization_error& error) {
    raise("TetrahedralizationError", error, py::dict("code"_a = error.code()));
  } catch (const DSC::File_error& error) {
    raise("FileError", error, py::dict("path"_a = error.path()));
  } catch (const DSC::Fluid_step_error& error) {
    raise("FluidStepError", error, py::dict("step"_a = error.step()));
  } catch (const dsc::Usage_error& error) { // of the description of a solid
    raise("InvalidSolidError", error);
  } catch (const DSC::Error& error) {
    raise("Error", error);
  }
}

} // namespace

void bind_exceptions(py::module_&) { py::register_exception_translator(&translate); }

} // namespace dsc_python
