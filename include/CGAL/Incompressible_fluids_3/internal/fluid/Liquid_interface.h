// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_LIQUID_INTERFACE_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_LIQUID_INTERFACE_H

#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Incompressible_fluids_3/Fluid_properties.h>
#include <CGAL/Incompressible_fluids_3/internal/fluid/Fluid_bookkeeping.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/Fluid_mesh.h>
#include <CGAL/Interface_remeshing/Volume_changer.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Sets the surface tensions of facets for a field, which is given by vertex of the mesh. The
// tension of a facet is the tension at the mean of its vertices. Functions of users determine
// tensions.
// \throws Error if a tension is negative or not finite
template <class Complex>
void set_tensions(Fluid_mesh<Complex>& mesh, const Fluid_properties& properties,
                  const std::vector<double>& field) {
  for (auto& facet : mesh.facets) {
    double mean = 0;
    for (auto v : facet.vertices)
      mean += field[v] / Complex::dimension;
    facet.tension = properties.surface_tension(facet.label_behind, facet.label_in_front, mean);
  }
}

// The interface as the boundary of the connected components of liquids. All other labels are void
// here.
template <class Complex> class Liquid_interface
{
public:
  using Snapshot = Interface_snapshot<Complex>;
  using Point = typename Complex::Point;
  using Points = std::vector<Point>;
  using Volumes = Liquid_bookkeeping::Volumes;

  // Constructs the interface, with the present volumes of components.
  // \pre The components are up to date.
  Liquid_interface(const Complex& complex, const Fluid_properties& properties,
                   const Volumes& present)
      : m_snapshot(complex), m_present(present) {
    const auto component = [&](typename Complex::Cell_handle c) {
      return properties.liquid(c->subdomain_index()) ? int(c->component()) : void_component;
    };
    const auto facets = complex.interface_facets();
    for (std::size_t i = 0; i < facets.size(); ++i) {
      auto& facet = m_snapshot.facets()[i];
      facet.behind = component(facets[i].first);
      facet.in_front = component(facets[i].first->neighbor(facets[i].second));
    }
  }

  const Snapshot& snapshot() const { return m_snapshot; }

  // Moves destinations of vertices along normals so that the connected components have the wanted
  // volumes. For each component, the correction is equally long at all vertices. Vertices with
  // `is_constrained(v)` are not moved.
  template <class IsConstrained>
  void restore(const Volumes& target, const Points& from, const IsConstrained& is_constrained,
               Points& to) const {
    const Volume_changer<Complex> changer(m_snapshot);
    const auto swept = changer.changes(from, to);
    std::map<int, double> missing;
    for (const auto& [component, volume] : target) {
      const auto change = swept.find(int(component));
      missing[int(component)] =
          volume - m_present.at(component) - (change == swept.end() ? 0 : change->second);
    }
    auto directions = changer.gradients(missing, to);
    std::vector<double> areas(to.size(),
                              0); // by vertex: equal shares of the areas of the facets around
    for (const auto& facet : m_snapshot.facets()) {
      Corners_3<std::size_t(Complex::dimension)> corners;
      for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = eigen_vector(
            m_snapshot.domain.nearest_image(to[facet.vertices[0]], to[facet.vertices[i]]));
      const double area = area_vector(corners).norm() / Complex::dimension;
      for (std::size_t v : facet.vertices)
        areas[v] += area;
    }
    for (std::size_t v = 0; v < to.size(); ++v)
      for (auto& [row, direction] : directions[v])
        direction = is_constrained(v) || !(areas[v] > 0) ? typename Complex::Vector(NULL_VECTOR)
                                                         : direction / areas[v];
    changer.change_by(missing, directions, to);
  }

private:
  static constexpr int void_component = -1;

  Snapshot m_snapshot; // its labels are numbers of components
  Volumes m_present;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_LIQUID_INTERFACE_H
