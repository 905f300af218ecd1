#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_TEST_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_TEST_H

// What most tests use: GoogleTest, headers of the standard library, and short names of namespaces.
// A test includes this header and the headers that it tests.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {}
namespace CGAL::parameters {}

namespace DSC = CGAL::Deformable_simplicial_complexes;
namespace parameters = CGAL::parameters;
namespace fs = std::filesystem;

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// Returns the exception that a function throws. It must be of the type `Error`.
template <class Error, class Function> Error thrown_by(const Function& function) {
  try {
    function();
  } catch (const Error& error) {
    return error;
  }
  throw std::logic_error("no exception");
}

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_TEST_H
