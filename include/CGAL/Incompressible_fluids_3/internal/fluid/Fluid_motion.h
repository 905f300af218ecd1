// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_FLUID_MOTION_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_FLUID_MOTION_H

#include <CGAL/Incompressible_fluids_3/internal/mesh/fluid_vectors.h>
#include <CGAL/property_map.h>

#include <optional>
#include <unordered_map>
#include <utility>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The velocity, the acceleration and the pressure of vertices of liquids, in this order. Where two
// liquids slip along each other, each of them has its own velocity, acceleration and pressure. A
// vertex also has the value of the field that liquids carry, which is common to all of them.
class Fluid_motion
{
public:
  using Numbers = Eigen::Matrix<double, 7, 1>;

  // The numbers of a vertex. The numbers of a liquid are the common numbers plus its deviation.
  // Deviations are by increasing label. The deviation of a liquid that is not in the list is zero.
  // So values are elements of a vector space, and can be interpolated. In a cell of a liquid, its
  // numbers are interpolated exactly.
  class Value
  {
  public:
    Numbers common = Numbers::Zero();
    // While the mesh changes: 1 if the vertex is on a wall, and 0 if it is not.
    double wetting = 0;
    double field = 0;
    std::vector<std::pair<int, Numbers>> deviations;

    // Returns the numbers of the liquid with a label, or the common numbers.
    Numbers of(std::optional<int> label) const {
      if (label)
        for (const auto& deviation : deviations)
          if (deviation.first == *label)
            return common + deviation.second;
      return common;
    }
    // Returns the deviation of the liquid with a label, to be changed.
    Numbers& deviation(int label) {
      const auto place =
          std::lower_bound(deviations.begin(), deviations.end(), label,
                           [](const auto& entry, int other) { return entry.first < other; });
      return (place != deviations.end() && place->first == label
                  ? place
                  : deviations.insert(place, {label, Numbers::Zero()}))
          ->second;
    }

    friend Value operator+(Value a, const Value& b) {
      a.common += b.common;
      a.wetting += b.wetting;
      a.field += b.field;
      for (const auto& [label, numbers] : b.deviations)
        a.deviation(label) += numbers;
      return a;
    }
    friend Value operator*(double factor, Value value) {
      value.common *= factor;
      value.wetting *= factor;
      value.field *= factor;
      for (auto& deviation : value.deviations)
        deviation.second *= factor;
      return value;
    }
  };

  // A property map for visitors, by reference. Vertices without a value are at rest.
  template <class Complex> class Map
  {
  public:
    using key_type = typename Complex::Vertex_handle;
    using value_type = Value;
    using reference = Value;
    using category = boost::read_write_property_map_tag;

    explicit Map(Fluid_motion& motion) : m_motion(&motion) {}

    friend Value get(const Map& map, key_type v) { return map.m_motion->at(v); }
    friend void put(const Map& map, key_type v, const Value& value) { map.m_motion->put(v, value); }

  private:
    Fluid_motion* m_motion;
  };

  // Returns the value of a vertex, or 0 if it has no value.
  template <class Vertex_handle> const Value& at(Vertex_handle v) const {
    static const Value zero;
    const auto found = m_values.find(v->time_stamp());
    return found == m_values.end() ? zero : found->second;
  }

  template <class Vertex_handle> void put(Vertex_handle v, const Value& value) {
    m_values[v->time_stamp()] = value;
  }

  // Returns the numbers of the liquid with a label at a vertex, or the common numbers.
  template <class Vertex_handle>
  Eigen::Vector3d velocity(Vertex_handle v, std::optional<int> label = {}) const {
    return at(v).of(label).template head<3>();
  }
  template <class Vertex_handle>
  Eigen::Vector3d acceleration(Vertex_handle v, std::optional<int> label = {}) const {
    return at(v).of(label).template segment<3>(3);
  }
  template <class Vertex_handle>
  double pressure(Vertex_handle v, std::optional<int> label = {}) const {
    return at(v).of(label)(6);
  }

