// Callbacks stop long functions, and loops on several threads give the same results as one thread.
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#undef NDEBUG // the program checks its results by `assert()` in every build
#include <cassert>

namespace DSC = CGAL::Deformable_simplicial_complexes;

int main() {
  // The beginning of a phase and each check call the callback. Its third call stops the loop.
  int calls = 0, steps = 0;
  std::string name;
  bool is_interrupted = false;
  try {
    const DSC::Progress_scope scope(
        [&](const char* phase) {
          name = phase;
          return ++calls < 3;
        },
        std::chrono::milliseconds(0));
    const DSC::Progress_phase phase("counting");
    for (; steps < 1000; ++steps)
      DSC::Progress_scope::check();
  } catch (const DSC::Interrupted_error&) {
    is_interrupted = true;
  }
  assert(is_interrupted && calls == 3 && steps == 1 && name == "counting");

  // Nothing is called after the scope, nor during a pause.
  DSC::Progress_scope::check();
  {
    const DSC::Progress_scope scope([&](const char*) { return ++calls < 0; },
                                    std::chrono::milliseconds(0));
    const DSC::Progress_pause pause;
    DSC::Progress_scope::check();
  }
  assert(calls == 3);

  // Loops
  std::vector<double> one(100000), four(one.size());
  DSC::For_each_index(1)(one.size(), [&](std::size_t i) { one[i] = std::sin(double(i)); });
  const DSC::For_each_index on_four_threads(4);
  on_four_threads(four.size(), [&](std::size_t i) { four[i] = std::sin(double(i)); });
  assert(one == four);

  // Errors are exceptions of the standard library.
  try {
    throw DSC::Error("why");
  } catch (const std::exception& error) {
    assert(std::string(error.what()) == "why");
  }
  return EXIT_SUCCESS;
}
