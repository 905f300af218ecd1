// Reconstruction of solids from points, by the program.
#include "program.h"
#include "test.h"

#include <cstdio>

namespace {

using namespace program;

// Points of the unit sphere along a spiral.
std::string sphere(int n) {
  std::ostringstream out;
  for (int i = 0; i < n; ++i) {
    const double z = 1 - (2 * i + 1.) / n, r = std::sqrt(1 - z * z), a = 2.399963229728653 * i;
    out << r * std::cos(a) << ' ' << r * std::sin(a) << ' ' << z << '\n';
  }
  return out.str();
}

using Reconstruction = program::Program_test;

} // namespace

TEST_F(Reconstruction, writes_surface_report_and_steps) {
  write("sphere.xyz", sphere(800));
  const std::string command = "reconstruct " + path("sphere.xyz").string() + " -o " +
                              path("sphere.off").string() + " --output " + path("steps").string();
  const Outcome outcome = run(command + " --report " + path("report.json").string());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_PRED2(contains, outcome.out, "Euler characteristic 2");
  const Json report = Json::parse(contents(path("report.json")));
  EXPECT_EQ(report["points"], 800);
  EXPECT_TRUE(report["is_complete"]);
  EXPECT_TRUE(report["unfit_points"].empty());
  EXPECT_LT(report["root_mean_square"].get<double>(), .1 * report["spacing"].get<double>());
  const std::size_t steps = report["steps"];
  EXPECT_TRUE(fs::exists(path("steps/interface.pvd")));
  char last[40];
  std::snprintf(last, sizeof last, "steps/volume_%06zu.vtu", steps);
  EXPECT_TRUE(fs::exists(path(last)));
  const Outcome info = run("info " + path("sphere.off").string());
  EXPECT_PRED2(contains, info.out, "Euler characteristic  2");
  // Steps of another run are not overwritten.
  EXPECT_EQ(run(command).exit_code, 1);
}

TEST_F(Reconstruction, tells_outliers_and_refuses_open_sheets) {
  write("sphere.xyz", sphere(800) + "5 5 5\n");
  const Outcome outcome =
      run("reconstruct " + path("sphere.xyz").string() + " -o " + path("sphere.off").string());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_PRED2(contains, outcome.out, "1 outlier,");
  std::ostringstream hills;
  for (int i = 0; i < 900; ++i)
    hills << i % 30 << ' ' << i / 30 << ' ' << 2 * std::sin(.2 * (i % 30)) * std::cos(.2 * (i / 30))
          << '\n';
  write("hills.xyz", hills.str());
  const std::string command =
      "reconstruct " + path("hills.xyz").string() + " -o " + path("hills.off").string();
  const Outcome refused = run(command);
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_PRED2(contains, refused.err, "open sheet");
  const Outcome opened = run(command + " --open --report " + path("report.json").string());
  EXPECT_EQ(opened.exit_code, 0) << opened.err;
  EXPECT_PRED2(contains, opened.out,
               "900 points, 0 outliers, 1682 triangles, 1 component, Euler characteristic 1, 1 "
               "boundary");
  const Json report = Json::parse(contents(path("report.json")));
  EXPECT_TRUE(report["is_complete"]);
  EXPECT_EQ(report["boundaries"], 1);
  const Outcome info = run("info " + path("hills.off").string());
  EXPECT_PRED2(contains, info.out + info.err, "1682");
  for (const std::string option : {"--picture a.png", "--steps 3", "--tolerance 1", "--output a"})
    EXPECT_EQ(run(command + " --open " + option).exit_code, 2) << option;
}

TEST_F(Reconstruction, tells_where_a_result_is_not_complete) {
  write("sphere.xyz", sphere(800));
  const std::string off = " -o " + path("a.off").string();
  const Outcome moving = run("reconstruct --steps 1 " + path("sphere.xyz").string() + off);
  EXPECT_EQ(moving.exit_code, 1);
  EXPECT_PRED2(contains, moving.err, "not complete: the surface still moves after 1 step");
  EXPECT_TRUE(fs::exists(path("a.off")));
  // Two planes that cross each other are no manifold.
  std::ostringstream planes;
  for (int i = 0; i < 900; ++i)
    planes << i % 30 << ' ' << i / 30 << " 14.5\n" << i % 30 << " 14.5 " << i / 30 << '\n';
  write("planes.xyz", planes.str());
  const Outcome crossing = run("reconstruct --open --quiet " + path("planes.xyz").string() + off);
  EXPECT_EQ(crossing.exit_code, 1);
  EXPECT_PRED2(contains, crossing.err, "not complete: the sheet contradicts the points at");
}

TEST_F(Reconstruction, refuses_points_that_bound_nothing) {
  write("plane.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 1 0\n");
  const std::string plane = path("plane.xyz").string(), off = " -o " + path("a.off").string();
  const auto expect = [&](const std::string& arguments, int code, const std::string& text) {
    const Outcome outcome = run("reconstruct " + arguments);
    EXPECT_EQ(outcome.exit_code, code);
    EXPECT_PRED2(contains, outcome.err, text);
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
  };
  expect(plane + off, 1, "lie in a plane");
  expect(path("missing.xyz").string() + off, 1, "missing.xyz");
  expect(plane + " -o " + path("a.jpg").string(), 2, "jpg");
  expect(plane, 2, "-o");
  expect(plane + off + " --tolerance 0", 2, "tolerance");
}
