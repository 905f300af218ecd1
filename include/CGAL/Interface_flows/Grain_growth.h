// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_FLOWS_GRAIN_GROWTH_H
#define CGAL_INTERFACE_FLOWS_GRAIN_GROWTH_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Interface_flows/Mean_curvature_flow.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/internal/curvature/Particle_surfaces.h>
#include <CGAL/Interface_remeshing/control_detail.h>
#include <CGAL/Interface_remeshing/improve_interface.h>
#include <CGAL/Interface_remeshing/remove_components.h>
#include <CGAL/Interface_remeshing/shared_measures.h>
#include <CGAL/Mesh_support/Error.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceFlowsRef

Returns the rates of change of the volumes of all labels at the interface, in the plane of their
areas, when the interface starts to move with given velocities. Linear in the size of the interface.

\param interface_ the snapshot of the interface
\param positions, velocities of its vertices
*/
template <class Complex>
std::map<typename Complex::Label, double>
rates_of_change(const Interface_snapshot<Complex>& interface_,
                const std::vector<typename Complex::Point>& positions,
                const std::vector<typename Complex::Vector>& velocities) {
  static constexpr int d = Complex::dimension;
  std::map<typename Complex::Label, double> result;
  for (const auto& facet : interface_.facets()) {
    typename Complex::Vector sum(NULL_VECTOR);
    for (std::size_t v : facet.vertices)
      sum = sum + velocities[v];
    const double swept =
        Complex::Space::facet_normal(interface_.corners(facet, positions)) * sum / (d * (d - 1));
    result[facet.behind] += swept;
    result[facet.in_front] -= swept;
  }
  return result;
}

/// \ingroup PkgInterfaceFlowsRef
/// Options of `Grain_growth`.
struct Grain_growth_options
{
  /// The number of edges of the interface in the diameter of a mean grain. The diameter is the side
  /// of the cube, in the plane the side of the square, with the mean volume of labels.
  double edges_of_grain = 10;
  /// The time step in squares of the length of such an edge, divided by the greatest product of a
  /// tension and a mobility that is expected; see `fastest`.
  double step = .1;
  /// The product of tension and mobility of the fastest interface, positive.
  double fastest = 1;
  /// Number of threads if linked with TBB. The result does not depend on it.
  unsigned number_of_threads = 1;
  /// The greatest length of edges, such as half the radius of particles. Without it, edges become
  /// longer than particles as grains grow.
  double longest_edge = (std::numeric_limits<double>::max)();

  /// Throws an exception unless all values are in their ranges.
  /// \throws Error if a value is not positive or not finite
  void check() const {
    for (const double x : {edges_of_grain, step, fastest, longest_edge})
      if (!(x > 0) || !std::isfinite(x))
        throw Error("an option of grain growth is out of range: use positive, finite numbers");
  }
};

