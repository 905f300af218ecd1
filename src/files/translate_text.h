// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FILES_TRANSLATE_TEXT_H
#define DSC_FILES_TRANSLATE_TEXT_H

#include "Translation.h"

namespace dsc_files {

/// Translates points: tables with columns x, y and z, and normal columns if there are any. Points
/// that are not finite, as in organized clouds, are left out. Writes `points.xyz` or `points.pwn`.
/// \throws Failure if the file cannot be read
Translation translate_csv(const Options& options); ///< text with commas, semicolons or spaces
Translation translate_pcd(const Options& options); ///< of the Point Cloud Library, text or binary

/// Translates the polygons of a GeoJSON file (RFC 7946) into `regions.wkt`, in their order.
/// \throws Failure if the file cannot be read
Translation translate_geojson(const Options& options);

} // namespace dsc_files

#endif // DSC_FILES_TRANSLATE_TEXT_H
