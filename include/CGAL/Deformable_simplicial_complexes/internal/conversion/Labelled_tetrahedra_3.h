// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_CONVERSION_LABELLED_TETRAHEDRA_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_CONVERSION_LABELLED_TETRAHEDRA_3_H

#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The cells of a mesh complex that belong to it, with their subdomains as labels. Points are in the
// order of their first use by cells.
template <class Complex> struct Labelled_tetrahedra_3
{
  std::vector<typename Complex::Point_3> points;
  std::vector<std::array<std::size_t, 4>> tetrahedra;
  std::vector<typename Complex::Label> labels;

  template <class MeshComplex> explicit Labelled_tetrahedra_3(const MeshComplex& mesh) {
    const auto construct_point = typename Complex::Geom_traits().construct_exact_point_3_object();
    // never iterated over, so results do not depend on addresses
    std::unordered_map<const void*, std::size_t> numbers;
    for (auto c = mesh.cells_in_complex_begin(); c != mesh.cells_in_complex_end(); ++c) {
      auto& tetrahedron = tetrahedra.emplace_back();
      for (int i = 0; i < 4; ++i) {
        const auto v = c->vertex(i);
        const auto [known, is_new] = numbers.emplace(&*v, points.size());
        if (is_new) {
          const auto& p = v->point(); // a weighted point of the triangulation
          points.push_back(construct_point({to_double(p.x()), to_double(p.y()), to_double(p.z())}));
        }
        tetrahedron[i] = known->second;
      }
      labels.push_back(typename Complex::Label(mesh.subdomain_index(c)));
    }
  }
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_CONVERSION_LABELLED_TETRAHEDRA_3_H
