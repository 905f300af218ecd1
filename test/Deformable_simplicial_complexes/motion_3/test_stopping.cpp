#include "mesh_helpers.h"
#include "test.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/interface_flows_3.h>
#include <CGAL/Interface_remeshing/improve_interface.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>
#include <CGAL/Mesh_support/Progress_scope.h>

namespace test_stopping {

using CGAL::Deformable_simplicial_complexes::Interrupted_error;
using CGAL::Deformable_simplicial_complexes::Progress_phase;
using CGAL::Deformable_simplicial_complexes::Progress_scope;
using small_meshes::Complex;

constexpr std::chrono::milliseconds at_each_check(0);

// Counts how often a function asks whether to continue.
std::size_t number_of_checks(const std::function<void()>& f) {
  std::size_t number = 0;
  const Progress_scope scope([&](const char*) { return ++number > 0; }, at_each_check);
  f();
  return number;
}

// Calls `f(complex)` repeatedly and interrupts it at a later check each time. After each
// interruption, the complex is valid and can be used further.
template <class F> void expect_valid_wherever_stopped(const Complex& start, const F& f) {
  const auto state = start.state();
  Complex dsc;
  dsc.restore(state);
  const std::size_t all = number_of_checks([&] { f(dsc); });
  const auto whole = dsc.state();
  ASSERT_GT(all, 10u);
  static constexpr std::size_t samples = 40;
  for (std::size_t i = 0; i < samples; ++i) {
    dsc.restore(state);
    std::size_t left = 1 + i * (all - 1) / (samples - 1);
    {
      const Progress_scope scope([&](const char*) { return --left > 0; }, at_each_check);
      EXPECT_THROW(f(dsc), Interrupted_error);
    }
    ASSERT_TRUE(dsc.is_valid()) << "stopped at check " << i;
    f(dsc);
    ASSERT_TRUE(dsc.is_valid());
  }
  // Interrupted calls leave no data outside the complex that changes later calls.
  dsc.restore(state);
  f(dsc);
  EXPECT_EQ(dsc.state().points, whole.points);
}

TEST(Stopping, a_motion_leaves_a_valid_complex) {
  expect_valid_wherever_stopped(mesh_helpers::sphere(8, .6), [](Complex& dsc) {
    DSC::advect_interface(dsc, DSC::Normal_offset{-.3}, 0., 1.);
  });
}

TEST(Stopping, improvement_leaves_a_valid_complex) {
  const Complex start = mesh_helpers::jittered_grid(4, small_meshes::cube, .3, 1);
  expect_valid_wherever_stopped(start, [](Complex& dsc) { DSC::improve_mesh(dsc); });
  expect_valid_wherever_stopped(start, [](Complex& dsc) { DSC::improve_interface(dsc); });
}

TEST(Stopping, restoring_leaves_a_valid_complex) {
  const Complex dsc = mesh_helpers::sphere(6, .6);
  const auto state = dsc.state();
  expect_valid_wherever_stopped(dsc, [&](Complex& c) { c.restore(state); });
}

TEST(Stopping, building_makes_nothing) {
  const auto build = [] {
    DSC::make_deformable_simplicial_complex_3<Complex>(
        CGAL::Bbox_3(-1, -1, -1, 1, 1, 1), .25,
        [](const auto& p) { return (p - CGAL::ORIGIN).squared_length() < .5; });
  };
  const std::size_t all = number_of_checks(build);
  for (const std::size_t stop : {std::size_t(1), all / 3, all / 2, all - 1}) {
    std::size_t left = stop;
    const Progress_scope scope([&](const char*) { return --left > 0; }, at_each_check);
    EXPECT_THROW(build(), Interrupted_error);
  }
}

TEST(Stopping, phases_have_names) {
  std::set<std::string> phases;
  const Progress_scope scope(
      [&](const char* phase) {
        phases.insert(phase);
        return true;
      },
      at_each_check);
  Complex dsc = mesh_helpers::sphere(8, .6);
  DSC::advect_interface(dsc, DSC::Normal_offset{.1}, 0., 1.);
  DSC::improve_mesh(dsc);
  for (const char* phase : {"assembling the mesh", "moving the interface", "improving the mesh"})
    EXPECT_EQ(phases.count(phase), 1u) << phase;
}

// If a phase is interrupted at its beginning, the outer phase is the current one again.
TEST(Stopping, phases_end_where_they_are_stopped) {
  std::string last;
  bool goes_on = true;
  const Progress_scope scope(
      [&](const char* phase) {
        last = phase;
        return goes_on;
      },
      at_each_check);
  const Progress_phase outer("outer");
  goes_on = false;
  EXPECT_THROW(Progress_phase("inner"), Interrupted_error);
  EXPECT_EQ(last, "inner");
  goes_on = true;
  Progress_scope::check();
  EXPECT_EQ(last, "outer");
}

TEST(Stopping, all_scopes_of_the_thread_are_asked) {
  int outer = 0, inner = 0;
  const Progress_scope first([&](const char*) { return ++outer < 2; }, at_each_check);
  {
    const Progress_scope second([&](const char*) { return ++inner > 0; }, at_each_check);
    Progress_scope::check();
    EXPECT_THROW(Progress_scope::check(), Interrupted_error);
  }
  EXPECT_EQ(outer, 2);
  EXPECT_EQ(inner, 2);
}

TEST(Stopping, callbacks_may_call_functions_that_ask) {
  const Complex dsc = mesh_helpers::sphere(6, .6);
  std::size_t number = 0;
  const Progress_scope scope([&](const char*) { return ++number > 0 && dsc.is_valid(); },
                             at_each_check);
  Progress_scope::check();
  EXPECT_EQ(number, 1);
  Progress_scope::check();
  EXPECT_EQ(number, 2);
}

TEST(Stopping, without_a_scope_nothing_is_asked) { EXPECT_NO_THROW(Progress_scope::check()); }

} // namespace test_stopping
