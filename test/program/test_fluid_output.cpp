// Output files, probes of points and pictures of fluids by the program, in the plane and in space.
#include "fluid_program.h"
#include "test.h"

#include <CGAL/Mesh_files/internal/grids/Vtu_reader.h>

namespace {

using CGAL::Deformable_simplicial_complexes::internal::Vtu_reader;
using namespace program;

// A ball that rotates about the z-axis with angular velocity 1.
Json rotating_ball(int dimension) {
  Json json = Json::parse(R"json({
    "title": "a test", "edge": 0.6, "surface_tension": 1, "time_step": 0.05, "end": 0.05,
    "liquids": [{"shape": {"type": "ball", "radius": 1}, "density": 1}],
    "probes": [{"name": "inside"}, {"name": "outside"}]
  })json");
  const bool is_plane = dimension == 2;
  json["domain"] = Json::parse(is_plane ? "[-2,-2,2,2]" : "[-2,-2,-2,2,2,2]");
  json["liquids"][0]["shape"]["center"] = Json::parse(is_plane ? "[0,0]" : "[0,0,0]");
  json["liquids"][0]["velocity"] = is_plane ? "-y,x" : "-y,x,0";
  json["probes"][0]["at"] = Json::parse(is_plane ? "[0.1,0.2]" : "[0.1,0.2,0.3]");
  json["probes"][1]["at"] = Json::parse(is_plane ? "[1.9,0]" : "[1.9,0,0]");
  return json;
}

// A pool of depth 0.5 at rest.
Json pool(int dimension) {
  Json json = Json::parse(R"json({
    "title": "a test", "edge": 0.25, "time_step": 0.1, "end": 0.1,
    "liquids": [{"shape": {"type": "pool", "level": 0.5}, "density": 2}],
    "probes": [{"name": "deep"}, {"name": "above"}]
  })json");
  const bool is_plane = dimension == 2;
  json["domain"] = Json::parse(is_plane ? "[0,0,1,1]" : "[0,0,0,1,0.5,1]");
  json["gravity"] = Json::parse(is_plane ? "[0,-3]" : "[0,0,-3]");
  json["probes"][0]["at"] = Json::parse(is_plane ? "[0.6,0.2]" : "[0.6,0.3,0.2]");
  json["probes"][1]["at"] = Json::parse(is_plane ? "[0.6,0.9]" : "[0.6,0.3,0.9]");
  return json;
}

// The parameter is the dimension.
class Fluid_output : public program::Fluid_program_test, public testing::WithParamInterface<int>
{
protected:
  std::size_t corners() const { return std::size_t(GetParam()) + 1; }
};

INSTANTIATE_TEST_SUITE_P(Dimension, Fluid_output, testing::Values(2, 3));

class Fluid_output_3 : public program::Fluid_program_test
{
};

} // namespace

TEST_P(Fluid_output, has_fields_of_cells) {
  const Outcome outcome = run("fluid " + write_scene(rotating_ball(GetParam())) + " --output out");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Vtu_reader first(path("out/volume_000000.vtu").string());
  const std::size_t n = first.number_of_cells(), components = GetParam() == 2 ? 1 : 3;
  const auto labels = first.array("CellData", "label", n);
  const auto component = first.array("CellData", "component", n);
  const auto vorticity = first.array("CellData", "vorticity", n, components);
  const auto velocity = first.array("CellData", "velocity", n, 3);
  const auto vertices = first.array("Cells", "connectivity", corners() * n);
  const auto points = first.array("Points", "", first.number_of_points(), 3);
  EXPECT_EQ(first.array("PointData", "velocity", first.number_of_points(), 3).size(),
            points.size());
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_EQ(component[i] == component[0], labels[i] == labels[0]);
    EXPECT_NEAR(vorticity[components * i + components - 1], labels[i] == 1 ? 2 : 0, 1e-9);
    double x = 0; // of the barycenter
    for (std::size_t k = 0; k < corners(); ++k)
      x += points[3 * std::size_t(vertices[corners() * i + k])] / double(corners());
    EXPECT_NEAR(velocity[3 * i + 1], labels[i] == 1 ? x : 0, 1e-9);
  }

  // After a step, the pressure balances the surface tension.
  const Vtu_reader second(path("out/volume_000001.vtu").string());
  const auto pressure = second.array("CellData", "pressure", second.number_of_cells());
  const auto new_labels = second.array("CellData", "label", second.number_of_cells());
  for (std::size_t i = 0; i < pressure.size(); ++i)
    if (new_labels[i] == 1)
      EXPECT_GT(pressure[i], 0);
    else
      EXPECT_EQ(pressure[i], 0);
}

