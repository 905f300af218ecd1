// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_FLUID_MOTION_3_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_FLUID_MOTION_3_H

#include <CGAL/property_map.h>

#include <Eigen/Core>

#include <cstddef>
#include <unordered_map>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The velocity, the acceleration and the pressure of vertices of liquids, in this order.
class Fluid_motion_3
{
public:
  using Value = Eigen::Matrix<double, 7, 1>;

  // A property map for visitors, by reference. Vertices without a value are at rest.
  template <class Complex> class Map
  {
  public:
    using key_type = typename Complex::Vertex_handle;
    using value_type = Value;
    using reference = Value;
    using category = boost::read_write_property_map_tag;

    explicit Map(Fluid_motion_3& motion) : m_motion(&motion) {}

    friend Value get(const Map& map, key_type v) { return map.m_motion->at(v->time_stamp()); }
    friend void put(const Map& map, key_type v, const Value& value) {
      map.m_motion->put(v->time_stamp(), value);
    }

  private:
    Fluid_motion_3* m_motion;
  };

  // Returns the value of a vertex, given by its time stamp, or 0 if it has no value.
  Value at(std::size_t time_stamp) const {
    const auto found = m_values.find(time_stamp);
    return found == m_values.end() ? Value(Value::Zero()) : found->second;
  }

  void put(std::size_t time_stamp, const Value& value) { m_values[time_stamp] = value; }

  template <class Vertex_handle> Eigen::Vector3d velocity(Vertex_handle v) const {
    return at(v->time_stamp()).template head<3>();
  }
  template <class Vertex_handle> Eigen::Vector3d acceleration(Vertex_handle v) const {
    return at(v->time_stamp()).template segment<3>(3);
  }
  template <class Vertex_handle> double pressure(Vertex_handle v) const {
    return at(v->time_stamp())(6);
  }

  // Sets the velocity and the acceleration, and keeps the pressure.
  template <class Vertex_handle>
  void set(Vertex_handle v, const Eigen::Vector3d& velocity, const Eigen::Vector3d& acceleration) {
    value_of(v).template head<6>() << velocity, acceleration;
  }
  template <class Vertex_handle> void set_pressure(Vertex_handle v, double pressure) {
    value_of(v)(6) = pressure;
  }

  // Removes the values of all other vertices.
  template <class Vertices> void keep(const Vertices& vertices) {
    std::unordered_map<std::size_t, Value> kept;
    for (auto v : vertices)
      if (const auto found = m_values.find(v->time_stamp()); found != m_values.end())
        kept.insert(*found);
    m_values.swap(kept);
  }

private:
  template <class Vertex_handle> Value& value_of(Vertex_handle v) {
    return m_values.try_emplace(v->time_stamp(), Value::Zero()).first->second;
  }

  std::unordered_map<std::size_t, Value> m_values; // by time stamp
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_FLUID_MOTION_3_H
