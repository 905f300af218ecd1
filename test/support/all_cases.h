#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_ALL_CASES_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_ALL_CASES_H

#include <cstdlib>
#include <string>

// Returns whether long tests run all of their cases. They do in scripts/check_more.sh;
// scripts/test.sh has time for a part of the cases.
inline bool all_cases() {
  const char* const value = std::getenv("DSC_ALL_CASES");
  return value != nullptr && std::string(value) == "1";
}

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_ALL_CASES_H
