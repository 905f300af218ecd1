// Stops a flow after half a second; the complex stays valid.
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/interface_flows_3.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <chrono>
#include <cstdlib>
#include <iostream>

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using CGAL::Deformable_simplicial_complexes::Interrupted_error;
using CGAL::Deformable_simplicial_complexes::Progress_scope;
using Clock = std::chrono::steady_clock;

int main() {
  Complex ball = DSC::make_deformable_simplicial_complex_3<Complex>(
      CGAL::Bbox_3(-1, -1, -1, 1, 1, 1), .1,
      [](const auto& p) { return (p - CGAL::ORIGIN).squared_length() < .25; });

  // The time limit suffices for only some of the steps.
  const auto end = Clock::now() + std::chrono::milliseconds(500);
  int done = 0;
  try {
    const Progress_scope scope([&](const char* /*phase*/) { return Clock::now() < end; });
    for (; done < 1000; ++done)
      DSC::advect_interface(ball, DSC::Normal_offset{-.01}, done, 1.);
    std::cout << "all steps done\n";
  } catch (const Interrupted_error& error) {
    std::cout << error.what() << ", after " << done << " steps\n";
  }
  std::cout << "the complex is " << (ball.is_valid() ? "valid" : "broken") << '\n';
  return ball.is_valid() ? EXIT_SUCCESS : EXIT_FAILURE;
}
