// Catches the exceptions of builders, of a deformation and of a reader, and prints their messages
// and data.
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Mesh_files/checkpoint.h>

#include <array>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Point = Complex::Point_3;
using Surface = DSC::Labeled_surface_3<Point>;

void print(const char* what, const std::vector<std::size_t>& indices) {
  std::cout << "  " << what << ':';
  for (const std::size_t i : indices)
    std::cout << ' ' << i;
  std::cout << '\n';
}

// Runs a function and prints the error that its input causes.
template <class Function> void report_errors(const Function& function) {
  try {
    function();
  } catch (const DSC::Invalid_surface_error& e) {
    std::cout << e.what() << '\n';
    print("facets", e.facets());
    print("ends of edges", e.vertices());
  } catch (const DSC::Tetrahedralization_error& e) {
    std::cout << e.what() << "\n  code: " << e.code() << '\n';
  } catch (const DSC::Invalid_cells_error& e) {
    std::cout << e.what() << '\n';
    print("tetrahedra", e.tetrahedra());
    print("vertices", e.vertices());
  } catch (const DSC::Invalid_destination_error& e) {
    std::cout << e.what() << '\n';
    print("vertices of the interface", e.vertices());
  } catch (const DSC::File_error& e) {
    std::cout << e.what() << "\n  path: " << e.path() << '\n';
  }
}

int main() {
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  const auto no_tetrahedralizer = [](const auto&, const auto&) {
    return DSC::Tetrahedralization_3();
  };
  const auto make = [&](const Surface& surface) {
    return DSC::make_deformable_simplicial_complex_3<Complex>(std::vector<Surface>{surface},
                                                              no_tetrahedralizer);
  };
  const std::vector<std::array<std::size_t, 3>> facets = {
      {0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

  // A surface with a hole; then a closed surface, with a tetrahedralizer that returns nothing
  report_errors([&] { make({points, {facets[0], facets[1], facets[2]}, 1}); });
  report_errors([&] { make({points, facets, 1}); });

  // Two tetrahedra of which the second one is degenerate; then two valid ones
  Complex complex;
  report_errors([&] { complex.assign(points, {{0, 1, 2, 3}, {1, 2, 3, 3}}, {1, 2}); });
  complex.assign(points, {{0, 1, 2, 3}, {1, 2, 3, 4}}, {1, 2});

  const double nan = std::numeric_limits<double>::quiet_NaN();
  report_errors([&] {
    DSC::deform_interface(complex, [&](Complex::Vertex_handle) { return Point(nan, 0, 0); });
  });
  report_errors([] { CGAL::IO::read_checkpoint("no_such_file"); });
  return complex.is_valid() ? EXIT_SUCCESS : EXIT_FAILURE;
}
