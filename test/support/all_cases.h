#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_ALL_CASES_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_ALL_CASES_H

#include <cstdlib>

// Returns whether long tests run all of their cases. They do in scripts/check_more.sh;
// scripts/test.sh has time for a part of the cases.
inline bool all_cases() { return std::getenv("DSC_ALL_CASES") != nullptr; }

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_ALL_CASES_H
