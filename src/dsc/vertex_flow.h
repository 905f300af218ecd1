// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_VERTEX_FLOW_H
#define DSC_VERTEX_FLOW_H

#include <CGAL/Deformable_simplicial_complexes/Mesh_arrays.h>

#include <functional>

namespace dsc {

/// The velocity and the pressure of a fluid at the vertices of a complex.
template <class Complex> struct Vertex_flow
{
  using Vertex_handle = typename Complex::Vertex_handle;

  /// Both functions are set or none. In the plane, the velocity has two coordinates.
  std::function<typename Complex::Approximate_vector(Vertex_handle)> velocity_at;
  std::function<double(Vertex_handle)> pressure_at;

  bool is_set() const { return bool(velocity_at); }

  /// Returns the values as arrays on the points of a VTU file. Velocities have three components.
  /// \pre `is_set()`
  CGAL::Deformable_simplicial_complexes::Mesh_arrays arrays(const Complex& complex) const {
    CGAL::Deformable_simplicial_complexes::Mesh_arrays result;
    result.points = {{"velocity", "Float64", 3, {}}, {"pressure", "Float64", 1, {}}};
    for (const auto v : complex.vertices()) {
      const auto velocity = velocity_at(v);
      for (int axis = 0; axis < 3; ++axis)
        result.points[0].values.push_back(axis < Complex::dimension ? velocity[axis] : 0);
      result.points[1].values.push_back(pressure_at(v));
    }
    return result;
  }
};

} // namespace dsc

#endif // DSC_VERTEX_FLOW_H
