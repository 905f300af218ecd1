// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_IMAGE_SEGMENTATION_INTERNAL_SEGMENTATION_SEGMENTER_H
#define CGAL_IMAGE_SEGMENTATION_INTERNAL_SEGMENTATION_SEGMENTER_H

#include <CGAL/Image_segmentation/Segmentation_options.h>
#include <CGAL/Image_segmentation/Segmentation_report.h>
#include <CGAL/Image_segmentation/internal/segmentation/Cell_costs.h>
#include <CGAL/Image_segmentation/internal/segmentation/Interface_descent.h>
#include <CGAL/Image_segmentation/internal/segmentation/relabel_by_energy.h>
#include <CGAL/Interface_remeshing/control_detail.h>
#include <CGAL/Interface_remeshing/improve_interface.h>
#include <CGAL/Interface_remeshing/refine_cells.h>
#include <CGAL/Interface_remeshing/remove_components.h>
#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/Progress_scope.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// Numbers of rounds, which differ because a round in space takes longer and finds more.
template <int d> struct Segmentation_rule
{
  static constexpr int rounds = d == 2 ? 4 : 2, // for each length of edges
      refinements = d == 2 ? 8 : 4,             // sweeps over the cells in a round
      moves = d == 2 ? 15 : 10,                 // of the interface in a round
      last_moves = d == 2 ? 30 : 15;            // at the end, shorter and shorter
  static constexpr double first_length = .5,    // of edges, relative to the edges of the first mesh
      ratio = 1.5;                              // between two lengths of edges
  static constexpr int interval = 5;            // moves after which the energy must have fallen
  // Changes of the energy relative to the energy of the interface: a decrease in these moves that
  // ends them, and the change in the last moves of a result that has converged.
  static constexpr double slow = 1e-3, converged = 2e-2;
  static constexpr unsigned passes = 5; // of a motion
  // The number of deviations by which the cost of a cell must exceed the usual one.
  static constexpr double significant = 3;
  // Area of a facet of a regular cell, relative to the power of an edge.
  static constexpr double facet_ratio = d == 2 ? 1 : .43;
};

