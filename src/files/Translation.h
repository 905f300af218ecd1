// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FILES_TRANSLATION_H
#define DSC_FILES_TRANSLATION_H

#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace dsc_files {

/// A file cannot be translated. The message is the rest of a sentence that begins with its name.
struct Failure : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// How a file is read.
struct Options
{
  std::string input;
  std::string folder;     ///< of the translation
  std::string labels;     ///< name of the cell array with labels, for cells in the plane
  std::string values;     ///< of an image that are kept: `gray` or `color`; empty for labels
  std::string thresholds; ///< of gray values: numbers, `otsu` or `otsu:K`; empty for labels
};

/// A file in a format that the package reads.
struct Translation
{
  std::string path;
  std::vector<std::string> unused;  ///< contents of the input that are not in the file
  std::vector<std::string> notes;   ///< choices that the user should know
  std::map<int, std::string> names; ///< of labels, in the input

  /// Adds a number of items to the unused contents, unless there are none.
  void leave_out(std::size_t number, const std::string& singular, const std::string& plural) {
    if (number > 0)
      unused.push_back(std::to_string(number) + ' ' + (number == 1 ? singular : plural));
  }
};

} // namespace dsc_files

#endif // DSC_FILES_TRANSLATION_H
