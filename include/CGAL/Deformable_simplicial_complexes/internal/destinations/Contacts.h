// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_DESTINATIONS_CONTACTS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_DESTINATIONS_CONTACTS_H

#include <CGAL/Deformable_simplicial_complexes/internal/destinations/Destinations.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Tests whether parts of the interface come together in a deformation. Only the motion decides. A
// cell can be flat because its facets are large. It is no contact if its height stays the same.
template <class Complex> class Contacts
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;

  Contacts(const Complex& complex, const Destinations<Complex>& destinations)
      : m_complex(complex), m_destinations(destinations) {}

  // Returns whether the motion closes a cell: with its vertices at their destinations, the cell is
  // inverted, or its height is a small fraction of the height before the motion and its quality is
  // below a threshold.
  bool closes(Cell_handle c, double threshold) const {
    const double after = height(final_frame(c));
    if (!(after > 0))
      return true;
    return after < closed * height(frame(c, at_begin())) &&
           m_complex.quality(c, at_end()) < threshold;
  }

  // Returns whether the motion makes a component vanish: with the vertices at their destinations,
  // the volume of its cells is a small fraction of their volume before the motion.
  bool vanishes(const std::vector<Cell_handle>& component) const {
    double before = 0, after = 0;
    for (Cell_handle c : component) {
      before += frame(c, at_begin()).parallelotope;
      after += final_frame(c).parallelotope;
    }
    return !(after > 0) || after < closed * before;
  }

  // Returns whether a component is thin relative to the displacements of its vertices. The size of
  // its cells does not count, so a component of few large cells is not thin.
  bool is_thin(const std::vector<Cell_handle>& component) const {
    static constexpr double thin = 2; // thickness, in displacements
    double volume = 0, area = 0, displacement = 0;
    for (Cell_handle c : component) {
      volume += m_complex.measure(c);
      for (int i = 0; i < Complex::corners; ++i) {
        if (const std::pair<Cell_handle, int> facet(c, i); m_complex.is_interface(facet))
          area += m_complex.measure(facet);
        const Vertex_handle v = c->vertex(i);
        displacement =
            (std::max)(displacement, Complex::Space::length(m_complex.domain().nearest_image(
                                                                m_destinations.position_before(v),
                                                                m_destinations.final_position(v)) -
                                                            m_destinations.position_before(v)));
      }
    }
    return 2 * volume <= thin * displacement * area;
  }

  // Returns the signed volume of a cell with its vertices at their destinations.
  double final_volume(Cell_handle c) const { return final_frame(c).parallelotope / factorial; }

  // Returns the signed volume of a cell with its vertices where they were before the motion.
  double initial_volume(Cell_handle c) const {
    return frame(c, at_begin()).parallelotope / factorial;
  }

private:
  using Frame = typename Complex::Space::Frame;

  static constexpr double factorial = Complex::dimension == 3 ? 6 : 2; // d!

  // fraction of a height or of a volume that counts as zero
  static constexpr double closed = .25;

  // Functions that return the positions of vertices before and after the motion.
  auto at_begin() const {
    return [this](Vertex_handle v) { return m_destinations.position_before(v); };
  }
  auto at_end() const {
    return [this](Vertex_handle v) { return m_destinations.final_position(v); };
  }

  Frame final_frame(Cell_handle c) const { return frame(c, at_end()); }

  template <class Position_of> Frame frame(Cell_handle c, const Position_of& position) const {
    const auto frame_of = [](const auto&... corners) {
      return Complex::Space::frame({corners...});
    };
    return m_complex.domain().template apply<Complex>(
        frame_of, [&](int i) { return position(c->vertex(i)); });
  }

  // Returns the signed distance between the largest facet of a cell and the opposite vertex.
  static double height(const Frame& frame) {
    double largest = 0;
    for (const auto& normal : frame.normals)
      largest = (std::max)(largest, Complex::Space::length(normal));
    return largest > 0 ? frame.parallelotope / largest : 0;
  }

  const Complex& m_complex;
  const Destinations<Complex>& m_destinations;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_DESTINATIONS_CONTACTS_H
