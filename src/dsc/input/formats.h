// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FORMATS_H
#define DSC_FORMATS_H

#include <string>

namespace dsc {

/// What files contain; unions of these sets by `|`.
namespace content {
inline constexpr unsigned surface = 1, tetrahedra = 2, voxels = 4, pixels = 8, regions = 16,
                          points = 32, complex = 64, picture = 128, drawing = 256, triangles = 512,
                          scene = 1024, report = 2048, states = 4096, page = 8192, all = 16383;
/// What a run starts from, other than checkpoints.
inline constexpr unsigned starts = surface | tetrahedra | voxels | pixels | regions;
} // namespace content

enum class Use { read, write };

/// The following functions know the formats of all files of the program. They take the contents
/// that `dsc` reads or writes itself, and the contents that it reads or writes through `dsc-files`.

/// Returns the extensions of the formats with any of these contents, like ".off, .obj".
std::string formats_with(Use use, unsigned native, unsigned foreign = 0);

/// Returns whether the extension of a file belongs to a format with any of these contents.
bool has_format(const std::string& path, Use use, unsigned native, unsigned foreign = 0);

/// \throws Usage_error with the extensions of these contents, unless `has_format()`
void require_format(const std::string& path, Use use, unsigned native, unsigned foreign = 0);

/// Returns the extension of the format of a file, which its first bytes tell; empty if they do not.
std::string format_of_content(const std::string& path);

} // namespace dsc

#endif // DSC_FORMATS_H
