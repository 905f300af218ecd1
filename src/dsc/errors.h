// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_ERRORS_H
#define DSC_ERRORS_H

#include <stdexcept>

namespace dsc {

/// An invalid command line. The program ends with exit code 2.
class Usage_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// An unusable input, or a file that cannot be read or written. The program ends with exit code 1.
class Input_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

} // namespace dsc

#endif // DSC_ERRORS_H
