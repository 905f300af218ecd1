// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_CONVERT_LABELED_IMAGE_3_H
#define CGAL_COMPLEX_CONSTRUCTION_CONVERT_LABELED_IMAGE_3_H

#include <CGAL/Complex_construction/Construction_options.h>
#include <CGAL/Complex_construction/Octree_tetrahedra_3.h>
#include <CGAL/Complex_construction/internal/conversion/Voxel_components_3.h>
#include <CGAL/Complex_construction/internal/conversion/Voxel_frame_3.h>
#include <CGAL/Complex_construction/internal/conversion/Voxel_pyramid_3.h>
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Complex_construction/refine_thin_parts.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Interface_remeshing/Volume_changer.h>
#include <CGAL/Interface_remeshing/control_detail.h>
#include <CGAL/Interface_remeshing/improve_interface.h>
#include <CGAL/Interface_remeshing/restore_volumes.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/named_parameters.h>
#include <CGAL/Mesh_support/parameter_values.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// A smoother for the surface of voxels that keeps vertices near their initial positions
// ("constrained elastic surface nets", Gibson 1998). A vertex moves towards the mean of its
// neighbors. A vertex on a line where more than two facets meet moves towards the mean of its
// neighbors on such lines.
template <class Complex> class Stairs_smoother_3
{
public:
  using Point = typename Complex::Point;
  using Vector = typename Complex::Vector;

  // The displacement of a vertex from its initial position is bounded, along each axis, by half its
  // shortest edge. Vertices stay on the sides of the domain that they lie on.
  Stairs_smoother_3(const Interface_snapshot<Complex>& interface_, std::vector<Point> places,
                    const std::array<double, 3>& voxel)
      : m_places(std::move(places)), m_voxel(voxel),
        m_reach(m_places.size(), std::numeric_limits<double>::infinity()) {
    for (const auto& v : interface_.vertices)
      m_sides.push_back(v->boundary_class());
    std::vector<Edge> edges; // an edge appears once for each of its facets
    for (const auto& facet : interface_.facets())
      for (int i = 0; i < 3; ++i)
        edges.push_back(std::minmax(facet.vertices[i], facet.vertices[(i + 1) % 3]));
    std::sort(edges.begin(), edges.end());
    static constexpr std::ptrdiff_t facets_in_a_sheet = 2;
    std::vector<Edge> all, lines;
    for (auto first = edges.begin(); first != edges.end();) {
      const auto last = std::upper_bound(first, edges.end(), *first);
      all.push_back(*first);
      if (last - first > facets_in_a_sheet)
        lines.push_back(*first);
      first = last;
    }
    std::vector<std::size_t> lines_at(m_places.size(), 0);
    for (const auto& [a, b] : lines) {
      ++lines_at[a];
      ++lines_at[b];
    }
    const auto is_on_line = [&](std::size_t v) { return lines_at[v] >= 2; };
    for (const auto& [a, b] : all) {
      const double half = .5 * length(a, b);
      m_reach[a] = (std::min)(m_reach[a], half);
      m_reach[b] = (std::min)(m_reach[b], half);
    }
    for (const bool on_lines : {false, true})
      for (const auto& [a, b] : on_lines ? lines : all)
        for (const Edge& tie : {Edge(a, b), Edge(b, a)})
          if (is_on_line(tie.first) == on_lines)
            m_ties.push_back(tie);
  }

  // Moves all vertices by one step.
  void relax(std::vector<Point>& positions) const {
    // Fraction of the displacement to the mean. With this value a single voxel keeps enough volume
    // for one correction to restore it.
    static constexpr double part = .25;
    std::vector<Vector> sums(positions.size(), NULL_VECTOR);
    std::vector<std::size_t> numbers(positions.size(), 0);
    for (const auto& [v, neighbor] : m_ties) {
      sums[v] = sums[v] + (positions[neighbor] - positions[v]);
      ++numbers[v];
    }
    for (std::size_t v = 0; v < positions.size(); ++v) {
      Progress_scope::check();
      if (numbers[v] == 0)
        continue;
      const Vector displacement =
          positions[v] + sums[v] * (part / double(numbers[v])) - m_places[v];
      std::array<double, 3> kept;
      for (int axis = 0; axis < 3; ++axis)
        kept[axis] = Boundary_class::fixes(m_sides[v], axis)
                         ? 0
                         : std::clamp(displacement[axis], -m_reach[v] * m_voxel[axis],
                                      m_reach[v] * m_voxel[axis]);
      positions[v] = m_places[v] + Vector(kept[0], kept[1], kept[2]);
    }
  }

private:
  using Edge = std::pair<std::size_t, std::size_t>;

  // Returns the largest extent of an edge along an axis, in side lengths of a voxel.
  double length(std::size_t a, std::size_t b) const {
    double result = 0;
    for (int axis = 0; axis < 3; ++axis)
      result = (std::max)(result, std::abs(m_places[a][axis] - m_places[b][axis]) / m_voxel[axis]);
    return result;
  }

  std::vector<Point> m_places;
  std::array<double, 3> m_voxel;             // side lengths
  std::vector<double> m_reach;               // of vertices, in side lengths of a voxel
  std::vector<Boundary_class::Bits> m_sides; // of vertices
  std::vector<Edge> m_ties; // pairs of a vertex and a neighbor that it moves towards
};

