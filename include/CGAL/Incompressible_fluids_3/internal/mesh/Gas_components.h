// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_GAS_COMPONENTS_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_GAS_COMPONENTS_H

#include <CGAL/Incompressible_fluids_3/Fluid_properties.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/Fluid_mesh.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A connected component of a gas. The product of its pressure and the power volume^exponent is
// constant. Powers are computed from ratios of volumes only, so that the unit of length has no
// effect.
struct Gas_component
{
  Gas gas;
  double volume;
  double reference_pressure, reference_volume; // a pressure, and the volume at this pressure

  // Returns the pressure at volume v.
  double pressure(double v) const {
    return reference_pressure * std::pow(reference_volume / v, gas.exponent);
  }
  double pressure() const { return pressure(volume); }
  // Returns the potential of the pressure at volume v. For exponent 1, it is 0 at the reference
  // volume.
  double energy(double v) const {
    return gas.exponent == 1
               ? reference_pressure * reference_volume * std::log(reference_volume / v)
               : pressure(v) * v / (gas.exponent - 1);
  }
};

// Returns the volumes of gases after the vertices of liquids have moved from some positions to
// others, along the differences of these positions. A volume is at least a tenth of its present
// value.
template <class Mesh>
std::vector<double> volumes_of_gases(const Mesh& mesh, const std::vector<Gas_component>& gases,
                                     const Vectors_3& from, const Vectors_3& to) {
  std::vector<double> result;
  for (const Gas_component& gas : gases)
    result.push_back(gas.volume);
  for (const auto& facet : mesh.facets)
    if (facet.gas != Mesh::no_gas) {
      // The area at the midpoint, multiplied by the mean displacement, is the swept volume up to
      // terms of third order.
      Corners_3<std::size_t(Mesh::dimension)> middles;
      Eigen::Vector3d displacement = Eigen::Vector3d::Zero();
      for (std::size_t i = 0; i < middles.size(); ++i) {
        const auto v = facet.vertices[i];
        const Eigen::Vector3d middle = (from[v] + to[v]) / 2;
        middles[i] = i == 0 ? middle : mesh.nearest_image(middles[0], middle);
        displacement += (to[v] - from[v]) / Mesh::dimension;
      }
      const double swept = area_vector(middles).dot(displacement);
      result[facet.gas] -= facet.is_gas_in_front ? swept : -swept;
    }
  static constexpr double least = .1; // of the present volume: the least volume of a prediction
  for (std::size_t k = 0; k < gases.size(); ++k)
    result[k] = (std::max)(result[k], least * gases[k].volume);
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_GAS_COMPONENTS_H
