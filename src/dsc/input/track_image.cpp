// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/domain_box.h"
#include "input/start_complex.h"
#include "input/voxel_images.h"
#include "motions/tracked_complex_3.h"
#include "programs/errors.h"

#include <CGAL/Complex_construction/convert_labeled_image_3.h>
#include <CGAL/Mesh_support/Error.h>

namespace dsc {

std::unique_ptr<Tracked_complex> track_image(const std::string& path, const Run_options& options) {
  const CGAL::Image_3 image = read_inr(path);
  try {
    auto result = std::make_unique<Tracked_complex_3>(
        DSC::make_complex_from_labeled_image_3<Tracked_complex_3::Complex>(
            image, options.start.edge, normalized(options.domain, options.start.thin_parts)));
    if (result->complex.interface_facets().empty())
      throw Input_error(path + ": all voxels have the same label, so there is no interface; give a "
                               "larger --domain, which has label 0 around the image");
    return result;
  } catch (const DSC::Error& error) {
    throw Input_error(path + ": " + error.what());
  }
}

} // namespace dsc
