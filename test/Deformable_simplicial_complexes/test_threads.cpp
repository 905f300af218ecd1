#include "mesh_helpers.h"
#include "plane.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>
#include <CGAL/Interface_flows/Mean_curvature_flow.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/face_offsetting_3.h>
#include <CGAL/Interface_flows/interface_flows_2.h>
#include <CGAL/Interface_flows/interface_flows_3.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>
#include <CGAL/Mesh_support/For_each_index.h>

#include <future>

// Several threads may query a complex; only one thread may change it. Two complexes share no data:
// two threads may work on one complex each, with helper threads. scripts/check_more.sh runs this
// program with the thread sanitizer.
namespace {

using small_meshes::Complex;
using State = Complex::State;

// Two components that rotate and grow, on a mesh that is large enough for several threads.
State flow(unsigned number_of_threads) {
  Complex dsc = small_meshes::make_complex(small_meshes::grid(12, small_meshes::two_boxes));
  for (int step = 0; step < 2; ++step)
    DSC::deform_interface(
        dsc,
        [&](Complex::Vertex_handle v) {
          const auto p = dsc.position(v);
          return p + .1 * Complex::Vector_3(p.x() - p.y(), p.x() + p.y(), p.z());
        },
        parameters::number_of_threads(number_of_threads));
  DSC::improve_mesh(dsc);
  return dsc.state();
}

// Returns the results of all queries as numbers.
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

// Returns the results of proposals at each cell.
std::vector<double> proposals(const Complex& dsc) {
  std::vector<double> result;
  DSC::Cavity<Complex> cavity(dsc);
  std::vector<Complex::Cell_handle> star;
  for (auto c : dsc.cells()) {
    for (bool is_proposed : {DSC::propose_edge_removal(dsc, c, 0, 1, cavity),
                             DSC::propose_multi_face_removal(dsc, c, 2, cavity),
                             DSC::propose_edge_collapse(dsc, c, 3, 0, 0, cavity)})
      result.push_back(is_proposed ? cavity.quality_after() : -1);
    Complex::Point_3 target;
    dsc.star(c->vertex(0), star);
    const bool is_proposed = DSC::propose_optimal_position(dsc, c->vertex(0), star, target);
    result.push_back(is_proposed ? target.x() : -1);
  }
  return result;
}

} // namespace

TEST(Threads, queries_of_one_complex) {
  Complex dsc = small_meshes::make_complex(small_meshes::grid(6, small_meshes::two_boxes));
  mesh_helpers::jitter(dsc, .1, 1);
  // Components may have changed, so the first query must count them.
  const auto cells = dsc.cells();
  dsc.relabel(cells[cells.size() / 2], 3);
  const Complex copy = dsc;
  const auto expected = answers(copy), expected_proposals = proposals(copy);
  const State state = copy.state();
  const Complex& asked = dsc;
  std::vector<std::future<bool>> others;
  for (int i = 0; i < 4; ++i)
    others.push_back(std::async(std::launch::async, [&] {
      return answers(asked) == expected && proposals(asked) == expected_proposals &&
             asked.state() == state;
    }));
  for (auto& other : others)
    EXPECT_TRUE(other.get());
}

TEST(Threads, components_are_found_once) {
  Complex dsc = small_meshes::make_complex(small_meshes::grid(6, small_meshes::two_boxes));
  const auto cells = dsc.cells();
  dsc.relabel(cells[cells.size() / 2], 3);
  const Complex& asked = dsc;
  auto state = std::async(std::launch::async, [&] { return asked.state(); });
  auto copy = std::async(std::launch::async, [&] { return Complex(asked).state(); });
  auto number = std::async(std::launch::async, [&] { return asked.number_of_components(3); });
  EXPECT_TRUE(asked.is_valid());
  EXPECT_EQ(number.get(), 1u);
  EXPECT_TRUE(state.get() == copy.get());
}

TEST(Threads, queries_of_two_complexes) {
  const Complex a = small_meshes::make_complex(small_meshes::grid(8, small_meshes::two_boxes));
  const Complex b = a;
  const auto expected = answers(Complex(a));
  auto other = std::async(std::launch::async, [&] { return answers(b); });
  EXPECT_EQ(answers(a), expected);
  EXPECT_EQ(other.get(), expected);
}

TEST(Threads, whole_flows_with_threads_of_their_own) {
  const State expected = flow(1);
  auto other = std::async(std::launch::async, flow, 2u);
  EXPECT_TRUE(flow(2) == expected);
  EXPECT_TRUE(other.get() == expected);
}

