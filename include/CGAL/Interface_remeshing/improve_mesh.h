// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_IMPROVE_MESH_H
#define CGAL_INTERFACE_REMESHING_IMPROVE_MESH_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_options.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Mesh_improver.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>
#include <CGAL/Interface_remeshing/Mesh_improvement_options.h>
#include <CGAL/Interface_remeshing/internal/patches/Patch_optimizer_3.h>
#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/named_parameters.h>

#include <deque>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// Improves cells that no single operation improves further: the patch around a cell is replaced
// where a better patch is found.
template <class Complex> class Patch_improver_3
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;

  // `rounds` is the maximum number of rounds in each improvement of a copy.
  Patch_improver_3(Complex& complex, Deformation_visitor<Complex>& visitor, double threshold,
                   unsigned rounds, const For_each_index& for_each_index)
      : m_complex(complex), m_visitor(visitor),
        m_for_each_index(for_each_index), m_goal{threshold, 1, 2, (std::min)(rounds, 5u), 0},
        m_cavity(complex) {
    static constexpr unsigned places_of_thread = 4; // patches differ in cost
    const unsigned threads = for_each_index.number_of_threads();
    for (unsigned i = 0; i < (threads == 1 ? 1 : places_of_thread * threads); ++i)
      m_optimizers.emplace_back(complex);
  }

  const Improvement_report& report() const { return m_report; }

  // Improves the patches around all cells below the threshold, worst cells first, in several
  // passes. Larger and smaller patches alternate. The first passes minimize the total deficit to
  // the threshold, the later passes emphasize the worst cells.
  void run() {
    static constexpr int passes = 4;
    m_complex.update_components(); // a patch keeps the component numbers of its cells
    for (double emphasis : {1., 3.}) {
      m_goal.emphasis = emphasis;
      for (int pass = 0; pass < passes; ++pass) {
        m_goal.rings = pass % 2 == 0 ? 2 : 1;
        improve(bad_cells());
        ++m_goal.variation;
      }
    }
  }

private:
  struct Item
  {
    double quality;
    std::size_t time_stamp;
    Cell_handle cell;
  };

  std::vector<Item> bad_cells() const {
    std::vector<Item> result;
    for (Cell_handle c : m_complex.triangulation().finite_cell_handles())
      if (is_bad_at_rest(m_complex, c, m_goal.threshold))
        result.push_back({c->quality(), c->time_stamp(), c});
    std::sort(result.begin(), result.end(), [](const Item& a, const Item& b) {
      return std::make_pair(a.quality, a.time_stamp) < std::make_pair(b.quality, b.time_stamp);
    });
    return result;
  }

  // Improves the patches around cells in sequence. Threads compute patches in advance. Such a
  // result is used only if none of the cells it depends on has changed meanwhile, so that the
  // outcome is deterministic.
  void improve(const std::vector<Item>& items) {
    static constexpr std::size_t worthwhile = 2;
    std::vector<std::optional<Patch_3<Complex>>> found(m_optimizers.size());
    for (std::size_t begin = 0; begin < items.size(); begin += found.size()) {
      Progress_scope::check();
      const std::size_t number = (std::min)(found.size(), items.size() - begin);
      const auto is_alive = [&](std::size_t k) {
        return m_complex.is_alive(items[begin + k].cell, items[begin + k].time_stamp);
      };
      const auto find = [&](std::size_t k) {
        found[k] = m_optimizers[k].run(items[begin + k].cell, m_goal);
      };
      m_for_each_index(
          number,
          [&](std::size_t k) {
            if (is_alive(k))
              find(k);
          },
          worthwhile);
      for (std::size_t k = 0; k < number; ++k) {
        if (!is_alive(k))
          continue;
        if (!m_optimizers[k].is_up_to_date())
          find(k);
        if (found[k])
          commit(*found[k]);
      }
    }
  }

  void commit(const Patch_3<Complex>& patch) {
    patch.propose(m_cavity);
    std::vector<bool> stays(m_cavity.vertices().size(), false), is_new(stays);
    for (const auto& t : m_cavity.tetrahedra())
      for (auto i : t.vertices)
        stays[i] = true;
    for (std::size_t i = 0; i < stays.size(); ++i) {
      const auto& v = m_cavity.vertices()[i];
      if (v.handle == Vertex_handle()) {
        is_new[i] = true;
        ++m_report.inserted;
      } else if (!stays[i]) {
        m_visitor.before_collapse(v.handle, nearest_that_stays(v.handle, stays));
        ++m_report.collapsed;
      } else if (!is_unmoved(v)) {
        ++m_report.smoothed;
      }
    }
    replace_cavity(m_complex, m_cavity, m_visitor);
    for (std::size_t i = 0; i < is_new.size(); ++i)
      if (is_new[i])
        m_visitor.after_insertion(m_cavity.vertices()[i].handle);
    ++m_report.flipped;
    m_visitor.after_flip(m_cavity.created());
  }

  static bool is_unmoved(const typename Cavity<Complex>::Vertex& v) {
    return v.handle->point() == v.position;
  }

  Vertex_handle nearest_that_stays(Vertex_handle v, const std::vector<bool>& stays) const {
    Vertex_handle result;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < stays.size(); ++i) {
      const Vertex_handle w = m_cavity.vertices()[i].handle;
      if (!stays[i] || w == Vertex_handle() || !is_unmoved(m_cavity.vertices()[i]))
        continue;
      const double distance = (m_complex.position(w) - m_complex.position(v)).squared_length();
      if (distance < least) {
        least = distance;
        result = w;
      }
    }
    return result;
  }

  Complex& m_complex;
  Deformation_visitor<Complex>& m_visitor;
  const For_each_index& m_for_each_index;
  Patch_goal m_goal;
  Cavity<Complex> m_cavity;
  std::deque<Patch_optimizer_3<Complex>> m_optimizers; // optimizers must not be moved
  Improvement_report m_report;
};

