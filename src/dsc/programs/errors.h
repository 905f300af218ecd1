// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_ERRORS_H
#define DSC_ERRORS_H

#include <cstddef>
#include <new>
#include <stdexcept>
#include <string>

namespace CGAL::Deformable_simplicial_complexes {}
namespace DSC = CGAL::Deformable_simplicial_complexes;

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

/// Returns the text of an error for a message.
inline std::string error_message(const std::exception& error) {
  return dynamic_cast<const std::bad_alloc*>(&error) != nullptr
             ? "not enough memory; choose fewer --triangles or a smaller mesh"
             : error.what();
}

/// Returns the form of a noun for a number of items in a message: `singular` for one item.
inline const char* noun(std::size_t number, const char* singular, const char* plural) {
  return number == 1 ? singular : plural;
}

} // namespace dsc

#endif // DSC_ERRORS_H
