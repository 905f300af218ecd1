// Stops a long computation after a tenth of a second, and runs another one on several threads.
#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Clock = std::chrono::steady_clock;

int main() {
  // A loop without end calls `check()`, which throws when the callback returns false.
  const auto end = Clock::now() + std::chrono::milliseconds(100);
  std::size_t steps = 0;
  bool is_stopped = false;
  try {
    const DSC::Progress_scope scope([&](const char* /*phase*/) { return Clock::now() < end; });
    for (;; ++steps)
      DSC::Progress_scope::check();
  } catch (const DSC::Interrupted_error& error) {
    is_stopped = true;
    std::cout << error.what() << ", after " << steps << " steps\n";
  }

  // Each call writes its own element, so the result does not depend on the number of threads.
  std::vector<double> one(100000), four(one.size());
  DSC::For_each_index()(one.size(), [&](std::size_t i) { one[i] = std::sqrt(double(i)); });
  DSC::For_each_index(4)(four.size(), [&](std::size_t i) { four[i] = std::sqrt(double(i)); });
  std::cout << "the results are " << (one == four ? "equal" : "different") << std::endl;
  return is_stopped && one == four ? EXIT_SUCCESS : EXIT_FAILURE;
}
