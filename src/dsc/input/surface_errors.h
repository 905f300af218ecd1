// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_SURFACE_ERRORS_H
#define DSC_SURFACE_ERRORS_H

#include <CGAL/Triangle_soup_repair/Invalid_surface_error.h>

#include <string>

namespace dsc {

/// Returns the message of an error without the number of the surface, which has no meaning for
/// users.
inline std::string
message_of(const CGAL::Deformable_simplicial_complexes::Invalid_surface_error& error) {
  const std::string text = error.what(),
                    number = "surface " + std::to_string(error.surface()) + ' ';
  return text.rfind(number, 0) == 0 ? "the surface " + text.substr(number.size()) : text;
}

} // namespace dsc

#endif // DSC_SURFACE_ERRORS_H