// A builder of a complex from voxels, where the labels of cells are component numbers. With these
// labels, components neither merge nor touch, and the volume of each component can be restored. The
// interface first follows the faces of the voxels, then it is smoothed, and then coarsened.
template <class Complex> class Voxel_interface_3
{
public:
  Voxel_interface_3(const Voxel_components_3& components, const Voxel_frame_3& frame, double edge)
      : m_components(components), m_frame(frame), m_edge(edge) {
    for (std::size_t c = 1; c < components.number(); ++c)
      m_volumes[int(c)] =
          double(components.number_of_voxels(c)) * frame.side(0) * frame.side(1) * frame.side(2);
  }

  Complex build() const {
    const Progress_phase phase("filling the voxels with tetrahedra");
    const Voxel_pyramid_3 pyramid(
        m_components, m_edge / (std::max)({m_frame.side(0), m_frame.side(1), m_frame.side(2)}));
    const Voxel_octree_3 octree(pyramid, m_frame.longest_side());
    Octree_tetrahedra_3 mesh(octree.tree(), [&](unsigned level, const Octree_3::Place& block) {
      return octree.component(level, block);
    });
    if (m_components.fill_domain())
      mesh.remove(0);
    Complex result;
    std::vector<typename Complex::Point> points;
    points.reserve(mesh.points.size());
    for (const auto& p : mesh.points)
      points.emplace_back(m_frame.coordinate(octree, 0, p[0]), m_frame.coordinate(octree, 1, p[1]),
                          m_frame.coordinate(octree, 2, p[2]));
    result.assign(points, mesh.tetrahedra, mesh.labels);
    const auto& t = m_frame.translation;
    result.set_normalization({{t[0], t[1], t[2]}, m_frame.scale});
    result.measure_interface_edges();
    return result;
  }

  // Smooths the interface. Volumes are corrected in each round, because small components would
  // vanish otherwise.
  void smooth(Complex& dsc) const {
    const Progress_phase phase("smoothing the interface between voxels");
    static constexpr int rounds = 16;
    // one measurement and one correction; the last round has more iterations
    static constexpr int iterations = 2;
    const Interface_snapshot<Complex> interface_(dsc);
    const auto places = interface_.positions(dsc);
    auto positions = places;
    const Stairs_smoother_3<Complex> smoother(interface_, places,
                                              {m_frame.side(0), m_frame.side(1), m_frame.side(2)});
    const Volume_changer<Complex> changer(interface_);
    for (int round = 0; round < rounds; ++round) {
      smoother.relax(positions);
      std::map<int, double> missing;
      const auto changes = changer.changes(places, positions);
      for (const auto& [component, volume] : m_volumes) {
        const auto change = changes.find(component); // none without an interface
        missing[component] =
            volume - dsc.measure(component) - (change == changes.end() ? 0 : change->second);
      }
      changer.change_by(missing, positions,
                        round + 1 < rounds ? iterations : changer.most_iterations);
    }
    deform_interface_to(dsc, interface_, positions, deformation_options());
  }

  // Coarsens the interface to the target edge length. The change of the volume of a component is
  // bounded by a fraction of a voxel.
  void coarsen(Complex& dsc) const {
    const Progress_phase phase("coarsening the interface between voxels");
    static constexpr unsigned rounds = 2;
    static constexpr double short_edges = .7, long_edges = 1.5;
    const double voxel = m_frame.side(0) * m_frame.side(1) * m_frame.side(2);
    static constexpr double swept = .2; // in volumes of a voxel
    Interface_improvement_options<Complex> options;
    options.sizing_field = [edge = m_edge](const auto&) { return edge; };
    options.interface_collapse_length = short_edges;
    options.interface_split_length = long_edges;
    options.swept_volume = swept * voxel / std::pow(m_edge, 3);
    options.number_of_iterations = rounds;
    improve_interface(dsc, options);
    control_detail(dsc, Detail_options<Complex>());
  }

  void restore(Complex& dsc) const {
    const Progress_phase phase("restoring the volumes of components");
    Volume_restoration_options<Complex> options;
    options.deformation = deformation_options();
    options.number_of_iterations = 10;
    restore_volumes(dsc, m_volumes, options);
    check(dsc);
  }

private:
  static Deformation_options<Complex> deformation_options() {
    Deformation_options<Complex> result;
    result.forbid_topology_changes();
    return result;
  }

  // Throws `Error` unless each component has the volume of its voxels, up to a tolerance.
  void check(const Complex& dsc) const {
    static constexpr double tolerance = 1e-3; // relative, as documented
    std::set<int> labels;
    std::size_t number = 0;
    for (const auto& [component, volume] : m_volumes)
      if (!(std::abs(dsc.measure(component) - volume) <= tolerance * volume)) {
        labels.insert(m_components.label(std::size_t(component)));
        ++number;
      }
    if (number == 0)
      return;
    std::string names;
    for (const int label : labels)
      names += (names.empty() ? "" : ", ") + std::to_string(label);
    const double scale = m_frame.scale,
                 side = (std::min)({m_frame.side(0), m_frame.side(1), m_frame.side(2)});
    throw Error(std::to_string(number) + " components of the labels " + names +
                " are too small to keep their volumes with edges of length " +
                std::to_string(scale * m_edge) + ": use edges of at most " +
                std::to_string(scale * side));
  }

  const Voxel_components_3& m_components;
  const Voxel_frame_3& m_frame;
  double m_edge;
  std::map<int, double> m_volumes; // target volumes, by component
};