/*!
\ingroup PkgInterfaceFlowsRef

The growth of grains: all labels of a complex are grains, whose interfaces move by an
`Interface_energy`. Edges become longer as grains grow. A grain of at most two edges in diameter
that would vanish within a step is removed as a whole, see `remove_components()`, because a grain of
a few edges cannot shrink at its true rate. At the sides of a box, interfaces end at right angles,
as if the box had mirror images.

Labels whose interfaces all have the mobility 0 when the growth is constructed are particles. They
keep their place, and grain boundaries slide along them. The ends of grain boundaries are projected
to the surfaces of that time, in linear time in their size for each vertex on them.

\tparam Complex a deformable simplicial complex
*/
template <class Complex> class Grain_growth
{
public:
  using Label = typename Complex::Label; ///< a label

  /// What happened in a step.
  struct Report
  {
    double time = 0;                         ///< the time at the end of the step
    double dt = 0;                           ///< the time step
    std::vector<Label> removed;              ///< the grains that were removed as a whole
    Deformation_report<Complex> deformation; ///< the report of the motion
  };

  /// Constructs the growth of the grains of a complex.
  /// \param complex the complex, which must outlive the object
  /// \param energy the energy; copied
  /// \param options the options
  /// \throws Error if an option or a mobility is out of its range
  explicit Grain_growth(Complex& complex, const Interface_energy& energy = {},
                        const Grain_growth_options& options = {})
      : m_complex(complex), m_flow(energy, false, false), m_velocity(energy),
        m_particles(complex, energy), m_options(options) {
    options.check();
  }

  /// Returns the energy.
  const Interface_energy& energy() const { return m_flow.energy(); }

  /// Returns the present time, at first 0.
  double time() const { return m_time; }

  /// Sets the present time. To continue a run with bitwise equal results, construct the growth for
  /// the complex of the beginning, restore the complex from its `Complex::State`, and set the time.
  /// Without particles, the growth can be constructed for the restored complex.
  /// \throws Error if the time is not finite
  void set_time(double time) {
    if (!std::isfinite(time))
      throw Error("the time of grain growth is not finite: use a finite number");
    m_time = time;
  }

  /// Returns the target length of edges: the diameter of a mean grain divided by
  /// `Grain_growth_options::edges_of_grain`, or `Grain_growth_options::longest_edge` if it is less.
  double edge() const {
    double measure = 0;
    const auto labels = m_complex.labels();
    for (Label label : labels)
      measure += m_complex.measure(label);
    return (std::min)(m_options.longest_edge,
                      std::pow(measure / double(labels.size()), 1. / Complex::dimension) /
                          m_options.edges_of_grain);
  }

  /// Returns the length of the next time step.
  double time_step() const {
    const double h = edge();
    return m_options.step * h * h / m_options.fastest;
  }

  /// Performs a time step. Only advances the time if there is no interface.
  /// \param visitor visitor of the changes of the mesh; none if null
  /// \throws Error if a function of the energy returns a value out of its range, or if a system
  ///         cannot be solved. The complex is then valid, and the time is unchanged, but the mesh
  ///         may have changed, and grains may have been removed.
  Report advance(Deformation_visitor<Complex>* visitor = nullptr) {
    Report report;
    report.dt = time_step();
    if (!m_complex.interface_vertices().empty()) {
      release_corners(visitor);
      adapt(visitor);
      report.removed = remove_vanishing(report.dt, visitor);
      Advection_options<Complex> options;
      options.deformation.visitor = visitor;
      options.deformation.number_of_threads = m_options.number_of_threads;
      const internal::Flow_along_particles<Mean_curvature_flow, Complex> flow(m_flow, m_particles);
      report.deformation = advect_interface(m_complex, flow, m_time, report.dt, options);
    }
    m_time += report.dt;
    report.time = m_time;
    return report;
  }

private:
  static constexpr double straight_angle = 180; // no edge is sharp

  // A vertex in a corner of a box cannot move, so it would hold an interface that ends there. All
  // cells around it get one of their labels, the one of least energy, unless an interface there has
  // the mobility 0.
  void release_corners(Deformation_visitor<Complex>* visitor) {
    for (auto v : m_complex.interface_vertices()) {
      const auto sides = v->boundary_class();
      if ((sides & Boundary_class::fixed) != 0 ||
          !Boundary_class::fixes_all(sides, Complex::dimension))
        continue;
      std::vector<typename Complex::Cell_handle> star;
      m_complex.star(v, star);
      std::map<double, Label> labels; // by energy
      bool moves = true;
      for (Label label : labels_around(m_complex, v)) {
        for (const auto& [energy, other] : labels)
          moves = moves && m_flow.energy().mobility(label, other) > 0;
        labels.emplace(energy_of_star(v, star, label), label);
      }
      if (!moves)
        continue;
      for (auto c : star) {
        const Label before = c->subdomain_index();
        if (m_complex.is_infinite(c) || before == labels.begin()->second)
          continue;
        m_complex.relabel(c, labels.begin()->second);
        if (visitor)
          visitor->after_relabel(c, before);
      }
    }
  }

  // Returns the energy of the cells around v, and of their outer facets, if all had a label.
  double energy_of_star(typename Complex::Vertex_handle v,
                        const std::vector<typename Complex::Cell_handle>& star, Label label) const {
    std::map<Label, double> areas;
    double measure = 0;
    for (auto c : star) {
      if (m_complex.is_infinite(c))
        continue;
      measure += m_complex.measure(c);
      const int i = c->index(v);
      if (!m_complex.is_infinite(c->neighbor(i)))
        areas[c->neighbor(i)->subdomain_index()] +=
            m_complex.measure(typename Complex::Facet(c, i));
    }
    return m_flow.energy().of_boundary(label, areas) + m_flow.energy().density(label) * measure;
  }

  // Splits and collapses edges of the interface and of cells, and splits unstable junctions.
  void adapt(Deformation_visitor<Complex>* visitor) {
    static constexpr double split = 1.4, collapse = .5; // halves of split edges are long enough
    Interface_improvement_options<Complex> options;
    options.sizing_field = [h = edge()](const auto&) { return h; };
    options.interface_split_length = split;
    options.interface_collapse_length = collapse;
    options.curved_splits = true;
    options.aggressiveness = 0;
    options.feature_angle = straight_angle;
    options.split_junctions = true;
    options.interface_energy = m_flow.energy();
    options.visitor = visitor;
    improve_interface(m_complex, options);
    Detail_options<Complex> detail;
    detail.sizing_field = options.sizing_field;
    detail.visitor = visitor;
    control_detail(m_complex, detail);
  }

  // Removes the grains of a few edges that would vanish within dt at their present rates. At short
  // edges, such as at particles, the rates of the explicit flow can be too large.
  std::vector<Label> remove_vanishing(double dt, Deformation_visitor<Complex>* visitor) {
    const Interface_snapshot<Complex> interface_(m_complex);
    const auto positions = interface_.positions(m_complex);
    std::vector<typename Complex::Vector> velocities;
    m_velocity(interface_, positions, m_time, velocities);
    const auto rates = rates_of_change(interface_, positions, velocities);
    static constexpr double largest = 2; // diameter in edges
    const double largest_measure = std::pow(largest * edge(), Complex::dimension);
    const auto vanishes = [&](Label label, double measure) {
      const auto rate = rates.find(label);
      return rate != rates.end() && measure <= largest_measure &&
             measure + dt * rate->second <= 0 && m_complex.number_of_components(label) == 1;
    };
    for (const auto& [label, rate] : rates) // a pass over all cells only if necessary
      if (vanishes(label, m_complex.measure(label)))
        return remove_components(
            m_complex, [&](Label l, std::uint32_t, double measure) { return vanishes(l, measure); },
            m_flow.energy(), visitor);
    return {};
  }

  Complex& m_complex;
  Mean_curvature_flow m_flow;
  Mean_curvature_velocity m_velocity;
  internal::Particle_surfaces<Complex> m_particles;
  Grain_growth_options m_options;
  double m_time = 0;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_FLOWS_GRAIN_GROWTH_H