// Implements `improve_mesh()`.
template <class Complex>
Improvement_report improve_whole_mesh(Complex& dsc,
                                      const Mesh_improvement_options<Complex>& options) {
  options.check();
  Deformation_visitor<Complex> no_visitor;
  Deformation_visitor<Complex>& visitor = options.visitor ? *options.visitor : no_visitor;
  const Progress_phase phase("improving the mesh");
  const double threshold = options.threshold();
  const unsigned rounds = options.number_of_iterations;
  const For_each_index for_each_index(options.number_of_threads);
  Mesh_improver<Complex> improver(dsc, visitor, threshold, for_each_index, true,
                                  options.smooth_interface);
  static constexpr int attempts = 5;
  improver.improve_all(threshold, rounds, attempts);
  if (!options.aggressive)
    return improver.report();
  Improvement_report patches;
  if constexpr (Complex::dimension == 3) { // in the plane, flips reach any triangulation
    Patch_improver_3<Complex> patch_improver(dsc, visitor, threshold, rounds, for_each_index);
    if (rounds > 0)
      patch_improver.run();
    patches = patch_improver.report();
  }
  improver.improve_all(threshold, rounds, 0);
  return improver.report() + patches;
}

} // namespace internal

/*!
\ingroup PkgInterfaceRemeshingRef

Improves the cells of a complex (Algorithm 3 of the paper; insertion \cgalCite{cgal:ks-atmi-07}).
The operations are reconnection, smoothing, collapses, insertion of vertices, and splits of long
edges. Except for splits, each operation is done only if it raises the worst quality of the cells it
replaces. If the quality of a cell stays low, the cells around it are improved beyond the threshold,
to give it room, unless the number of cells of low quality has more than doubled. It grows in a mesh
that is squeezed in a direction, where no operation helps: scale such a mesh. The interface is
bitwise unchanged unless `smooth_interface` is set. Some passes over the cells, then n log n in the
number of cells below the threshold.

The quality is that of the complex's quality measure. If dihedral angles are important in 3D, choose
`Biased_minimum_sine_3`. The result is deterministic: random numbers come from generators with fixed
seeds.

\tparam ConcurrencyTag gives the default of `number_of_threads`: 1, or all threads if it is
        `Parallel_tag`
\param dsc the complex
\param np a `Mesh_improvement_options`, or named parameters with the names of its members. A visitor, a `Deformation_visitor`, is given by value or by `std::reference_wrapper`.

\return the numbers of changes
\throws Error if a parameter is out of its range; the complex is then unchanged

After an exception of the visitor, the complex is valid.
*/
template <class ConcurrencyTag = Sequential_tag, class Complex,
          class NamedParameters = parameters::Default_named_parameters>
Improvement_report improve_mesh(Complex& dsc, const NamedParameters& np = NamedParameters()) {
  return internal::call_with_parameters<ConcurrencyTag>(
      dsc, np, Mesh_improvement_options<Complex>(),
      [&](const auto& options) { return internal::improve_whole_mesh(dsc, options); });
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_IMPROVE_MESH_H
