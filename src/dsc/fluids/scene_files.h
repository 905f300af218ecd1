// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_SCENE_FILES_H
#define DSC_SCENE_FILES_H

#include <map>
#include <string>

namespace dsc {

/// Returns the files of the installed scenes, by the names of the scenes. The first existing folder
/// is used: the installed folder, relative to the program, or the folder of the source tree.
/// Returns an empty map if neither exists.
std::map<std::string, std::string> scene_files();

/// Returns the end of a message about missing scenes: the folders that scene_files() searches.
std::string searched_scene_folders();

} // namespace dsc

#endif // DSC_SCENE_FILES_H
