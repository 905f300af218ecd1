// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FILES_TEXT_FILE_H
#define DSC_FILES_TEXT_FILE_H

#include "Translation.h"

#include <fstream>
#include <limits>
#include <string>

namespace dsc_files {

/// Writes numbers with all digits.
class Text_file
{
public:
  explicit Text_file(const std::string& path) : m_out(path) {
    m_out.precision(std::numeric_limits<double>::max_digits10);
  }

  template <class T> Text_file& operator<<(const T& value) {
    m_out << value;
    return *this;
  }

  void close() {
    m_out.close();
    if (!m_out)
      throw Failure("cannot be translated: the disk for temporary files is full");
  }

private:
  std::ofstream m_out;
};

} // namespace dsc_files

#endif // DSC_FILES_TEXT_FILE_H
