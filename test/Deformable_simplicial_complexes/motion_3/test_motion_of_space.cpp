#include "mesh_helpers.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/internal/motion/Harmonic_extension.h>
#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/internal/numbers/Conjugate_gradients.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <numeric>

namespace test_motion_of_space {

namespace internal = CGAL::Deformable_simplicial_complexes::internal;
using DSC::For_each_index;
using namespace small_meshes;

TEST(Row_blocks, have_all_rows_in_order) {
  for (const std::size_t size : {0, 1, 255, 256, 257, 5000}) {
    const For_each_index for_each_index(3);
    const internal::Row_blocks<std::size_t> rows(
        size,
        [](std::size_t i, std::vector<std::size_t>& row) {
          for (std::size_t k = 0; k < i % 4; ++k)
            row.push_back(10 * i + k);
        },
        for_each_index);
    std::vector<std::size_t> times(size, 0);
    rows.for_each_row(for_each_index, [&](std::size_t i) { ++times[i]; });
    for (std::size_t i = 0; i < size; ++i) {
      EXPECT_EQ(times[i], 1u);
      ASSERT_EQ(rows.row(i).size(), i % 4);
      for (std::size_t k = 0; k < i % 4; ++k)
        EXPECT_EQ(rows.row(i).begin()[k], 10 * i + k);
    }
  }
}

// A grid of n^2 nodes: the Laplace operator plus a varying multiple of the identity.
class Conjugate_gradients : public ::testing::Test
{
protected:
  using Solver = internal::Conjugate_gradients<3>;
  static constexpr std::uint32_t n = 50, size = n * n;

  Conjugate_gradients() {
    mesh_helpers::Random random(7);
    for (std::uint32_t i = 0; i < size; ++i) {
      diagonal.push_back(random(4, 5));
      right.push_back(Solver::Vector(random(0, 1), random(-2, -1), 0));
    }
  }

  static void neighbors(std::size_t row, std::vector<Solver::Entry>& entries) {
    const std::uint32_t i = std::uint32_t(row) / n, j = std::uint32_t(row) % n;
    const auto add = [&](std::uint32_t a, std::uint32_t b) {
      if (a < n && b < n)
        entries.push_back({a * n + b, -1});
    };
    add(i - 1, j);
    add(i, j - 1);
    add(i, j + 1);
    add(i + 1, j);
  }

  static bool is_held(std::size_t row, int side) { return side == 1 && row % 7 == 0; }

  std::vector<Solver::Vector> solve(unsigned threads, double part, int iterations) const {
    const For_each_index for_each_index(threads);
    const internal::Row_blocks<Solver::Entry> matrix(size, neighbors, for_each_index);
    return Solver(matrix, diagonal, for_each_index).solve(right, is_held, part, iterations);
  }

  std::vector<double> diagonal;
  std::vector<Solver::Vector> right;
};

TEST_F(Conjugate_gradients, find_what_a_factorization_finds) {
  const auto solution = solve(1, 1e-12, 1000);
  for (int side = 0; side < 3; ++side) {
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd b(size);
    for (std::uint32_t i = 0; i < size; ++i) {
      b[i] = is_held(i, side) ? 0 : right[i][side];
      entries.emplace_back(i, i, diagonal[i]);
      std::vector<Solver::Entry> row;
      neighbors(i, row);
      for (const auto& e : row)
        if (!is_held(i, side) && !is_held(e.column, side))
          entries.emplace_back(i, e.column, e.value);
    }
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factorized(matrix);
    const Eigen::VectorXd expected = factorized.solve(b);
    for (std::uint32_t i = 0; i < size; ++i)
      ASSERT_NEAR(solution[i][side], expected[i], 1e-10);
  }
}

TEST_F(Conjugate_gradients, are_the_same_bit_for_bit_with_any_number_of_threads) {
  const auto expected = solve(1, 1e-3, 1000);
  for (const unsigned threads : {2, 3, 8})
    EXPECT_EQ(solve(threads, 1e-3, 1000), expected);
}

TEST_F(Conjugate_gradients, stop_after_a_number_of_iterations) {
  EXPECT_EQ(solve(1, 1e-12, 0), std::vector<Solver::Vector>(size, Solver::Vector::Zero()));
  EXPECT_NE(solve(1, 1e-12, 5), solve(1, 1e-12, 6));
}

class Harmonic_extension : public ::testing::Test
{
protected:
  Harmonic_extension()
      : dsc(small_meshes::make_complex(small_meshes::grid(12, small_meshes::uniform))) {
    for (Vertex_handle v : dsc.vertices())
      if (!dsc.is_boundary(v))
        free.push_back(v);
  }

  Vector linear(Vertex_handle v) const {
    const auto p = dsc.position(v);
    return Vector(p.x() + 2 * p.y(), p.z() - p.x(), 3 * p.y() - p.z());
  }

  std::vector<Vector> solve(unsigned threads) const {
    const For_each_index for_each_index(threads);
    const internal::Moving_region<Complex> region(dsc, free, for_each_index);
    std::vector<std::uint32_t> numbers(free.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    return internal::Harmonic_extension<Complex>(
               region, numbers, [&](std::size_t v) { return linear(region.vertices()[v]); },
               for_each_index)
        .solve();
  }

  Complex dsc;
  std::vector<Vertex_handle> free;
};

// If all cells have the same measure, linear functions are solutions.
TEST_F(Harmonic_extension, of_a_linear_motion_is_linear) {
  const auto motions = solve(1);
  ASSERT_EQ(motions.size(), free.size());
  for (std::size_t i = 0; i < free.size(); ++i)
    EXPECT_LT(std::sqrt((motions[i] - linear(free[i])).squared_length()), .04); // of 4
}

TEST_F(Harmonic_extension, is_the_same_bit_for_bit_with_any_number_of_threads) {
  mesh_helpers::jitter(dsc, .03, 5);
  ASSERT_GT(free.size(), 1200u); // enough nodes for several threads
  EXPECT_EQ(solve(3), solve(1));
}

} // namespace test_motion_of_space
