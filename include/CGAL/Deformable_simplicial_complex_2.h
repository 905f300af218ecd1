// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_H

#include <CGAL/Deformable_simplicial_complex_traits_2.h>
#include <CGAL/Deformable_simplicial_complexes/Ball_domain.h>
#include <CGAL/Deformable_simplicial_complexes/Labelled_complex.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/Space_2.h>
#include <CGAL/Deformable_simplicial_complexes/quality_measures_2.h>

#include <CGAL/Default.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

A triangulated domain of the plane each triangle of which carries a label. The *interface* is the
set of edges between triangles of different labels. The domain is a disk, in most cases a rectangle
whose sides are known to the complex, or a flat torus.

All that holds in any dimension is inherited from `Labelled_complex`: its cells are triangles and
its facets edges.

\tparam Traits_ model of `DeformableSimplicialComplexTraits_2`
\tparam Tds_ a `Triangulation_data_structure_2` with the vertices and faces of this package
\tparam Domain_ `Ball_domain`, or `Torus_domain<2>`
*/
template <class Traits_ = Deformable_simplicial_complex_traits_2<>, class Tds_ = Default,
          class Domain_ = Deformable_simplicial_complexes::Ball_domain>
class Deformable_simplicial_complex_2
    : public Deformable_simplicial_complexes::Labelled_complex<
          Deformable_simplicial_complex_2<Traits_, Tds_, Domain_>,
          Deformable_simplicial_complexes::internal::Space_2<Traits_, Tds_>,
          Deformable_simplicial_complexes::Area_length_ratio_2, Domain_>
{
  using Base = Deformable_simplicial_complexes::Labelled_complex<
      Deformable_simplicial_complex_2,
      Deformable_simplicial_complexes::internal::Space_2<Traits_, Tds_>,
      Deformable_simplicial_complexes::Area_length_ratio_2, Domain_>;

public:
  using typename Base::Label;

  /// A position as it is stored and as predicates see it.
  using Point_2 = typename Base::Point;
  /// A position with coordinates of type `double`, to measure with.
  using Approximate_point_2 = typename Base::Approximate_point;
  /// The difference of two such positions.
  using Approximate_vector_2 = typename Base::Approximate_vector;

  /// An empty complex.
  explicit Deformable_simplicial_complex_2(const Traits_& traits = Traits_(),
                                           const Domain_& domain = Domain_())
      : Base(traits, Deformable_simplicial_complexes::Area_length_ratio_2(), domain) {}
  /// An empty complex in a domain.
  explicit Deformable_simplicial_complex_2(const Domain_& domain)
      : Deformable_simplicial_complex_2(Traits_(), domain) {}

  double area(Label label) const {
    return this->measure(label);
  } ///< in the coordinates of the
    ///< complex; constant time
  /// Of the label's interface, without the boundary of the domain. As `label_regions()`.
  double length(Label label) const { return region(label).length; }
  /// V - E + F of the label's region, closed in the complex: components less holes, in a box; 0 for
  /// a label that is not there. As `label_regions()`.
  int euler_characteristic(Label label) const { return region(label).euler_characteristic; }

  /// Measures of the region of a label.
  struct Label_region
  {
    Label label;              ///< one of `labels()`
    double length;            ///< `length(label)`
    int euler_characteristic; ///< `euler_characteristic(label)`
  };
  /// The measures for all labels, increasing, in the time of one label: n log n in the cells.
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
        result.begin(), result.end(), c->label(),
        [](const Label_region& region, Label label) { return region.label < label; });
    ++r.euler_characteristic;
    for (int i = 0; i < 3; ++i) {
      r.euler_characteristic += vertices.emplace(r.label, c->vertex(i)->time_stamp()).second;
      const auto n = c->neighbor(i);
      const bool is_shared = !this->is_infinite(n) && n->label() == r.label;
      r.euler_characteristic -= !is_shared || c->time_stamp() < n->time_stamp();
      if (this->is_interface(typename Base::Facet(c, i)))
        r.length += this->measure(typename Base::Facet(c, i));
    }
  }
  return result;
}

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_H
