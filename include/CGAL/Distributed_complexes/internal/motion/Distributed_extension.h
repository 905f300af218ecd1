// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_MOTION_DISTRIBUTED_EXTENSION_H
#define CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_MOTION_DISTRIBUTED_EXTENSION_H

#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Linear_element.h>
#include <CGAL/Distributed_complexes/internal/ranks/Distributed_mesh.h>
#include <CGAL/Distributed_complexes/internal/ranks/Exact_sums.h>
#include <CGAL/Mesh_support/internal/numbers/Conjugate_gradients.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

/*
The harmonic extension of displacements on a distributed complex: the system of
`Harmonic_extension`, solved by conjugate gradients. Ghosts are updated in each iteration, and
scalar products do not depend on the distribution. So all ranks compute the same displacements, for
any number of ranks.
*/
template <class Complex>
class Distributed_extension : public Diagonal_preconditioner<Complex::dimension>
{
public:
  static constexpr int d = Complex::dimension;
  using Mesh = Distributed_mesh<Complex>;
  using Index = typename Mesh::Index;
  using Vector = Eigen::Matrix<double, d, 1>;
  using Vectors = std::vector<Vector>; // one for each vertex here

  // `is_free[v]` marks the vertices to which displacements are extended.
  Distributed_extension(const Mesh& mesh, const std::vector<std::uint8_t>& is_free)
      : Diagonal_preconditioner<d>(mesh.piece.vertex_bound()), m_mesh(mesh), m_first_entry(1, 0) {
    for (Index v : mesh.own_vertices())
      if (is_free[v])
        add_row(v);
  }

  // Replaces the displacements of free vertices. On input, displacements of other vertices are
  // known, and displacements of free vertices are 0.
  void extend(std::vector<std::array<double, d>>& displacements) const {
    static constexpr double part = 5e-3; // relative reduction of the residuals
    static constexpr int maximum_number_of_iterations = 200;
    Vectors known, residuals(displacements.size(), Vector::Zero());
    for (const auto& x : displacements)
      known.push_back(Vector(x.data()));
    // Displacements of free vertices are 0, so only known displacements contribute.
    for (std::size_t r = 0; r < m_rows.size(); ++r)
      residuals[m_rows[r]] = -row_product(r, known);
    const Vectors solution =
        reduce_residuals(*this, std::move(residuals), part, maximum_number_of_iterations);
    for (Index v : m_rows)
      std::copy_n(solution[v].data(), d, displacements[v].begin());
    m_mesh.ghosts.update(displacements);
  }

  // The rows for `conjugate_gradients()`, by vertex.

  Vector apply(Vectors& directions, Vectors& products) const {
    m_mesh.communicator->check_progress();
    m_mesh.ghosts.update(directions);
    for (std::size_t r = 0; r < m_rows.size(); ++r)
      products[m_rows[r]] = row_product(r, directions);
    return sum([&](std::size_t v) { return this->product(products[v], directions[v]); });
  }

  template <class Function> void for_each_row(const Function& f) const {
    for (Index v : m_rows)
      f(v);
  }

  template <class Function> Vector sum(const Function& f) const {
    std::vector<std::array<double, d>> terms;
    for_each_row([&](std::size_t v) {
      const Vector term = f(v);
      std::copy_n(term.data(), d, terms.emplace_back().begin());
    });
    return Vector(Exact_sums<d>(*m_mesh.communicator)(terms).data());
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
      const auto stiffness = Element(corners).evened_stiffness();
      for (int i = 0; i <= d; ++i)
        if (i != own)
          m_entries_of_row.push_back({vertices[i], stiffness[Element::edge(own, i)]});
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
    const auto sides = m_mesh.piece.vertex(v).boundary_class;
    this->set_diagonal(v, diagonal, [&](int k) { return Boundary_class::fixes(sides, k); });
    m_rows.push_back(v);
    m_diagonal.push_back(diagonal);
    m_first_entry.push_back(m_entries.size());
  }

  // Returns the product of a row with vectors.
  Vector row_product(std::size_t row, const Vectors& vectors) const {
    Vector result = m_diagonal[row] * vectors[m_rows[row]];
    for (std::size_t i = m_first_entry[row]; i < m_first_entry[row + 1]; ++i)
      result += m_entries[i].value * vectors[m_entries[i].column];
    return result;
  }

  const Mesh& m_mesh;
  std::vector<Index> m_rows; // free vertices of this rank
  std::vector<double> m_diagonal;
  std::vector<std::size_t> m_first_entry;
  std::vector<Entry> m_entries, m_entries_of_row;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_MOTION_DISTRIBUTED_EXTENSION_H
