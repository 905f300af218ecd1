#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_ARCHETYPES_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_ARCHETYPES_H

#include "small_meshes.h"

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/quality_measures.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_ds_cell_base_3.h>
#include <CGAL/Triangulation_ds_vertex_base_3.h>
#include <CGAL/enum.h>
#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

// Models that provide only the requirements of the concepts of the package. Code that compiles with
// them needs no further requirements.
namespace archetypes {

// DeformableSimplicialComplexTraits_3

class Traits
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

public:
  using FT = double;
  using Point_3 = Kernel::Point_3;
  using Vector_3 = Kernel::Vector_3;
  using Orientation_3 = Kernel::Orientation_3;

  // names that Triangulation_3 mentions but does not use here
  class Segment_3;
  class Triangle_3;
  class Tetrahedron_3;
  class Construct_point_3;

  Orientation_3 orientation_3_object() const { return {}; }
};

// DeformableSimplicialComplexVertexBase_3

template <class Tds = void> class Vertex_base : public CGAL::Triangulation_ds_vertex_base_3<Tds>
{
  using Base = CGAL::Triangulation_ds_vertex_base_3<Tds>;

public:
  template <class Tds2> struct Rebind_TDS
  {
    using Other = Vertex_base<Tds2>;
  };
  using Point = Traits::Point_3;
  using Has_timestamp = CGAL::Tag_true;

  const Point& point() const { return m_point; }
  void set_point(const Point& p) { m_point = p; }
  std::size_t time_stamp() const { return m_time_stamp; }
  void set_time_stamp(std::size_t stamp) { m_time_stamp = stamp; }
  bool is_interface() const { return m_interface_degree > 0; }
  std::uint32_t interface_degree() const { return m_interface_degree; }
  void set_interface_degree(std::uint32_t degree) { m_interface_degree = degree; }
  std::uint8_t boundary_class() const { return m_boundary_class; }
  void set_boundary_class(std::uint8_t boundary_class) { m_boundary_class = boundary_class; }
  float spacing() const { return m_spacing; }
  void set_spacing(float spacing) { m_spacing = spacing; }
  std::uint32_t id() const { return m_id; }
  void set_id(std::uint32_t id) { m_id = id; }

private:
  Point m_point;
  std::size_t m_time_stamp = std::size_t(-1);
  std::uint32_t m_id = 0, m_interface_degree = 0;
  float m_spacing = 0;
  std::uint8_t m_boundary_class = 0;
};

// DeformableSimplicialComplexCellBase_3

template <class Tds = void> class Cell_base : public CGAL::Triangulation_ds_cell_base_3<Tds>
{
  using Base = CGAL::Triangulation_ds_cell_base_3<Tds>;

public:
  template <class Tds2> struct Rebind_TDS
  {
    using Other = Cell_base<Tds2>;
  };
  using Has_timestamp = CGAL::Tag_true;
  using Base::Base;

  std::size_t time_stamp() const { return m_time_stamp; }
  void set_time_stamp(std::size_t stamp) { m_time_stamp = stamp; }
  std::uint32_t id() const { return m_id; }
  void set_id(std::uint32_t id) { m_id = id; }
  int label() const { return m_label; }
  void set_label(int label) { m_label = label; }
  double quality() const { return m_quality; }
  void set_quality(double quality) { m_quality = quality; }
  std::uint32_t component() const { return m_component; }
  void set_component(std::uint32_t component) { m_component = component; }
  float noted_quality() const { return m_noted_quality; }
  void set_noted_quality(float quality) { m_noted_quality = quality; }
  std::uint8_t failures() const { return m_failures; }
  void set_failures(std::uint8_t bits) { m_failures = bits; }

private:
  int m_label = 0;
  std::uint32_t m_component = 0, m_id = 0;
  std::uint8_t m_failures = 0;
  float m_noted_quality = 1;
  double m_quality = 1;
  std::size_t m_time_stamp = std::size_t(-1);
};

// TetrahedronQualityMeasure_3

class Quality_measure
{
public:
  double operator()(const Traits::Point_3& p, const Traits::Point_3& q, const Traits::Point_3& r,
                    const Traits::Point_3& s) const {
    return DSC::Volume_length_ratio_3()(p, q, r, s);
  }
};

// DeformationVisitor; it is passed by reference, so it is not copyable

template <class Complex> class Visitor
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;

  Visitor() = default;
  Visitor(const Visitor&) = delete;
  Visitor& operator=(const Visitor&) = delete;

  void before_replacement(const typename Complex::Cavity&) {}
  void after_replacement(const typename Complex::Cavity&) {}
  void before_smoothing(Vertex_handle, const std::vector<Cell_handle>&,
                        const typename Complex::Point_3&) {}
  void after_smoothing(Vertex_handle, const std::vector<Cell_handle>&) {}
  void after_split(Vertex_handle, Vertex_handle, Vertex_handle) {}
  void before_collapse(Vertex_handle, Vertex_handle) {}
  void after_flip(const std::vector<Cell_handle>&) {}
  void after_relabel(Cell_handle, int) {}
  template <class Vertex_handle> void after_insertion(Vertex_handle) {}
  template <class Event> void after_topology_event(const Event&) {}
  bool go_further(unsigned) { return true; }
};

// The destination of a vertex, InterfaceFlowMap, VelocityField, InterfaceVelocity, and
// InterfaceStep: all displace by the same small vector.

inline Traits::Vector_3 small_vector() { return {.03, .02, .01}; }

template <class Complex> class Destination
{
public:
  explicit Destination(const Complex& dsc) : m_complex(dsc) {}
  typename Complex::Point_3 operator()(typename Complex::Vertex_handle v) const {
    return m_complex.position(v) + small_vector();
  }

private:
  const Complex& m_complex;
};

class Flow_map
{
public:
  Traits::Point_3 operator()(const Traits::Point_3& p, double, double dt) const {
    return p + dt * small_vector();
  }
};

class Velocity_field
{
public:
  Traits::Vector_3 operator()(const Traits::Point_3&, double) const { return small_vector(); }
};

template <class Complex> class Interface_velocity
{
public:
  void operator()(const DSC::Interface_snapshot<Complex>&,
                  const std::vector<Traits::Point_3>& positions, double,
                  std::vector<Traits::Vector_3>& velocities) const {
    velocities.assign(positions.size(), small_vector());
  }
};

template <class Complex> class Interface_step
{
public:
  void operator()(const DSC::Interface_snapshot<Complex>&,
                  const std::vector<Traits::Point_3>& positions, double, double dt,
                  std::vector<Traits::Point_3>& destinations) const {
    for (const Traits::Point_3& p : positions)
      destinations.push_back(p + dt * small_vector());
  }
};

using Complex = CGAL::Deformable_simplicial_complex_3<
    Traits, CGAL::Triangulation_data_structure_3<Vertex_base<>, Cell_base<>>, Quality_measure>;

inline Complex make_complex(const small_meshes::Labeled_mesh& mesh) {
  Complex dsc;
  std::vector<Traits::Point_3> points;
  for (const auto& p : mesh.points)
    points.emplace_back(p.x(), p.y(), p.z());
  dsc.assign(points, mesh.tetrahedra, mesh.labels);
  return dsc;
}

} // namespace archetypes

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_ARCHETYPES_H