// Minimizes the energy of a segmentation: the costs of cells plus a tension times the measure of
// the interface. The image has noise of deviation 1 in each channel.
template <class Complex> class Segmenter
{
public:
  static constexpr int d = Complex::dimension;
  using Rule = Segmentation_rule<d>;
  using Cell_handle = typename Complex::Cell_handle;

  Segmenter(Complex& complex, Cell_costs<Complex>& costs, const Segmentation_options<d>& options)
      : m_complex(complex), m_costs(costs), m_options(options), m_unit(costs.pixels_in_unit()),
        m_for_each_index(options.number_of_threads) {
    for (std::size_t label = 0; label < costs.intensities().size(); ++label)
      m_relabeling.labels.push_back(int(label));
    const double smallest = costs.least_squared_contrast();
    m_smoothing = options.smoothing.value_or(usual_smoothing(smallest, costs.intensities().size()));
    m_stiffness = part_of_contrast * smallest * std::pow(m_unit, d + 1);
    m_tension = m_smoothing * std::pow(m_unit, d - 1);
    m_relabeling.interface_energy.set_tension(m_tension);
    m_deformation.maximum_number_of_passes = Rule::passes;
    m_deformation.number_of_threads = options.number_of_threads;
  }

  // Gives each cell of a new mesh its best label.
  void label_cells() {
    m_costs.update(m_for_each_index);
    for (const Cell_handle c : m_complex.cells())
      if (const int best = label_of_least_cost(c); best != c->subdomain_index())
        m_complex.relabel(c, best);
  }

  void run(Segmentation_report& report) {
    if (m_options.keeps_topology) {
      const auto forbid = [](const Complex&, Cell_handle, int) { return false; };
      m_relabeling.topology_control = forbid;
      m_deformation.topology_control = forbid;
    }
    double largest = 0; // side of the image, in pixels
    for (int axis = 0; axis < d; ++axis)
      largest = (std::max)(largest, double(grid().size[axis]) * sides_along(axis));
    const double last = (std::min)(m_options.shortest_edge, largest) / m_unit,
                 longest = (std::min)(m_options.longest_edge, largest) / m_unit,
                 first = (std::max)(Rule::first_length * longest, last);
    const int levels = int(std::ceil(std::log(first / last) / std::log(Rule::ratio)));
    for (int level = 0; level <= levels; ++level) {
      m_edge = levels == 0 ? first : first * std::pow(last / first, double(level) / double(levels));
      for (int round = 0; round < Rule::rounds; ++round) {
        relabel();
        refine();
        if (d == 2 || (level == levels && round + 1 == Rule::rounds))
          relabel_components();
        if (m_options.intensities.empty())
          m_costs.measure_intensities();
        move(Rule::moves, false, report);
        improve();
      }
    }
    relabel();
    // Compares the last two motions on different meshes. Shorter steps, which follow, would hide
    // that the motion does not converge.
    const double before = report.energies.empty() ? energy() : report.energies.back();
    move(Rule::moves, false, report);
    report.has_converged = std::abs(before - energy()) < Rule::converged * energy_of_interface() ||
                           m_complex.interface_vertices().empty();
    move(Rule::last_moves, true, report);
    if (m_options.intensities.empty())
      m_costs.measure_intensities();
    report.energies.push_back(energy());
  }

  // Returns the energy of the interface.
  double energy_of_interface() const {
    double measure = 0;
    for (const auto& facet : m_complex.interface_facets(m_for_each_index))
      measure += m_complex.measure(facet);
    return m_tension * measure;
  }

  // Returns the energy.
  double energy() {
    m_costs.update(m_for_each_index);
    return m_costs.total() + energy_of_interface();
  }

  double smoothing() const { return m_smoothing; }

private:
  // The usual smoothing, in multiples of the smallest squared contrast. With less, pixels follow
  // their stairs or, across a boundary of three phases, form a layer of the third one.
  static constexpr double of_two_phases = 1, of_more_phases = 2;
  // At least, in multiples of the smallest contrast. With less, noise forms specks.
  static constexpr double against_specks = d == 2 ? 2.5 : 1.2;
  static double usual_smoothing(double squared_contrast, std::size_t phases) {
    return (std::max)((phases > 2 ? of_more_phases : of_two_phases) * squared_contrast,
                      against_specks * std::sqrt(squared_contrast));
  }
  static constexpr double part_of_contrast = .3; // the stiffness relative to the squared contrast

  void relabel() {
    m_costs.update(m_for_each_index);
    relabel_by_energy(m_complex, costs(), m_relabeling);
    keep_connected();
  }

  void relabel_components() {
    relabel_components_by_energy(m_complex, costs(), m_relabeling);
    keep_connected();
  }

  auto costs() {
    return [this](Cell_handle c, int label) { return m_costs(c, label); };
  }

  void keep_connected() {
    if (!m_options.connected.empty())
      keep_largest_components(m_complex, m_relabeling.interface_energy, nullptr, [this](int label) {
        return std::find(m_options.connected.begin(), m_options.connected.end(), label) !=
               m_options.connected.end();
      });
  }

  // Bisects long cells whose cost exceeds the cost of the noise by more than the energy of a new
  // facet.
  void refine() {
    for (int sweep = 0; sweep < Rule::refinements; ++sweep) {
      m_costs.update(m_for_each_index);
      const std::vector<double> usual = m_costs.usual_costs();
      if (refine_cells(m_complex, [&](Cell_handle c) { return is_to_be_refined(c, usual); }) == 0)
        return;
      if (!m_options.keeps_topology)
        begin_regions(usual);
      relabel();
    }
  }

  // Relabels cells whose cost exceeds the cost of the noise: they get the label with the least
  // cost. A single cell of a new region increases the energy, so relabel_by_energy() does not begin
  // new regions. It is called afterwards and removes regions that increase the energy.
  void begin_regions(const std::vector<double>& usual) {
    m_costs.update(m_for_each_index);
    for (const Cell_handle c : m_complex.cells())
      if (excess(c, usual) > 0)
        if (const int best = label_of_least_cost(c); best != c->subdomain_index())
          m_complex.relabel(c, best);
  }

  int label_of_least_cost(Cell_handle c) {
    int result = c->subdomain_index();
    for (const int label : m_relabeling.labels)
      if (m_costs(c, label) < m_costs(c, result))
        result = label;
    return result;
  }

  bool is_to_be_refined(Cell_handle c, const std::vector<double>& usual) {
    const double squared = std::get<0>(longest_edge(m_complex, c).rank);
    return squared >= 4 * m_edge * m_edge &&
           excess(c, usual) > half_energy_of_facet(std::sqrt(squared));
  }

  // Returns the cost of a cell beyond that of the noise and its fluctuation.
  double excess(Cell_handle c, const std::vector<double>& usual) {
    const double pixels = m_costs.fields(c)[0], of_pixel = usual[std::size_t(c->subdomain_index())];
    return m_costs(c, c->subdomain_index()) - of_pixel * pixels -
           Rule::significant * of_pixel * std::sqrt(2 * pixels / double(m_costs.channels()));
  }

  // Returns half of the energy of a facet of a cell.
  double half_energy_of_facet(double edge) const {
    return m_tension / 2 * Rule::facet_ratio * std::pow(edge, d - 1);
  }

  // Moves the interface until the energy no longer decreases. `reduces_steps` makes the steps
  // shorter and shorter.
  void move(int moves, bool reduces_steps, Segmentation_report& report) {
    bool has_ended = m_complex.interface_vertices().empty();
    Interface_descent<Complex> descent(m_complex, m_costs, m_tension, m_stiffness, m_deformation);
    double before = energy();
    for (int i = 0; i < moves && !has_ended; ++i) {
      Progress_scope::check();
      const double longest = (std::max)(.5 / m_unit, m_edge / 4);
      descent.step(reduces_steps ? longest * double(moves - i) / double(moves) : longest,
                   m_for_each_index);
      if ((i + 1) % Rule::interval != 0)
        continue;
      report.energies.push_back(energy());
      has_ended = before - report.energies.back() < Rule::slow * energy_of_interface();
      before = report.energies.back();
    }
  }

  void improve() {
    static constexpr double split = 2, collapse = .4, coarse = 6; // in target lengths of edges
    Interface_improvement_options<Complex> options;
    options.sizing_field = [this](const auto& p) { return edge_at(p); };
    options.interface_split_length = split;
    options.interface_collapse_length = collapse;
    improve_interface(m_complex, options);
    m_costs.update(m_for_each_index);
    const std::vector<double> usual = m_costs.usual_costs();
    Detail_options<Complex> detail;
    detail.sizing_field = options.sizing_field;
    detail.collapse_length = coarse;
    detail.split_length = 2 * coarse;
    detail.where = [&](Cell_handle c) { return !(excess(c, usual) > 0); };
    control_detail(m_complex, detail);
  }

  // Returns the target length of edges at a point. It grows with the distance from the image,
  // because the complex of a user can be much larger.
  double edge_at(const typename Complex::Point& p) const {
    static constexpr double gradation = .5;
    const auto place = m_costs.moments().place(m_complex.in_user_coordinates(p));
    double distance = 0; // from the image, in sides of a pixel
    for (int axis = 0; axis < d; ++axis)
      distance = (std::max)(distance,
                            sides_along(axis) *
                                (std::max)(-place[axis], place[axis] - double(grid().size[axis])));
    return m_edge + gradation * distance / m_unit;
  }

  const Sampling_grid<d>& grid() const { return m_costs.moments().image().grid; }
  // Returns the length of a pixel along an axis, in sides of a pixel.
  double sides_along(int axis) const {
    return grid().spacing[axis] / m_costs.moments().image().side();
  }

  Complex& m_complex;
  Cell_costs<Complex>& m_costs;
  const Segmentation_options<d>& m_options;
  double m_unit; // length of a unit of the complex in pixels
  For_each_index m_for_each_index;
  Relabeling_options<Complex> m_relabeling;
  Deformation_options<Complex> m_deformation;
  double m_smoothing;            // energy of the interface, in pixels
  double m_tension, m_stiffness; // see Interface_descent
  double m_edge = 0;             // target length
};

} // namespace internal

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_IMAGE_SEGMENTATION_INTERNAL_SEGMENTATION_SEGMENTER_H
