// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_H

#include <CGAL/Deformable_simplicial_complexes/Labeled_complex.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/internal/arguments/complex_arguments.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/Space_3.h>
#include <CGAL/Deformable_simplicial_complexes/quality_measures.h>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

A tetrahedralized domain; each cell carries a label. The *interface* is the set of facets between
cells of different labels; it may be non-manifold, and any number of labels may meet. The domain is
a ball or a flat torus. In most cases, the ball is a box whose sides are known to the complex.

Everything that holds in any dimension is inherited from `Labeled_complex`. `Point_3` and
`Vector_3` are other names of its types `Point` and `Vector`.

\tparam Traits_ model of `DeformableSimplicialComplexTraits_3`
\tparam Tds_ a `Triangulation_data_structure_3` with `Deformable_simplicial_complex_vertex_base_3` and
        `Deformable_simplicial_complex_cell_base_3`, over any bases
\tparam QualityMeasure_ model of `TetrahedronQualityMeasure_3`; the quality cached in cells
\tparam Domain_ `Ball_domain`, `Torus_domain<3>` or, for a complex at rest, `Solid_domain`
*/
template <class Traits_ = Exact_predicates_inexact_constructions_kernel, class Tds_ = Default,
          class QualityMeasure_ = Deformable_simplicial_complexes::Volume_length_ratio_3,
          class Domain_ = Deformable_simplicial_complexes::Ball_domain>
class Deformable_simplicial_complex_3
    : public Deformable_simplicial_complexes::Labeled_complex<
          Deformable_simplicial_complex_3<Traits_, Tds_, QualityMeasure_, Domain_>,
          Deformable_simplicial_complexes::internal::Space_of_3<Traits_, Tds_>, QualityMeasure_,
          Deformable_simplicial_complexes::internal::Domain_of<Domain_>>
{
  using Base = Deformable_simplicial_complexes::Labeled_complex<
      Deformable_simplicial_complex_3,
      Deformable_simplicial_complexes::internal::Space_of_3<Traits_, Tds_>, QualityMeasure_,
      Deformable_simplicial_complexes::internal::Domain_of<Domain_>>;

  static_assert(
      std::is_invocable_r_v<double, const QualityMeasure_&, typename Base::Point,
                            typename Base::Point, typename Base::Point, typename Base::Point>,
      "TetrahedronQualityMeasure_3: double operator()(Point_3 p, Point_3 q, Point_3 r, "
      "Point_3 s) const");

public:
  using Base::interface_facets;
  using Base::is_interface;
  using Base::measure;
  using typename Base::Facet;
  using typename Base::Geom_traits;
  using typename Base::Label;
  using typename Base::Quality_measure;
  using typename Base::Vertex_handle;

  /// Position of a vertex.
  using Point_3 = typename Base::Point;
  /// Difference of two positions.
  using Vector_3 = typename Base::Vector;
  /// Cell and the indices of the two vertices of the edge.
  using Edge = typename Base::Triangulation::Edge;

  /// Constructs an empty complex.
  explicit Deformable_simplicial_complex_3(
      const Geom_traits& traits = Geom_traits(), const Quality_measure& quality = Quality_measure(),
      const typename Base::Domain& domain = typename Base::Domain())
      : Base(traits, quality, domain) {}
  /// Constructs an empty complex in a domain.
  explicit Deformable_simplicial_complex_3(const typename Base::Domain& domain)
      : Deformable_simplicial_complex_3(Geom_traits(), Quality_measure(), domain) {}

  /// Returns whether a facet of the interface contains the edge. Linear in the number of cells
  /// around the edge.
  bool is_interface(const Edge& e) const;

  /// Returns the volume of the label. Constant time.
  double volume(Label label) const { return measure(label); }
  /// Returns the area of the facet. \pre f is finite
  double area(const Facet& f) const { return measure(f); }
  /// Returns the area of the label's interface, without the boundary of the domain.
  double area(Label label) const;
  /// Returns the area of the interface between the labels a and b.
  double area(Label a, Label b) const;
  /// Returns V - E + F of the label's interface; 2 for the boundary of a ball.
  int euler_characteristic(Label label) const;

  /// Measures of the interface of a label.
  struct Label_interface
  {
    Label label;              ///< one of `labels()`
    double area;              ///< `area(label)`, bitwise equal
    int euler_characteristic; ///< `euler_characteristic(label)`
  };
  /// Returns the measures of all labels, by increasing label. n log n in the size of the interface.
  std::vector<Label_interface> label_interfaces() const;
};

