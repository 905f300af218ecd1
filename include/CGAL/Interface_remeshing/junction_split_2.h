// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_JUNCTION_SPLIT_2_H
#define CGAL_INTERFACE_REMESHING_JUNCTION_SPLIT_2_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

/*
Sectors around a vertex: maximal runs of triangles of one label, counterclockwise. In the split, one
sector is connected with a new vertex, and its two neighbors become adjacent along the edge between
the two vertices. The polygon around the vertex stays. Its sides in the two neighboring sectors are
divided between the two vertices so that the worst quality is best. At a side of a box, the outside
is a sector, too. It is not connected with a new vertex. If it is a neighbor, the new vertex is on
the side.
*/
template <class Complex> class Junction_sectors
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Vector = typename Complex::Vector;
  using Index = typename Cavity<Complex>::Index;

  // Collects the sectors around v. \pre v is inside the domain or on one side of a box
  Junction_sectors(const Complex& complex, Vertex_handle v, const Interface_energy& energy)
      : m_complex(complex), m_energy(energy), m_center(v) {
    const Cell_handle first = v->cell();
    Cell_handle c = first;
    do {
      const int i = c->index(v);
      m_sides.add(c, i);
      c = c->neighbor((i + 1) % 3);
    } while (c != first);
    const std::size_t n = m_sides.size();
    for (std::size_t k = 0; k < n; ++k)
      if (phase(k) != phase((k + n - 1) % n))
        m_begins.push_back(k);
  }

  std::size_t number() const { return m_begins.size(); }

  // Returns the sectors with a pull away from the center that is stronger than the tension of the
  // wall that the pull would create between the two neighbors, the strongest one first. The two
  // neighbors of a sector have different labels.
  std::vector<std::size_t> pulled() const {
    std::vector<std::pair<double, std::size_t>> sectors;
    for (std::size_t s = 0; s < number(); ++s)
      if (sector_phase(s) && before(s) != after(s))
        if (const double excess = length(pull(s)) - tension(before(s), after(s)); excess > 0)
          sectors.emplace_back(-excess, s);
    std::sort(sectors.begin(), sectors.end());
    std::vector<std::size_t> result;
    for (const auto& [excess, s] : sectors)
      result.push_back(s);
    return result;
  }

  // Plans to connect a sector with a new vertex. The distance of the new vertex from the center is
  // a fraction of the shorter edge of the sector. Returns whether the energy decreases,
  // and all triangles are positively oriented and keep their quality.
  bool plan(std::size_t s, double part, Cavity<Complex>& cavity) const {
    const Vector pull = this->pull(s), left = to_corner(begin(s + 1)), right = to_corner(begin(s));
    const double shorter = (std::min)(length(left), length(right));
    const Vector displacement = pull * (part * shorter / length(pull));
    const Phase own = sector_phase(s);
    if (!(tension(before(s), after(s)) * length(displacement) +
              tension(own, after(s)) * (length(left - displacement) - length(left)) +
              tension(before(s), own) * (length(right - displacement) - length(right)) <
          0))
      return false;
    cavity.begin(Proposal_kind::insertion);
    for (const auto& side : m_sides)
      cavity.remove(side.cell);
    const Index old_one = cavity.add(m_center),
                new_one =
                    cavity.add(m_complex.position(m_center) + displacement,
                               is_at_side(s) ? m_center->boundary_class() : Boundary_class::inside);
    m_sides.divide(cavity, begin(s + number() - 1), begin(s + number()), old_one, new_one);
    m_sides.connect(cavity, begin(s), begin(s + 1), new_one);
    m_sides.divide(cavity, begin(s + 1), begin(s + 2), new_one, old_one);
    m_sides.connect(cavity, begin(s + 2), begin(s + number() - 1), old_one);
    return cavity.is_admissible();
  }

private:
  using Phase = std::optional<typename Complex::Label>; // empty for the outside of the domain

  static double length(const Vector& v) { return std::sqrt(v.squared_length()); }
  Phase phase(std::size_t k) const {
    const Cell_handle c = m_sides[k].cell;
    return m_complex.is_infinite(c) ? Phase() : Phase(c->subdomain_index());
  }
  double tension(const Phase& p, const Phase& q) const {
    return p && q ? m_energy.tension(*p, *q) : 0;
  }

  // Sectors are numbered cyclically, like sides: any number is valid.
  std::size_t begin(std::size_t s) const {
    return m_begins[s % number()] + s / number() * m_sides.size();
  }
  Phase sector_phase(std::size_t s) const { return phase(begin(s) % m_sides.size()); }
  Phase before(std::size_t s) const { return sector_phase(s + number() - 1); }
  Phase after(std::size_t s) const { return sector_phase(s + 1); }
  bool is_at_side(std::size_t s) const { return !before(s) || !after(s); }
  Vector to_corner(std::size_t k) const {
    return m_complex.displacement(m_center, m_sides[k].from);
  }

  // Returns the force of the two interface edges that bound a sector, along the side if the sector
  // is at a side.
  Vector pull(std::size_t s) const {
    const Vector right = to_corner(begin(s)), left = to_corner(begin(s + 1));
    const Phase own = sector_phase(s);
    const Vector result = right * (tension(before(s), own) / length(right)) +
                          left * (tension(own, after(s)) / length(left));
    if (!is_at_side(s))
      return result;
    const Vector along = !before(s) ? right : left;
    return along * ((result * along) / along.squared_length());
  }

  const Complex& m_complex;
  const Interface_energy& m_energy;
  Vertex_handle m_center;
  Polygon_sides<Complex> m_sides;
  std::vector<std::size_t> m_begins; // first side of each sector
};

} // namespace internal

/*!
\ingroup PkgInterfaceRemeshingRef

Proposes to split a vertex where the phases of more than three sectors meet. One sector is connected
with a new vertex, and its two neighbors get a wall between the two vertices. If all walls have the
same tension, such a vertex is unstable: the walls of one of the sectors enclose less than 120
degrees and pull the sector away. A vertex on a side of a box is split if more than one wall ends
there: a sector leaves the side, or two walls part along the side. Linear in the star of v, but
quadratic in the size of the two sectors that become neighbors.

\param complex the complex; it is not changed
\param v a finite vertex
\param cavity filled with the proposal if there is one; its last vertex is the new one
\param energy the energy of the interface; energy densities have no effect. The default is the
       length.
\return whether the proposal is valid: v is not at a corner of the domain, more than three sectors
        meet at v, where the outside counts as one, and the new neighbors have different labels. The
        split decreases the energy, all new triangles are positively oriented, and
        `complex.keeps_quality()` holds.
\throws Error if a tension is out of its range
*/
template <class Complex>
bool propose_junction_split(const Complex& complex, typename Complex::Vertex_handle v,
                            Deformable_simplicial_complexes::Cavity<Complex>& cavity,
                            const Interface_energy& energy = {}) {
  static constexpr std::size_t stable = 3, at_side = 2; // numbers of sectors and walls
  const auto sides = v->boundary_class();
  if ((sides & Boundary_class::fixed) != 0 || Boundary_class::fixes_all(sides, 2) ||
      (sides == Boundary_class::inside ? v->interface_degree() <= stable
                                       : v->interface_degree() < at_side))
    return false;
  const internal::Junction_sectors<Complex> sectors(complex, v, energy);
  for (const std::size_t s : sectors.pulled())
    for (const double part : {.5, .25, .125}) // fractions of an edge, as short as exchanged walls
      if (sectors.plan(s, part, cavity))
        return true;
  return false;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_JUNCTION_SPLIT_2_H
