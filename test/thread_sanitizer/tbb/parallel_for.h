#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_THREAD_SANITIZER_TBB_PARALLEL_FOR_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_THREAD_SANITIZER_TBB_PARALLEL_FOR_H

#include <thread>

// Replacement of TBB for the thread sanitizer. The library of TBB is not built with the sanitizer,
// so the sanitizer does not see its synchronization and reports races in all loops.
namespace tbb {

template <class Range, class Body> void parallel_for(const Range& range, const Body& body) {
  const auto middle = range.begin() + range.size() / 2;
  std::thread second_half([&] { body(Range(middle, range.end())); });
  body(Range(range.begin(), middle));
  second_half.join();
}

} // namespace tbb

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_THREAD_SANITIZER_TBB_PARALLEL_FOR_H
