#include "../../../src/tetgen/child_process.h"
#include "test.h"

#include <CGAL/Complex_construction/Tetrahedralization_3.h>
#include <CGAL/Complex_construction/internal/building/Boxed_soup_3.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <thread>

namespace test_tetgen {

using CGAL::Tetgen_tetrahedralizer_3;
using CGAL::Deformable_simplicial_complexes::Error;
using CGAL::Deformable_simplicial_complexes::Tetrahedralization_error;
using CGAL::Deformable_simplicial_complexes::internal::Child_process;
using End = Child_process::End;
using Send = Child_process::Send;

constexpr double infinity = std::numeric_limits<double>::infinity();

bool has_children() { return waitpid(-1, nullptr, WNOHANG) != -1 || errno != ECHILD; }

Child_process::Outcome outcome(const Child_process::Function& function, double seconds = infinity) {
  Child_process child(function, seconds);
  char byte;
  EXPECT_FALSE(child.read(&byte, 1));
  const Child_process::Outcome result = child.wait();
  EXPECT_FALSE(has_children());
  return result;
}

void expect_crash(int signal, const Child_process::Function& function) {
  const Child_process::Outcome result = outcome(function);
  EXPECT_EQ(result.end, End::CRASHED);
  EXPECT_EQ(result.code, signal);
}

void expect_exit(int code, const Child_process::Function& function) {
  const Child_process::Outcome result = outcome(function);
  EXPECT_EQ(result.end, End::EXITED);
  EXPECT_EQ(result.code, code);
}

struct Exit_in_destructor
{
  ~Exit_in_destructor() { std::_Exit(42); }
};

TEST(Child_process, sends_more_than_a_pipe_holds) {
  const std::size_t size = 1000000;
  Child_process child(
      [&](const Send& send) {
        std::vector<std::size_t> numbers;
        for (std::size_t i = 0; i < size; ++i)
          numbers.push_back(i * i);
        send(&numbers[0], sizeof(numbers[0]));
        send(&numbers[1], (size - 1) * sizeof(numbers[0]));
      },
      infinity);
  for (std::size_t i = 0; i < size; ++i) {
    std::size_t number = 0;
    ASSERT_TRUE(child.read(&number, sizeof(number)));
    ASSERT_EQ(number, i * i);
  }
  char byte;
  EXPECT_FALSE(child.read(&byte, 1));
  const Child_process::Outcome result = child.wait();
  EXPECT_EQ(result.end, End::EXITED);
  EXPECT_EQ(result.code, 0);
  EXPECT_FALSE(has_children());
}

TEST(Child_process, exits_with_what_is_thrown) {
  expect_exit(0, [](const Send&) {});
  expect_exit(7, [](const Send&) { std::_Exit(7); });
  expect_exit(3, [](const Send&) { throw 3; });
  expect_exit(3, [](const Send&) {
    const Exit_in_destructor is_not_destroyed;
    throw 3;
  });
}

TEST(Child_process, crashes_alone) {
  expect_crash(SIGABRT, [](const Send&) { std::abort(); });
  expect_crash(SIGABRT, [](const Send&) { throw std::runtime_error("nobody catches this"); });
  expect_crash(SIGSEGV, [](const Send&) { raise(SIGSEGV); });
}

TEST(Child_process, crashes_after_it_sent_something) {
  Child_process child(
      [](const Send& send) {
        send("ab", 2);
        std::abort();
      },
      infinity);
  char bytes[3];
  EXPECT_FALSE(child.read(bytes, 3));
  EXPECT_EQ(child.wait().end, End::CRASHED);
}

TEST(Child_process, is_killed_when_time_is_up) {
  const auto loop = [](const Send&) {
    for (volatile int i = 0;; i = i + 1) {
    }
  };
  EXPECT_EQ(outcome(loop, .05).end, End::TIMED_OUT);
  EXPECT_EQ(outcome(loop, 0).end, End::TIMED_OUT);
  EXPECT_EQ(Child_process(loop, infinity, .5).wait().end, End::TIMED_OUT);
}

TEST(Child_process, is_killed_when_nobody_waits) {
  {
    const Child_process child([](const Send&) { pause(); }, infinity);
  }
  EXPECT_FALSE(has_children());
}

TEST(Child_process, ends_when_nobody_listens) {
  Child_process child(
      [](const Send& send) {
        const std::vector<char> zeros(1000000);
        send(zeros.data(), zeros.size());
      },
      infinity);
  EXPECT_EQ(child.wait().end, End::CRASHED);
}

TEST(Child_process, prints_nothing) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  expect_crash(SIGABRT, [](const Send&) {
    std::puts("to the standard output");
    std::fflush(stdout);
    std::fputs("to the standard error", stderr);
    std::abort();
  });
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Child_process, leaves_handlers_of_signals_to_the_caller) {
  const auto old = std::signal(SIGINT, [](int) { std::_Exit(42); });
  expect_exit(0, [](const Send&) { raise(SIGINT); });
  std::signal(SIGINT, old);
}