template <class Tr, class Tds, class Qm, class D>
bool Deformable_simplicial_complex_3<Tr, Tds, Qm, D>::is_interface(const Edge& e) const {
  auto facet = this->triangulation().tds().incident_facets(e), last = facet;
  do {
    if (is_interface(Facet(*facet)))
      return true;
  } while (++facet != last);
  return false;
}

template <class Tr, class Tds, class Qm, class D>
double Deformable_simplicial_complex_3<Tr, Tds, Qm, D>::area(Label label) const {
  double result = 0;
  for (const Facet& f : interface_facets())
    if (f.first->subdomain_index() == label ||
        f.first->neighbor(f.second)->subdomain_index() == label)
      result += area(f);
  return result;
}

template <class Tr, class Tds, class Qm, class D>
double Deformable_simplicial_complex_3<Tr, Tds, Qm, D>::area(Label a, Label b) const {
  double result = 0;
  for (const Facet& f : interface_facets(a, b))
    result += area(f);
  return result;
}

template <class Tr, class Tds, class Qm, class D>
int Deformable_simplicial_complex_3<Tr, Tds, Qm, D>::euler_characteristic(Label label) const {
  std::vector<std::size_t> vertices;
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  int facets = 0;
  for (const Facet& f : interface_facets()) {
    if (f.first->subdomain_index() != label &&
        f.first->neighbor(f.second)->subdomain_index() != label)
      continue;
    ++facets;
    const auto v = this->facet_vertices(f);
    for (int i = 0; i < 3; ++i) {
      const std::size_t a = v[i]->time_stamp(), b = v[(i + 1) % 3]->time_stamp();
      vertices.push_back(a);
      edges.push_back(std::minmax(a, b));
    }
  }
  const auto count_distinct = [](auto& items) {
    std::sort(items.begin(), items.end());
    return int(std::unique(items.begin(), items.end()) - items.begin());
  };
  return count_distinct(vertices) - count_distinct(edges) + facets;
}

template <class Tr, class Tds, class Qm, class D>
auto Deformable_simplicial_complex_3<Tr, Tds, Qm, D>::label_interfaces() const
    -> std::vector<Label_interface> {
  std::vector<Label_interface> result;
  for (Label label : this->labels())
    result.push_back({label, 0, 0});
  const auto of = [&](Label label) -> Label_interface& {
    return *std::lower_bound(
        result.begin(), result.end(), label,
        [](const Label_interface& measures, Label bound) { return measures.label < bound; });
  };

  // Edge of a facet; a vertex is stored as the edge from it to itself.
  struct Part
  {
    std::pair<std::size_t, std::size_t> ends;
    std::array<Label, 2> labels;
  };
  std::vector<Part> parts;
  for (const Facet& f : interface_facets()) {
    const std::array<Label, 2> labels = {f.first->subdomain_index(),
                                         f.first->neighbor(f.second)->subdomain_index()};
    const double facet_area = area(f);
    for (Label label : labels) {
      of(label).area += facet_area;
      ++of(label).euler_characteristic;
    }
    const auto v = this->facet_vertices(f);
    for (int i = 0; i < 3; ++i) {
      const std::size_t a = v[i]->time_stamp(), b = v[(i + 1) % 3]->time_stamp();
      parts.push_back({{a, a}, labels});
      parts.push_back({std::minmax(a, b), labels});
    }
  }
  std::sort(parts.begin(), parts.end(),
            [](const Part& a, const Part& b) { return a.ends < b.ends; });
  std::vector<Label> labels_around;
  for (auto part = parts.begin(); part != parts.end();) {
    const auto ends = part->ends;
    labels_around.clear();
    for (; part != parts.end() && part->ends == ends; ++part)
      labels_around.insert(labels_around.end(), part->labels.begin(), part->labels.end());
    std::sort(labels_around.begin(), labels_around.end());
    labels_around.erase(std::unique(labels_around.begin(), labels_around.end()),
                        labels_around.end());
    for (Label label : labels_around)
      of(label).euler_characteristic += ends.first == ends.second ? 1 : -1;
  }
  return result;
}

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_H