TEST_P(Fluid_output, has_fields_of_both_sides_of_the_interface) {
  const Outcome outcome = run("fluid " + write_scene(rotating_ball(GetParam())) + " --output out");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Vtu_reader vtu(path("out/interface_000001.vtu").string());
  const std::size_t n = vtu.number_of_cells();
  const auto pairs = vtu.array("CellData", "label_pair", n, 2);
  const auto back = vtu.array("CellData", "pressure_back", n);
  const auto front = vtu.array("CellData", "pressure_front", n);
  const auto velocity = vtu.array("PointData", "velocity", vtu.number_of_points(), 3);
  const auto of_back = vtu.array("CellData", "velocity_back", n, 3);
  const auto of_front = vtu.array("CellData", "velocity_front", n, 3);
  const std::size_t d = corners() - 1;
  const auto vertices = vtu.array("Cells", "connectivity", d * n);
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_EQ(pairs[2 * i], 1);
    EXPECT_GT(back[i], 0);
    EXPECT_EQ(front[i], 0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double mean = 0;
      for (std::size_t k = 0; k < d; ++k)
        mean += velocity[3 * std::size_t(vertices[d * i + k]) + axis] / double(d);
      EXPECT_NEAR(of_back[3 * i + axis], mean, 1e-12); // there is one liquid only
      EXPECT_EQ(of_front[3 * i + axis], 0);
    }
  }
}

TEST_P(Fluid_output, is_probed_at_points) {
  const Json of_ball = steps_of(rotating_ball(GetParam())), of_pool = steps_of(pool(GetParam()));
  ASSERT_EQ(of_ball.size(), 2u);
  ASSERT_EQ(of_pool.size(), 2u);
  const Json &at_start = of_ball[0].at("probes"), &at_end = of_pool[1].at("probes");
  EXPECT_EQ(at_start.at("inside").at("label"), 1);
  EXPECT_EQ(at_start.at("outside").at("label"), 0);
  EXPECT_TRUE(at_start.at("outside").at("pressure").is_null());
  EXPECT_TRUE(at_start.at("outside").at("velocity").is_null());
  const auto velocity = at_start.at("inside").at("velocity").get<std::vector<double>>();
  ASSERT_EQ(velocity.size(), 3u);
  EXPECT_NEAR(velocity[0], -.2, 1e-9);
  EXPECT_NEAR(velocity[1], .1, 1e-9);
  EXPECT_NEAR(velocity[2], 0, 1e-9);

  EXPECT_NEAR(at_end.at("deep").at("pressure").get<double>(), 2 * 3 * .3, 1e-6); // hydrostatic
  EXPECT_TRUE(at_end.at("above").at("pressure").is_null());

  Json json = pool(GetParam());
  json["probes"][0]["at"][0] = 1.1;
  expect_refusal(json, "outside the domain");
  json["probes"][0]["at"] = .5;
  expect_refusal(json, "at");
  json = pool(GetParam());
  json["probes"][0]["mode"] = 2;
  expect_refusal(json, "'at'");
}