// The child process of a killed caller keeps one end of `pipe` open until the child ends.
TEST(Child_process, ends_when_the_caller_is_killed) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const pid_t caller = fork();
  if (caller == 0) {
    const Child_process child(
        [](const Send&) {
          for (volatile int i = 0;; i = i + 1) {
          }
        },
        infinity);
    raise(SIGKILL);
  }
  close(ends[1]);
  EXPECT_EQ(waitpid(caller, nullptr, 0), caller);
  char byte;
  EXPECT_EQ(read(ends[0], &byte, 1), 0);
  close(ends[0]);
}

TEST(Child_process, runs_next_to_others) {
  std::vector<std::thread> threads;
  std::vector<int> numbers(8, -1);
  for (int i = 0; i < 8; ++i)
    threads.emplace_back([i, &numbers] {
      Child_process child([i](const Send& send) { send(&i, sizeof(i)); }, infinity);
      EXPECT_TRUE(child.read(&numbers[i], sizeof(int)));
      EXPECT_EQ(child.wait().code, 0);
    });
  for (std::thread& thread : threads)
    thread.join();
  EXPECT_EQ(numbers, std::vector<int>({0, 1, 2, 3, 4, 5, 6, 7}));
}

using CGAL::Deformable_simplicial_complexes::internal::Triangle_soup_3;

// The sides of a cube, subdivided finely enough that TetGen adds points inside.
const Triangle_soup_3 cube = CGAL::Deformable_simplicial_complexes::internal::box_surface(
    CGAL::Bbox_3(-1, -1, -1, 1, 1, 1), 6);

DSC::Tetrahedralization_3 fill(const Tetgen_tetrahedralizer_3& tetrahedralizer,
                               const Triangle_soup_3& soup) {
  return tetrahedralizer(soup.points, soup.triangles);
}

std::string failure(const Tetgen_tetrahedralizer_3& tetrahedralizer, const Triangle_soup_3& soup) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  std::string message;
  try {
    fill(tetrahedralizer, soup);
  } catch (const Tetrahedralization_error& e) {
    message = e.what();
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_FALSE(has_children());
  return message;
}

TEST(Tetgen, puts_the_input_first) {
  const auto mesh = fill(Tetgen_tetrahedralizer_3(), cube);
  ASSERT_GT(mesh.points.size(), cube.points.size());
  EXPECT_TRUE(std::equal(cube.points.begin(), cube.points.end(), mesh.points.begin()));
  EXPECT_FALSE(has_children());
}

// A torus around the z axis, with n triangles around its tube for each 2 around the axis.
Triangle_soup_3 torus(std::size_t n) {
  Triangle_soup_3 result;
  for (std::size_t i = 0; i < 2 * n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const double u = CGAL_PI * double(i) / double(n), v = 2 * CGAL_PI * double(j) / double(n);
      const double r = 1 + .4 * std::cos(v);
      result.points.push_back({r * std::cos(u), r * std::sin(u), .4 * std::sin(v)});
      const std::size_t next_i = (i + 1) % (2 * n), next_j = (j + 1) % n;
      result.triangles.push_back({i * n + j, next_i * n + j, next_i * n + next_j});
      result.triangles.push_back({i * n + j, next_i * n + next_j, i * n + next_j});
    }
  return result;
}

double volume(const std::vector<std::array<double, 3>>& points,
              const std::array<std::size_t, 4>& v) {
  const auto point = [&](std::size_t i) { return DSC::internal::exact_point(points[v[i]]); };
  return CGAL::volume(point(0), point(1), point(2), point(3));
}

