// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_H

#include <CGAL/Deformable_simplicial_complexes/Labeled_complex.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/internal/arguments/complex_arguments.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/Space_2.h>
#include <CGAL/Deformable_simplicial_complexes/quality_measures.h>

#include <set>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

A triangulated domain of the plane; each triangle carries a label. The *interface* is the set of
edges between triangles of different labels. The domain is a disk or a flat torus. In most cases,
the disk is a rectangle whose sides are known to the complex.

Everything that holds in any dimension is inherited from `Labeled_complex`. The cells are
triangles, and the facets are edges.

\tparam Traits_ a model of `DeformableSimplicialComplexTraits_2`
\tparam Tds_ a `Triangulation_data_structure_2` with the vertices and faces of this package
\tparam Domain_ `Ball_domain`, or `Torus_domain<2>`
*/
template <class Traits_ = Exact_predicates_inexact_constructions_kernel, class Tds_ = Default,
          class Domain_ = Deformable_simplicial_complexes::Ball_domain>
class Deformable_simplicial_complex_2
    : public Deformable_simplicial_complexes::Labeled_complex<
          Deformable_simplicial_complex_2<Traits_, Tds_, Domain_>,
          Deformable_simplicial_complexes::internal::Space_of_2<Traits_, Tds_>,
          Deformable_simplicial_complexes::Area_length_ratio_2,
          Deformable_simplicial_complexes::internal::Domain_of<Domain_>>
{
  using Base = Deformable_simplicial_complexes::Labeled_complex<
      Deformable_simplicial_complex_2,
      Deformable_simplicial_complexes::internal::Space_of_2<Traits_, Tds_>,
      Deformable_simplicial_complexes::Area_length_ratio_2,
      Deformable_simplicial_complexes::internal::Domain_of<Domain_>>;

public:
  using typename Base::Label;

  /// Position of a vertex.
  using Point_2 = typename Base::Point;
  /// Difference of two positions.
  using Vector_2 = typename Base::Vector;

  /// Constructs an empty complex.
  explicit Deformable_simplicial_complex_2(
      const typename Base::Geom_traits& traits = typename Base::Geom_traits(),
      const typename Base::Domain& domain = typename Base::Domain())
      : Base(traits, Deformable_simplicial_complexes::Area_length_ratio_2(), domain) {}
  /// Constructs an empty complex in a domain.
  explicit Deformable_simplicial_complex_2(const typename Base::Domain& domain)
      : Deformable_simplicial_complex_2(typename Base::Geom_traits(), domain) {}

  /// Returns the area of the label, in the coordinates of the complex. Constant time.
  double area(Label label) const { return this->measure(label); }
  /// Returns the length of the label's interface, without the boundary of the domain. n log n in
  /// the number of cells.
  double length(Label label) const { return region(label).length; }
  /// Returns V - E + F of the closed region of the label. In a box, it is the number of connected
  /// components minus the number of holes. It is 0 for a label without cells. n log n in the number
  /// of cells.
  int euler_characteristic(Label label) const { return region(label).euler_characteristic; }

  /// Measures of the region of a label.
  struct Label_region
  {
    Label label;              ///< one of `labels()`
    double length;            ///< `length(label)`
    int euler_characteristic; ///< `euler_characteristic(label)`
  };
  /// Returns the measures of all labels, by increasing label. n log n in the number of cells.
  std::vector<Label_region> label_regions() const;

private:
  Label_region region(Label label) const {
    for (const Label_region& r : label_regions())
      if (r.label == label)
        return r;
    return {label, 0, 0};
  }
};

template <class Tr, class Tds, class D>
auto Deformable_simplicial_complex_2<Tr, Tds, D>::label_regions() const
    -> std::vector<Label_region> {
  std::vector<Label_region> result;
  for (Label label : this->labels())
    result.push_back({label, 0, 0});
  std::set<std::pair<Label, std::size_t>> vertices;
  for (auto c : this->finite_cells()) {
    Label_region& r = *std::lower_bound(
        result.begin(), result.end(), c->subdomain_index(),
        [](const Label_region& region, Label label) { return region.label < label; });
    ++r.euler_characteristic;
    for (int i = 0; i < 3; ++i) {
      r.euler_characteristic += vertices.emplace(r.label, c->vertex(i)->time_stamp()).second;
      const auto n = c->neighbor(i);
      const bool is_shared = !this->is_infinite(n) && n->subdomain_index() == r.label;
      r.euler_characteristic -= !is_shared || c->time_stamp() < n->time_stamp();
      if (this->is_interface(typename Base::Facet(c, i)))
        r.length += this->measure(typename Base::Facet(c, i));
    }
  }
  return result;
}

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_H