// Replaces the component numbers of cells by the labels of the components.
template <class Complex>
void label_by_components(Complex& dsc, const Voxel_components_3& components) {
  auto state = dsc.state();
  for (auto& label : state.cell_labels)
    label = components.label(std::size_t(label));
  dsc.restore(state);
}

} // namespace internal

/*!
\ingroup PkgComplexConstructionRef

Makes a complex from a labeled image, such as a segmented scan. The values of voxels are the labels.
A voxel is the box centered at its image point; its sides are the spacings of the image. The voxels
fill the domain: 0 is a label like others, and the interface ends on the sides of the image, along
which it can move. In a larger box, the space around the image has label 0.

Each connected component of a label, connected through common faces of voxels, becomes a component
of the complex with the volume of its voxels. Components whose voxels share only edges or vertices
remain different components, which have these edges or vertices in common. The interface is smooth.
Its distance from the faces of voxels is at most of the order of `edge`.

n log n in the number of voxels at the interface, linear in the number of the others. Memory: up to
6 kB for each voxel of noise, less than 70 bytes for each voxel of large smooth objects.

\tparam Complex an instance of `Deformable_simplicial_complex_3`
\tparam NP a sequence of named parameters

\param image image of integers whose absolute values are less than 2^31
\param edge approximate length of interface edges, in the unit of the image, positive; or 0 for 2.5
       times the longest side of a voxel. Edges are shorter where components are small.
\param np a `Construction_options<3>`, or the named parameters of
       `make_deformable_simplicial_complex_3()` from surfaces, except `box_subdivision`. By default,
`enclosing_box` is the box of all voxels. Another box must contain all voxels with labels other than
0 in its interior.

\throws Error if the image has no voxels, has several values for a voxel or holds a value that is
        not a label; if the sides of voxels are not positive and finite; if more than 2^20 voxels
        are in a row; if the voxels do not fill the box, and voxels with labels other than 0 reach
        its boundary or do not exist; if `edge` is negative or not finite; or if `edge` is so long
        that the volume of a component differs from that of its voxels by more than a thousandth
\throws Interrupted_error if the callback of a `Progress_scope` returns `false`
*/
template <class Complex, class NP = parameters::Default_named_parameters>
Complex make_complex_from_labeled_image_3(const Image_3& image, double edge,
                                          const NP& np = parameters::default_values()) {
  static constexpr double voxels_of_edge = 2.5; // shorter edges would follow steps
  if (!(edge >= 0) || !std::isfinite(edge))
    throw Error(
        "the edge length is negative or not finite: use a positive length, or 0 for the default");
  internal::refuse_parameters<Construction_options<3>, internal_np::box_subdivision_t>(np);
  const auto options = construction_options<3>(np);
  const auto& domain = options.enclosing_box;
  const internal::Labeled_voxels_3 voxels =
      internal::labeled_voxels(image, !domain || internal::is_box_of_voxels(image, *domain));
  const internal::Voxel_components_3 components(voxels);
  const internal::Voxel_frame_3 frame(voxels, options.normalize, domain);
  const internal::Voxel_interface_3<Complex> interface_(
      components, frame,
      (edge > 0 ? edge : voxels_of_edge * voxels.largest_spacing()) / frame.scale);
  Complex dsc = interface_.build();
  interface_.smooth(dsc);
  interface_.coarsen(dsc);
  interface_.restore(dsc);
  internal::label_by_components(dsc, components);
  internal::improve_new_mesh(dsc, options);
  dsc.measure_interface_edges();
  dsc.take_component_events();
  return dsc;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_COMPLEX_CONSTRUCTION_CONVERT_LABELED_IMAGE_3_H
