// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FILES_REQUIRE_COMPLETE_H
#define DSC_FILES_REQUIRE_COMPLETE_H

#include <string>

namespace dsc_files {

/// Checks whether a file has all bytes that its header announces, for formats whose readers in VTK
/// accept truncated files: MetaImage (.mha, .mhd), TIFF, and images of VTK in pieces.
/// \throws Failure if bytes are missing
void require_complete(const std::string& path, const std::string& format);

} // namespace dsc_files

#endif // DSC_FILES_REQUIRE_COMPLETE_H
