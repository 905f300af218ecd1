// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Distributed_complexes, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_MOTION_DISTRIBUTED_EXTENSION_H
#define CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_MOTION_DISTRIBUTED_EXTENSION_H

#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Deformable_simplicial_complexes/Linear_element.h>
#include <CGAL/Distributed_complexes/internal/ranks/Distributed_mesh.h>
#include <CGAL/Distributed_complexes/internal/ranks/Exact_sums.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

/*
The harmonic extension of displacements on a distributed complex: the system of
`Harmonic_extension`, solved by conjugate gradients. Ghosts are updated in each iteration, and
scalar products do not depend on the distribution. So all ranks compute the same displacements, for
any number of ranks.
*/
template <class Complex> class Distributed_extension
{
public:
  static constexpr int d = Complex::dimension;
  using Mesh = Distributed_mesh<Complex>;
  using Index = typename Mesh::Index;
  using Vector = std::array<double, d>;

  // `is_free[v]` marks the vertices to which displacements are extended.
  Distributed_extension(const Mesh& mesh, const std::vector<std::uint8_t>& is_free)
      : m_mesh(mesh), m_sums(*mesh.communicator), m_first_entry(1, 0) {
    for (Index v = 0; v < mesh.piece.vertex_bound(); ++v)
      if (mesh.is_own(v) && is_free[v])
        add_row(v);
  }

  // Replaces the displacements of free vertices. On input, displacements of other vertices are
  // known, and displacements of free vertices are 0.
  void extend(std::vector<Vector>& displacements) {
    static constexpr double part = 5e-3; // relative reduction of the residuals
    static constexpr int maximum_number_of_iterations = 200;
    const std::size_t n = m_rows.size();
    std::vector<Vector> residuals(n), inverses(n), products(n),
        directions(displacements.size(), Vector{});
    std::vector<Vector> terms(n);
    for (std::size_t r = 0; r < n; ++r) {
      // Displacements of free vertices are 0, so only known displacements contribute.
      residuals[r] = product(r, displacements);
      const auto sides = m_mesh.piece.vertex(m_rows[r]).boundary_class;
      for (int k = 0; k < d; ++k) {
        residuals[r][k] = -residuals[r][k];
        inverses[r][k] =
            m_diagonal[r] > 0 && !Boundary_class::fixes(sides, k) ? 1 / m_diagonal[r] : 0;
        directions[m_rows[r]][k] = inverses[r][k] * residuals[r][k];
        terms[r][k] = directions[m_rows[r]][k] * residuals[r][k];
      }
    }
    Vector energy = m_sums(terms);
    const Vector first = energy;
    const auto is_solved = [&] {
      for (int k = 0; k < d; ++k)
        if (energy[k] > part * part * first[k])
          return false;
      return true;
    };
    for (int i = 0; i < maximum_number_of_iterations && !is_solved(); ++i) {
      m_mesh.communicator->check_progress();
      m_mesh.ghosts.update(directions);
      for (std::size_t r = 0; r < n; ++r) {
        products[r] = product(r, directions);
        for (int k = 0; k < d; ++k)
          terms[r][k] = products[r][k] * directions[m_rows[r]][k];
      }
      const Vector step = ratio(energy, m_sums(terms));
      for (std::size_t r = 0; r < n; ++r)
        for (int k = 0; k < d; ++k) {
          displacements[m_rows[r]][k] += step[k] * directions[m_rows[r]][k];
          residuals[r][k] -= step[k] * products[r][k];
          terms[r][k] = residuals[r][k] * inverses[r][k] * residuals[r][k];
        }
      const Vector next = m_sums(terms), beta = ratio(next, energy);
      for (std::size_t r = 0; r < n; ++r)
        for (int k = 0; k < d; ++k)
          directions[m_rows[r]][k] =
              inverses[r][k] * residuals[r][k] + beta[k] * directions[m_rows[r]][k];
      energy = next;
    }
    m_mesh.ghosts.update(displacements);
  }

private:
  struct Entry
  {
    Index column;
    double value;
  };

  void add_row(Index v) {
    using Element = Linear_element<Complex>;
    m_entries_of_row.clear();
    double diagonal = 0;
    for (Index c : m_mesh.piece.star(v)) {
      const auto& vertices = m_mesh.piece.cell(c).vertices;
      typename Element::Corners corners;
      int own = 0;
      for (int i = 0; i <= d; ++i) {
        corners[i] = m_mesh.position(vertices[i]);
        if (vertices[i] == v)
          own = i;
      }
      const auto stiffness = Element(corners).evened_stiffness(own);
      for (int i = 0; i <= d; ++i)
        if (i != own)
          m_entries_of_row.push_back({vertices[i], stiffness[i]});
    }
    // Entries of equal columns are added in the order of the star.
    std::stable_sort(m_entries_of_row.begin(), m_entries_of_row.end(),
                     [&](const Entry& a, const Entry& b) {
                       return m_mesh.piece.vertex(a.column).id < m_mesh.piece.vertex(b.column).id;
                     });
    const std::size_t first = m_entries.size();
    for (const Entry& e : m_entries_of_row) {
      if (m_entries.size() > first && m_entries.back().column == e.column)
        m_entries.back().value += e.value;
      else
        m_entries.push_back(e);
    }
    for (std::size_t i = first; i < m_entries.size(); ++i)
      diagonal -= m_entries[i].value;
    m_rows.push_back(v);
    m_diagonal.push_back(diagonal);
    m_first_entry.push_back(m_entries.size());
  }

  Vector product(std::size_t row, const std::vector<Vector>& vectors) const {
    Vector result;
    for (int k = 0; k < d; ++k)
      result[k] = m_diagonal[row] * vectors[m_rows[row]][k];
    for (std::size_t i = m_first_entry[row]; i < m_first_entry[row + 1]; ++i)
      for (int k = 0; k < d; ++k)
        result[k] += m_entries[i].value * vectors[m_entries[i].column][k];
    return result;
  }

  // Returns the quotients of the components; 0 for a component that is already solved.
  static Vector ratio(const Vector& a, const Vector& b) {
    Vector result = {};
    for (int k = 0; k < d; ++k)
      if (b[k] > 0)
        result[k] = a[k] / b[k];
    return result;
  }

  const Mesh& m_mesh;
  Exact_sums<d> m_sums;
  std::vector<Index> m_rows; // free vertices of this rank
  std::vector<double> m_diagonal;
  std::vector<std::size_t> m_first_entry;
  std::vector<Entry> m_entries, m_entries_of_row;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_MOTION_DISTRIBUTED_EXTENSION_H