// Many triangles are filled with points of an octree. Those outside the surface, which is not
// convex, are left out.
TEST(Tetgen, adds_points_inside_surfaces_of_many_triangles) {
  const Triangle_soup_3 soup = torus(40);
  ASSERT_GE(soup.triangles.size(), 5000u);
  const auto mesh = Tetgen_tetrahedralizer_3()(soup.points, soup.triangles);
  ASSERT_GT(mesh.points.size(), soup.points.size());
  EXPECT_TRUE(std::equal(soup.points.begin(), soup.points.end(), mesh.points.begin()));
  std::vector<char> is_used(mesh.points.size(), 0);
  double inside = 0, of_surface = 0;
  for (const auto& t : mesh.tetrahedra) {
    inside += volume(mesh.points, t);
    for (const std::size_t v : t)
      is_used[v] = 1;
  }
  EXPECT_EQ(std::count(is_used.begin(), is_used.end(), 0), 0);
  std::vector<std::array<double, 3>> with_origin = soup.points;
  with_origin.push_back({0, 0, 0});
  for (const auto& t : soup.triangles)
    of_surface += volume(with_origin, {soup.points.size(), t[0], t[1], t[2]});
  EXPECT_NEAR(inside, std::abs(of_surface), 1e-9);
  // The bounds would give 2.5 tetrahedra for each triangle.
  EXPECT_LT(mesh.tetrahedra.size(), 2 * soup.triangles.size());
  // Bounds on volumes are kept.
  const auto fine = Tetgen_tetrahedralizer_3(2.5, 10, 1e-3)(soup.points, soup.triangles);
  for (const auto& t : fine.tetrahedra)
    EXPECT_LE(volume(fine.points, t), 1e-3);
}

// With the sanitizer, a lock of the allocator may be held forever in the child of a process with
// threads. The system allocator has no such problem. test/installed_package tests threads, too.
#ifndef __SANITIZE_ADDRESS__
TEST(Tetgen, several_threads_get_the_same) {
  const auto expected = fill(Tetgen_tetrahedralizer_3(), cube);
  std::vector<DSC::Tetrahedralization_3> meshes(4);
  std::vector<std::thread> threads;
  for (auto& mesh : meshes)
    threads.emplace_back([&] { mesh = fill(Tetgen_tetrahedralizer_3(), cube); });
  for (std::thread& thread : threads)
    thread.join();
  for (const auto& mesh : meshes) {
    EXPECT_EQ(mesh.points, expected.points);
    EXPECT_EQ(mesh.tetrahedra, expected.tetrahedra);
  }
}
#endif

TEST(Tetgen, says_what_is_wrong_with_the_input) {
  Triangle_soup_3 soup = cube;
  soup.triangles.push_back(soup.triangles[0]);
  EXPECT_EQ(failure(Tetgen_tetrahedralizer_3(), soup),
            "TetGen failed with code 3, triangles intersect, or nearly do: separate surfaces that "
            "are very close");
}

TEST(Tetgen, has_a_time_limit) {
  const Tetgen_tetrahedralizer_3 tetrahedralizer(2.5, 10, infinity, 1e-6);
  EXPECT_EQ(tetrahedralizer.time_limit(), 1e-6);
  EXPECT_EQ(failure(tetrahedralizer, cube),
            "TetGen reached its time limit: use a longer time limit, larger bounds for the "
            "tetrahedra or a coarser surface");
  EXPECT_THROW(Tetgen_tetrahedralizer_3(2.5, 10, infinity, 0), Error);
  EXPECT_THROW(Tetgen_tetrahedralizer_3(2.5, 10, infinity, std::nan("")), Error);
}

// The bounds would need a billion tetrahedra, which exceeds the time limit. So TetGen runs without
// the bounds in the last third of the time.
TEST(Tetgen, does_without_bounds_after_two_thirds_of_the_time) {
  const auto mesh = fill(Tetgen_tetrahedralizer_3(2.5, 10, 1e-9, 3), cube);
  EXPECT_LT(mesh.tetrahedra.size(), 100000u);
}

} // namespace test_tetgen
