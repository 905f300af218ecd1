#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_THREAD_SANITIZER_TBB_PARALLEL_FOR_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_THREAD_SANITIZER_TBB_PARALLEL_FOR_H

#include <thread>

// In place of TBB, whose library is not built with the sanitizer: how its threads wait for each
// other cannot be seen, so that every loop looks like a race. These can be seen.
namespace tbb {

template <class Range, class Body> void parallel_for(const Range& range, const Body& body) {
  const auto middle = range.begin() + range.size() / 2;
  std::thread second_half([&] { body(Range(middle, range.end())); });
  body(Range(range.begin(), middle));
  second_half.join();
}

} // namespace tbb

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_THREAD_SANITIZER_TBB_PARALLEL_FOR_H
