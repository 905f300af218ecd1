// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_RESTORE_VOLUMES_H
#define CGAL_INTERFACE_REMESHING_RESTORE_VOLUMES_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Interface_remeshing/Volume_changer.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/named_parameters.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceRemeshingRef
Report of `restore_volumes()`.
\tparam Complex a deformable simplicial complex
*/
template <class Complex> struct Volume_report
{
  bool complete = true; ///< whether all volumes are correct within the tolerance
  /// one for each deformation; vertices in earlier reports may have been removed since
  std::vector<Deformation_report<Complex>> deformations;
};

/*!
\ingroup PkgInterfaceRemeshingRef

Options of `restore_volumes()`. The named parameters of that function have the same names.

\tparam Complex a deformable simplicial complex
*/
template <class Complex> struct Volume_restoration_options
{
  Deformation_options<Complex> deformation; ///< Options of the deformations.
  /// Largest relative error of a volume at the end, greater than 0.
  double volume_tolerance = 1e-10;
  /// Largest number of deformations. Before each one, Newton's method computes its destinations.
  unsigned number_of_iterations = 5;

  /// Throws an exception unless all values are in their ranges.
  /// \throws Error if a value is out of its range
  void check() const {
    deformation.check();
    if (!(volume_tolerance > 0))
      throw Error("the tolerance of volumes is out of range: use more than 0");
  }
};

namespace internal {

// Implements `restore_volumes()`.
template <class Complex>
Volume_report<Complex> restore_all_volumes(Complex& dsc,
                                           const std::map<typename Complex::Label, double>& volumes,
                                           const Volume_restoration_options<Complex>& options) {
  options.check();
  double domain = 0, target = 0;
  for (const auto label : dsc.labels())
    domain += dsc.measure(label);
  for (const auto& [label, volume] : volumes) {
    target += volume;
    if (!(volume > 0) || !std::isfinite(volume))
      throw Error("the volume of label " + std::to_string(label) +
                  " cannot be restored: the target is not positive and finite; give a positive, "
                  "finite volume");
    if (dsc.number_of_cells(label) == 0)
      throw Error("the volume of label " + std::to_string(label) +
                  " cannot be restored: no cell has this label; remove it from the targets");
  }
  const bool are_all_given = volumes.size() == dsc.labels().size();
  if (!are_all_given && target >= domain)
    throw Error("the target volumes leave no volume for the other labels: reduce them");
  if (are_all_given && std::abs(target - domain) > options.volume_tolerance * domain)
    throw Error("the target volumes of all labels do not add up to the volume of the domain: leave "
                "out one label, which then takes the remaining volume");

  Volume_report<Complex> report;
  for (;;) {
    std::map<typename Complex::Label, double> missing;
    report.complete = true;
    for (const auto& [label, volume] : volumes) {
      missing[label] = volume - dsc.measure(label);
      report.complete =
          report.complete && std::abs(missing[label]) <= options.volume_tolerance * volume;
    }
    const std::size_t done = report.deformations.size();
    const bool is_ended =
        done > 0 && (report.deformations.back().stopped || report.deformations.back().passes == 0);
    if (report.complete || done == options.number_of_iterations || is_ended)
      return report;
    const Interface_snapshot<Complex> interface_(dsc);
    auto positions = interface_.positions(dsc);
    Volume_changer<Complex>(interface_).change_by(missing, positions);
    report.deformations.push_back(
        deform_interface_to(dsc, interface_, positions, options.deformation));
  }
}

} // namespace internal

/*!
\ingroup PkgInterfaceRemeshingRef

Restores given volumes (in 2D, areas) of labels by moving the interface along its normals. Parts of
the interface between two labels move by the same distance where they are flat. Use it after a time
step of a volume-preserving flow whose discretization changes volumes. The correction is repeated
until the volumes are correct, since `deform_interface()` may change the mesh. Linear in the size of
the interface, plus the deformations.

\tparam ConcurrencyTag gives the default of `number_of_threads`: 1, or all threads if it is
        `Parallel_tag`
\param dsc the complex
\param volumes target volumes of labels, positive, in the coordinates of the complex. Labels without
       a target volume share the rest of the domain.
\param np a `Volume_restoration_options`, or named parameters: those of `deform_interface()`, and
       those with the names of the other members of `Volume_restoration_options`

\return the deformations, and whether all volumes are correct within the tolerance. If they are not,
        the interface could not reach its destinations, a visitor ended the deformation, or there
        were too few iterations.
\throws Error if a label does not occur, a volume or the tolerance is not positive, or the number of
        iterations is negative. Also if all labels are given and their volumes do not fill the
        domain, or if some are given and leave no volume for the others. The complex is then
        unchanged.
*/
template <class ConcurrencyTag = Sequential_tag, class Complex,
          class NamedParameters = parameters::Default_named_parameters>
Volume_report<Complex> restore_volumes(Complex& dsc,
                                       const std::map<typename Complex::Label, double>& volumes,
                                       const NamedParameters& np = NamedParameters()) {
  return internal::call_with_parameters<ConcurrencyTag>(
      dsc, np, Volume_restoration_options<Complex>(),
      [&](const auto& options) { return internal::restore_all_volumes(dsc, volumes, options); });
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_RESTORE_VOLUMES_H