// The height of a pool is a function, and its wave falls at its crest.
TEST_P(Fluid_output, is_probed_at_heights) {
  const bool is_plane = GetParam() == 2;
  Json json = pool(GetParam());
  json["edge"] = is_plane ? .1 : .25;
  json["liquids"][0]["shape"]["height"] = "0.5+0.02*cos(pi*x)";
  json["probes"] = {{{"name", "left"}, {"height_at", Json::parse(is_plane ? "0" : "[0,0.25]")}}};
  json["end"] = .3;
  json["interface_tolerance"] = 0;
  const Json steps = steps_of(json);
  ASSERT_EQ(steps.size(), 4u);
  EXPECT_NEAR(steps[0].at("probes").at("left").get<double>(), .52, 1e-12);
  EXPECT_LT(steps[3].at("probes").at("left").get<double>(), .52);
  EXPECT_NEAR(steps[3].at("volume").get<double>(), steps[0].at("volume").get<double>(), 1e-12);
}

// A linear function of the points is the same function of the points of the smooth surface.
TEST_F(Fluid_output_3, of_smooth_surfaces_has_velocities) {
  const Outcome outcome =
      run("fluid " + write_scene(rotating_ball(3)) + " --steps 1 --subdivide 1 --output out");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::istringstream file(contents(path("out/smooth_000000.ply")));
  std::string line, header;
  std::size_t n = 0;
  while (std::getline(file, line) && line != "end_header") {
    header += line + '\n';
    std::sscanf(line.c_str(), "element vertex %zu", &n);
  }
  EXPECT_PRED2(contains, header, "property float vx\nproperty float vy\nproperty float vz\n");
  EXPECT_GT(n, 100u);
  for (std::size_t i = 0; i < n; ++i) {
    std::array<double, 6> row; // point and velocity
    for (double& x : row)
      ASSERT_TRUE(file >> x);
    EXPECT_NEAR(row[3], -row[1], 1e-6);
    EXPECT_NEAR(row[4], row[0], 1e-6);
    EXPECT_NEAR(row[5], 0, 1e-6);
  }
}

TEST_P(Fluid_output, is_drawn_by_colors) {
  const bool is_plane = GetParam() == 2;
  Json warm = rotating_ball(GetParam());
  warm["field"] = {{"initial", "x"}};
  const std::string fluid = "fluid " + write_scene(warm) + " --picture ",
                    picture = is_plane ? "a.svg" : "a.png", cut = is_plane ? "" : " --cut z=0";
  for (const std::string quantity : {"field", "pressure", "velocity", "vorticity"}) {
    const Outcome outcome = run(fluid + picture + cut + " --color " + quantity);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_PRED2(contains, outcome.out, ", " + quantity + " from ");
    EXPECT_PRED2(contains, contents(path(picture)), is_plane ? "color_ffffff" : "PNG");
    EXPECT_GT(contents(path(picture)).size(), 1000u);
  }
  EXPECT_EQ(run(fluid + picture + cut + " --color heat").exit_code, 2);
  write_scene(rotating_ball(GetParam()));
  const Outcome cold = run(fluid + picture + cut + " --color field");
  EXPECT_EQ(cold.exit_code, 2);
  EXPECT_PRED2(contains, cold.err, "only to a scene with a field");
}

TEST_F(Fluid_output_3, is_drawn_in_a_cut) {
  const std::string space = "fluid " + write_scene(rotating_ball(3));
  const Outcome outcome = run(space + " --picture a.png --cut x=0.1");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(contents(path("a.png")).substr(1, 3), "PNG");
  for (const std::string options :
       {" --picture a.png --cut w=1", " --picture a.png --cut x", " --picture a.png --cut x=1y",
        " --picture a.png --cut x=2.5", " --picture a.png --cut x=-2", " --cut x=0.1",
        " --picture a.png --color pressure"})
    EXPECT_EQ(run(space + options).exit_code, 2) << options;
  // A cut is checked first, before the cells of the scene.
  Json broken = rotating_ball(3);
  broken["liquids"].push_back(broken["liquids"][0]);
  broken["liquids"][0]["shape"]["center"] = {99, 99, 99};
  EXPECT_PRED2(contains, run("fluid " + write_scene(broken) + " --picture a.png --cut x=2.5").err,
               "--cut is outside the domain");
  const std::string plane = "fluid " + write_scene(rotating_ball(2));
  EXPECT_PRED2(contains, run(plane + " --picture a.svg --cut x=0").err, "only in space");
}