namespace {

// Checks that a flow gives bitwise equal results with one and with several threads.
template <class Complex, class Flow>
void expect_same_bits(const Complex& initial, const Flow& flow, double dt) {
  const auto state_after = [&](unsigned number_of_threads) {
    Complex dsc = initial;
    for (int step = 0; step < 2; ++step)
      DSC::advect_interface(dsc, flow, step * dt, dt,
                            parameters::number_of_threads(number_of_threads));
    return dsc.state();
  };
  const auto expected = state_after(1);
  EXPECT_FALSE(expected == initial.state());
  for (unsigned number_of_threads : {2, 3, 4, 8})
    EXPECT_TRUE(state_after(number_of_threads) == expected) << number_of_threads << " threads";
}

// The meshes are large enough for several threads.
Complex solid(int (*label)(const small_meshes::Point&)) {
  Complex dsc = small_meshes::make_complex(small_meshes::grid(10, label));
  mesh_helpers::jitter(dsc, .04, 3);
  return dsc;
}

} // namespace

TEST(Threads, change_no_bit_of_flows_in_space) {
  const Complex ball = solid(small_meshes::ball);
  const double edge = ball.mean_interface_edge();
  const DSC::Rigid_rotation_3 rotation(CGAL::ORIGIN, Complex::Vector_3(0, 0, 1), .05);
  expect_same_bits(ball, rotation, 1);
  expect_same_bits(ball, DSC::Normal_offset{edge / 4}, 1);
  expect_same_bits(ball, DSC::Face_offset_3{edge / 4}, 1);
  expect_same_bits(ball, DSC::Mean_curvature_flow(), edge * edge / 4);
  const Complex phases = solid(small_meshes::eight_phases);
  expect_same_bits(phases, DSC::Normal_offset{-edge / 4}, 1);
  expect_same_bits(phases, DSC::Mean_curvature_flow(), edge * edge / 4);
}

// Cells that were created in place of others are found, too.
TEST(Threads, find_the_same_cells) {
  Complex dsc = solid(small_meshes::ball);
  ASSERT_GT(DSC::improve_mesh(dsc).flipped, 0u);
  const auto is_inside = [](Complex::Cell_handle c) { return c->subdomain_index() == 1; };
  std::vector<Complex::Cell_handle> expected;
  for (auto c : dsc.cells())
    if (is_inside(c))
      expected.push_back(c);
  ASSERT_FALSE(expected.empty());
  const auto found = dsc.finite_cells_if(is_inside, DSC::For_each_index(1));
  for (unsigned threads : {2, 3, 8}) {
    const DSC::For_each_index for_each_index(threads);
    EXPECT_EQ(dsc.finite_cells_if(is_inside, for_each_index), found);
    EXPECT_EQ(dsc.interface_facets(for_each_index), dsc.interface_facets());
  }
  auto sorted = found;
  std::sort(sorted.begin(), sorted.end(),
            [](auto a, auto b) { return a->time_stamp() < b->time_stamp(); });
  EXPECT_EQ(sorted, expected);
}

TEST(Threads, change_no_bit_of_smoothing) {
  const auto improved = [](unsigned number_of_threads) {
    Complex dsc = mesh_helpers::jittered_grid(8, small_meshes::ball, .4, 5);
    const auto report = DSC::improve_mesh(
        dsc, parameters::number_of_iterations(2).number_of_threads(number_of_threads));
    EXPECT_GT(report.smoothed, 100u); // enough vertices of one color for threads
    return dsc.state();
  };
  const State expected = improved(1);
  for (unsigned number_of_threads : {2, 3, 8})
    EXPECT_TRUE(improved(number_of_threads) == expected) << number_of_threads << " threads";
}

TEST(Threads, change_no_bit_of_aggressive_improvement) {
  const auto improved = [](unsigned number_of_threads) {
    Complex dsc = mesh_helpers::jittered_grid(3, small_meshes::ball, .4, 5);
    DSC::improve_mesh(dsc, parameters::aggressive(true).number_of_iterations(1).number_of_threads(
                               number_of_threads));
    return dsc.state();
  };
  const State expected = improved(1);
  for (unsigned number_of_threads : {2, 8})
    EXPECT_TRUE(improved(number_of_threads) == expected) << number_of_threads << " threads";
}

TEST(Threads, change_no_bit_of_flows_in_the_plane) {
  const auto disks = plane::disks_in_a_square({{-.3, 0, .25, 1}, {.3, .1, .25, 2}}, 200, 1, 40);
  ASSERT_GT(disks.number_of_cells(), 3000u);
  const double edge = disks.mean_interface_edge();
  const DSC::Rigid_rotation_2 rotation(plane::Complex::Point_2(0, 0), .05);
  expect_same_bits(disks, rotation, 1);
  expect_same_bits(disks, DSC::Normal_offset{2 * edge}, 1);
  expect_same_bits(disks, DSC::Mean_curvature_flow(), edge * edge);
}
