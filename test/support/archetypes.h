#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_ARCHETYPES_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_ARCHETYPES_H

#include "small_meshes.h"

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/quality_measures.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/enum.h>

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

// TetrahedronQualityMeasure_3

class Quality_measure
{
public:
  double operator()(const Traits::Point_3& p, const Traits::Point_3& q, const Traits::Point_3& r,
                    const Traits::Point_3& s) const {
    return DSC::Volume_length_ratio_3()(p, q, r, s);
  }
};

// A visitor; it is passed by reference, so it is not copyable

template <class Complex> class Visitor : public DSC::Deformation_visitor<Complex>
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;

  Visitor() = default;
  Visitor(const Visitor&) = delete;
  Visitor& operator=(const Visitor&) = delete;

  void before_replacement(const typename Complex::Cavity&) override {}
  void after_replacement(const typename Complex::Cavity&) override {}
  void before_smoothing(Vertex_handle, const std::vector<Cell_handle>&,
                        const typename Complex::Point_3&) override {}
  void after_smoothing(Vertex_handle, const std::vector<Cell_handle>&) override {}
  void after_split(Vertex_handle, Vertex_handle, Vertex_handle) override {}
  void before_collapse(Vertex_handle, Vertex_handle) override {}
  void after_flip(const std::vector<Cell_handle>&) override {}
  void after_relabel(Cell_handle, int) override {}
  void after_insertion(Vertex_handle) override {}
  void after_topology_event(const DSC::Topology_event<Complex>&) override {}
  bool go_further(unsigned) override { return true; }
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

using Complex = CGAL::Deformable_simplicial_complex_3<Traits, CGAL::Default, Quality_measure>;

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