  template <class Vertex_handle> double field(Vertex_handle v) const { return at(v).field; }

  // Sets the field at all vertices of a mesh.
  template <class Mesh> void set_field(const Mesh& mesh, const std::vector<double>& field) {
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
      value_of(mesh.vertices[v]).field = field[v];
  }

  // Clears velocities, accelerations and pressures. Keeps the field.
  void stop() {
    for (auto& entry : m_values) {
      const double field = entry.second.field;
      entry.second = Value();
      entry.second.field = field;
    }
  }

  // Sets the velocities and accelerations of all vertices of a mesh, and keeps the pressures.
  template <class Mesh>
  void set(const Mesh& mesh, const Vectors_3& velocities, const Vectors_3& accelerations) {
    const Vectors_3 common_velocities = mesh.common(velocities),
                    common_accelerations = mesh.common(accelerations);
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
      Value& value = value_of(mesh.vertices[v]);
      value.common.template head<6>() << common_velocities[v], common_accelerations[v];
      for (auto& deviation : value.deviations)
        deviation.second.template head<6>().setZero();
    }
    for (const auto& slip : mesh.slips)
      for (auto v : {slip.first, slip.second})
        value_of(mesh.vertices[v]).deviation(*mesh.labels[v]).template head<6>()
            << velocities[v] - common_velocities[v],
            accelerations[v] - common_accelerations[v];
  }

  // Records the vertices of a mesh on walls, before the mesh changes.
  template <class Mesh, class IsWetted>
  void set_wetting(const Mesh& mesh, const IsWetted& is_wetted) {
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
      value_of(mesh.vertices[v]).wetting = is_wetted(v) ? 1 : 0;
  }

  // Returns whether a vertex is from a wall: it was there when the mesh changed, or the change
  // created it between vertices of the wall.
  template <class Vertex_handle> bool is_from_wall(Vertex_handle v) const {
    static constexpr double most = .75;
    return at(v).wetting > most;
  }

  // Sets the pressures of all vertices of a mesh, in the order of the mesh. The common pressure of
  // several liquids is their mean.
  template <class Mesh> void set_pressures(const Mesh& mesh, const Eigen::VectorXd& pressures) {
    std::vector<double> sums(mesh.vertices.size(), 0), numbers(mesh.vertices.size(), 0);
    for (std::size_t p = 0; p < mesh.vertex_of_pressure.size(); ++p) {
      const auto v = mesh.first(mesh.vertex_of_pressure[p]);
      sums[v] += pressures(Eigen::Index(p));
      ++numbers[v];
    }
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
      Value& value = value_of(mesh.vertices[v]);
      value.common(6) = sums[v] / numbers[v];
      for (auto& deviation : value.deviations)
        deviation.second(6) = 0;
    }
    for (std::size_t p = 0; p < mesh.vertex_of_pressure.size(); ++p) {
      const auto v = mesh.first(mesh.vertex_of_pressure[p]);
      if (numbers[v] > 1)
        value_of(mesh.vertices[v]).deviation(mesh.label_of_pressure[p])(6) =
            pressures(Eigen::Index(p)) - sums[v] / numbers[v];
    }
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) { // of liquids that are gone
      auto& deviations = value_of(mesh.vertices[v]).deviations;
      deviations.erase(std::remove_if(deviations.begin(), deviations.end(),
                                      [](const auto& d) { return d.second.isZero(0); }),
                       deviations.end());
    }
  }

  // Removes the values of all other vertices.
  template <class Vertices> void keep(const Vertices& vertices) {
    std::unordered_map<std::size_t, Value> kept;
    for (auto v : vertices)
      if (const auto found = m_values.find(v->time_stamp()); found != m_values.end())
        kept.insert(std::move(*found));
    m_values.swap(kept);
  }

private:
  template <class Vertex_handle> Value& value_of(Vertex_handle v) {
    return m_values.try_emplace(v->time_stamp()).first->second;
  }

  std::unordered_map<std::size_t, Value> m_values; // by time stamp
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_FLUID_MOTION_H
