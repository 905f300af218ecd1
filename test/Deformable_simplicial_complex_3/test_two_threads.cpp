#include "mesh_helpers.h"
#include "small_meshes.h"

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/deform_interface_3.h>
#include <CGAL/improve_mesh_3.h>

#include <gtest/gtest.h>

#include <future>
#include <vector>

// One thread at a time may use a complex, but two complexes share nothing: two threads may work at
// once, each on its own, and each may have helpers. scripts/check_more.sh runs this with the thread
// sanitizer.
namespace {

using small_meshes::Complex;
using State = Complex::State;
namespace parameters = CGAL::Deformable_simplicial_complexes::parameters;

// Two parts that turn and grow, on a mesh that is large enough for several threads.
State flow(unsigned number_of_threads) {
  Complex dsc = small_meshes::make_complex(small_meshes::grid(12, small_meshes::two_boxes));
  for (int step = 0; step < 2; ++step)
    CGAL::deform_interface(
        dsc,
        [&](Complex::Vertex_handle v) {
          const auto p = dsc.position(v);
          return mesh_helpers::exact_point(
              dsc, p + .1 * Complex::Approximate_vector_3(p.x() - p.y(), p.x() + p.y(), p.z()));
        },
        parameters::number_of_threads(number_of_threads));
  CGAL::improve_mesh(dsc);
  return dsc.state();
}

// All that can be asked for, in numbers.
std::vector<double> answers(const Complex& dsc) {
  std::vector<double> result = {double(dsc.number_of_vertices()), double(dsc.number_of_cells()),
                                double(dsc.is_valid())};
  for (int label : dsc.labels())
    for (double answer :
         {dsc.volume(label), dsc.area(label), double(dsc.euler_characteristic(label)),
          double(dsc.number_of_components(label))})
      result.push_back(answer);
  std::vector<Complex::Cell_handle> star;
  for (auto v : dsc.interface_vertices()) {
    dsc.star(v, star);
    result.push_back(double(star.size()));
    result.push_back(double(dsc.is_positive_star(v, star, v->point())));
    result.push_back(dsc.user_position(v).x());
  }
  for (const auto& f : dsc.interface_facets())
    result.push_back(dsc.area(f));
  return result;
}

} // namespace

TEST(Two_threads, queries_of_two_complexes) {
  const Complex a = small_meshes::make_complex(small_meshes::grid(8, small_meshes::two_boxes));
  const Complex b = a;
  const auto expected = answers(Complex(a));
  auto other = std::async(std::launch::async, [&] { return answers(b); });
  EXPECT_EQ(answers(a), expected);
  EXPECT_EQ(other.get(), expected);
}

TEST(Two_threads, whole_flows_with_threads_of_their_own) {
  const State expected = flow(1);
  auto other = std::async(std::launch::async, flow, 2u);
  EXPECT_TRUE(flow(2) == expected);
  EXPECT_TRUE(other.get() == expected);
}
