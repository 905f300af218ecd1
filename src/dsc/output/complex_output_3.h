// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_COMPLEX_OUTPUT_3_H
#define DSC_COMPLEX_OUTPUT_3_H

#include "input/files.h"
#include "input/formats.h"
#include "output/angle_statistics.h"
#include "output/label_titles.h"
#include "output/picture.h"
#include "output/statistics.h"

#include <CGAL/Interface_remeshing/extract_interface_3.h>
#include <CGAL/Mesh_files/MEDIT_3.h>
#include <CGAL/Mesh_files/VTU_3.h>
#include <CGAL/Mesh_files/labeled_surface_3.h>
#include <CGAL/Mesh_support/coordinates.h>

namespace dsc {

/// Returns the statistics of a complex in space whose labels may have names.
template <class Complex>
Statistics statistics_of(const Complex& complex, const Label_names& names) {
  const double scale = complex.normalization().scale;
  Statistics statistics = {};
  statistics.dimension = 3;
  statistics.vertices = complex.number_of_vertices();
  statistics.cells = complex.number_of_cells();
  statistics.interface_facets = complex.interface_facets().size();
  for (const auto& [label, area, euler_characteristic] : complex.label_interfaces())
    statistics.labels.push_back({label, complex.number_of_cells(label),
                                 complex.volume(label) * scale * scale * scale,
                                 area * scale * scale, complex.number_of_components(label),
                                 euler_characteristic, label_name(label, names)});
  set_angles(complex, statistics);
  statistics.min_quality = least_quality(complex);
  return statistics;
}

template <class Complex> void write_picture_png(const std::string& path, const Complex& complex) {
  Picture picture;
  picture.is_in_space = true;
  for (const auto& f : complex.interface_facets()) {
    Picture_polygon triangle = {{}, color_of_label(f.first->subdomain_index())};
    for (const auto v : complex.facet_vertices(f))
      triangle.corners.push_back(DSC::coordinates_of<3>(complex.user_position(v)));
    picture.polygons.push_back(std::move(triangle));
  }
  write_picture(path, picture);
}

/// Writes the cells or the interface of a complex in space, in the format of the extension.
/// \param arrays arrays of a .vtu file, and the names of the labels
template <class Complex>
void write_complex(const std::string& path, const Complex& complex,
                   const DSC::Mesh_arrays& arrays) {
  require_format(path, Use::write, content::surface | content::tetrahedra | content::picture);
  tell_lost_names(path, arrays.label_names);
  const std::string format = extension(path);
  if (format == "vtu")
    CGAL::IO::write_VTU(path, complex, arrays);
  else if (format == "png")
    write_picture_png(path, complex);
  else if (format == "mesh")
    CGAL::IO::write_MEDIT(path, complex);
  else
    CGAL::IO::write_named_interface(path, DSC::extract_interface(complex), arrays.label_names);
}

} // namespace dsc

#endif // DSC_COMPLEX_OUTPUT_3_H
