// Fluids in the plane by the program.
#include "fluid_program.h"
#include "test.h"

namespace {

using namespace program;

// A disk that falls onto a floor.
Json scene() {
  return Json::parse(R"json({
    "title": "a test",
    "domain": [-2.5, -2.5, 2.5, 2.5],
    "edge": 0.3,
    "liquids": [{"shape": {"type": "ball", "center": [0, 0], "radius": 1}, "density": 1,
                 "velocity": [0, -1]}],
    "surface_tension": 1,
    "gravity": [0, -1],
    "solids": [{"type": "plane", "point": [0, -1.1], "normal": [0, 1]}],
    "probes": [{"name": "mode", "mode": 2, "center": [0, 0]}, {"name": "top", "height_at": 0.05},
               {"name": "circularity", "circularity_of": 1}, {"name": "center", "centroid_of": 1},
               {"name": "velocity", "velocity_of": 1}],
    "time_step": 0.05,
    "end": 0.4
  })json");
}

class Planar_fluids : public program::Fluid_program_test
{
};

} // namespace

TEST_F(Planar_fluids, droplet_falls_onto_a_floor) {
  const Json steps = steps_of(scene());
  ASSERT_EQ(steps.size(), 9u);
  const double area = steps[0].at("volume"), mass = area;
  EXPECT_NEAR(area, M_PI, 1e-9); // of the disk
  for (const Json& step : steps) {
    EXPECT_NEAR(step.at("volume").get<double>(), area, 1e-10 * area);
    EXPECT_GT(step.at("triangles").get<int>(), step.at("interface_edges").get<int>());
    EXPECT_FALSE(step.contains("tetrahedra"));
    EXPECT_EQ(step.at("momentum").size(), 3u);
    EXPECT_TRUE(step.at("probes").at("mode").is_number());
    EXPECT_GT(step.at("probes").at("top").get<double>(), 0);
    const double circularity = step.at("probes").at("circularity");
    EXPECT_GT(circularity, .8);
    EXPECT_LT(circularity, 1);
  }
  // Free fall for one step, then stopped by the floor.
  EXPECT_NEAR(steps[1].at("momentum")[1].get<double>(), -1.05 * mass, 1e-9 * mass);
  EXPECT_NEAR(steps[1].at("probes").at("velocity")[1].get<double>(), -1.05, 1e-9);
  EXPECT_NEAR(steps[0].at("probes").at("center")[1].get<double>(), 0, 1e-9);
  EXPECT_LT(steps[1].at("probes").at("center")[1].get<double>(), -.05);
  EXPECT_GT(steps[8].at("contacts").get<int>(), 0);
  EXPECT_LT(steps[8].at("forces_on_solids")[0][1].get<double>(), 0);
  EXPECT_LE(steps[8].at("depth_in_solids").get<double>(), 1e-6);
}

TEST_F(Planar_fluids, run_is_resumed_to_the_same_bits) {
  const std::string file = write_scene(scene());
  ASSERT_EQ(run("fluid " + file + " --output " + path("whole").string() + " --threads 1").exit_code,
            0);
  const std::string parts = path("parts").string();
  ASSERT_EQ(run("fluid " + file + " --steps 4 --output " + parts).exit_code, 0);
  const Outcome rest =
      run("fluid --resume " + parts + "/checkpoint.dsc --output " + parts + " --threads 2");
  ASSERT_EQ(rest.exit_code, 0) << rest.err;
  EXPECT_EQ(contents(path("parts/checkpoint.dsc")), contents(path("whole/checkpoint.dsc")));
  EXPECT_EQ(contents(path("parts/volume_000008.vtu")), contents(path("whole/volume_000008.vtu")));
  EXPECT_PRED2(contains, contents(path("parts/volume_000008.vtu")), "Name=\"velocity\"");
  EXPECT_PRED2(contains, contents(path("parts/volume_000008.vtu")), "Name=\"pressure\"");
  EXPECT_TRUE(fs::exists(path("parts/picture_000008.svg")));
}

TEST_F(Planar_fluids, touching_boxes_are_one_component) {
  Json json = scene();
  json["liquids"] = Json::parse(R"json([
    {"shape": {"type": "box", "from": [-1, -1], "to": [1, 0]}, "label": 1, "density": 1},
    {"shape": {"type": "box", "from": [-1, 0], "to": [-0.35, 1]}, "label": 1, "density": 1},
    {"shape": {"type": "box", "from": [0.5, 0], "to": [1, 0.5]}, "label": 1, "density": 1},
    {"shape": {"type": "box", "from": [-0.35, 0], "to": [0.5, 0.5]}, "label": 2, "density": 2}
  ])json");
  const Json steps = steps_of(json, "--steps 1");
  ASSERT_EQ(steps.size(), 2u);
  ASSERT_EQ(steps[0].at("parts").size(), 2u);
  EXPECT_NEAR(steps[0].at("volume").get<double>(), 2 + .65 + .25 + .425, 1e-12);
  // Beside a pool, the boxes are cut out of a grid.
  json["liquids"] = Json::parse(R"json([
    {"shape": {"type": "pool", "level": -0.5}, "label": 1, "density": 1},
    {"shape": {"type": "box", "from": [-1, -0.5], "to": [0, 1]}, "label": 1, "density": 1},
    {"shape": {"type": "box", "from": [0, -0.5], "to": [1, 1]}, "label": 1, "density": 1}
  ])json");
  json.erase("solids");
  const Json beside_pool = steps_of(json, "--steps 1");
  ASSERT_EQ(beside_pool.size(), 2u);
  EXPECT_EQ(beside_pool[0].at("parts").size(), 1u);
  EXPECT_NEAR(beside_pool[0].at("volume").get<double>(), 10 + 3, .3);
}

TEST_F(Planar_fluids, file_is_fitted_into_a_disk) {
  write("square.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))");
  Json json = scene();
  json["liquids"][0]["shape"] = Json::parse(
      R"json({"type": "file", "file": "square.wkt", "center": [0, 0], "radius": 1})json");
  const Json steps = steps_of(json, "--steps 1 --data " + path("").string());
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_NEAR(steps[0].at("volume").get<double>(), 2, 1e-9);
  EXPECT_GE(steps[0].at("interface_edges").get<int>(), 20);
}

// Two liquids in a box are dragged by the upper side.
TEST_F(Planar_fluids, stick_to_sides) {
  Json json = Json::parse(R"json({
    "domain": [0, 0, 1, 1], "edge": 0.25,
    "liquids": [{"shape": {"type": "pool", "level": 0.5}, "density": 1},
                {"shape": {"type": "surroundings"}, "density": 1}],
    "sides": {"y+": [1, 0]}, "time_step": 0.02, "end": 0.04
  })json");
  EXPECT_GT(steps_of(json).back().at("kinetic_energy").get<double>(), 1e-3);
  json["sides"]["y+"] = {1, 1};
  expect_refusal(json, "along the side");
  json["sides"] = Json::parse(R"({"z+": [1, 0]})");
  expect_refusal(json, "z+");
}

TEST_F(Planar_fluids, liquid_lies_between_solids) {
  Json json = scene();
  json["liquids"][0] = Json::parse(
      R"json({"shape": {"type": "box", "from": [0, 0], "to": [1, 1]}, "density": 1})json");
  json["gravity"] = {0, -1};
  json["surface_tension"] = 0;
  json["solids"] = Json::parse(R"json([
    {"type": "tank", "box": [0, 0, 2, 2], "open": true},
    {"type": "box", "from": [1, -1], "to": [2, 3]},
    {"type": "ball", "center": [0, 3], "radius": 0.5, "angular_velocity": 1}])json");
  const Json steps = steps_of(json, "--steps 2");
  ASSERT_EQ(steps.size(), 3u);
  EXPECT_LT(steps[2].at("kinetic_energy").get<double>(), 1e-9); // at rest
  const Json& forces = steps[2].at("forces_on_solids");
  EXPECT_NEAR(forces[0][1].get<double>(), -1, 1e-6);  // the weight
  EXPECT_NEAR(forces[1][0].get<double>(), .5, 1e-2);  // the pressure on the box
  EXPECT_NEAR(forces[0][0].get<double>(), -.5, 1e-2); // and on the wall opposite to it
}

// A pool whose surface flows from the hot wall to the cold one.
TEST_F(Planar_fluids, carry_a_field) {
  Json json = Json::parse(R"json({
    "domain": [0, 0, 2, 0.5],
    "edge": 0.1,
    "liquids": [{"shape": {"type": "pool", "level": 0.25}, "density": 1, "viscosity": 0.1}],
    "surface_tension": "1-0.1*c",
    "field": {"initial": "x/2", "diffusivity": 1, "fixed": {"x-": 0, "x+": "1+t"}},
    "gravity": [0, -10],
    "probes": [{"name": "top", "at": [1, 0.24]}, {"name": "void", "at": [1, 0.45]}],
    "time_step": 0.05,
    "end": 0.4
  })json");
  const Json steps = steps_of(json);
  ASSERT_EQ(steps.size(), 9u);
  EXPECT_NEAR(steps[0].at("field").at("integral").get<double>(), .25, 1e-9);
  EXPECT_NEAR(steps[8].at("field").at("greatest").get<double>(), 1.4, 1e-9);
  EXPECT_NEAR(steps[8].at("field").at("least").get<double>(), 0, 1e-9);
  EXPECT_LT(steps[8].at("work_of_tensions").get<double>(), 0);
  const Json& probes = steps[8].at("probes");
  EXPECT_GT(probes.at("top").at("field").get<double>(), .4);
  EXPECT_TRUE(probes.at("void").at("field").is_null());
  EXPECT_LT(probes.at("top").at("velocity")[0].get<double>(), 0);
}

TEST_F(Planar_fluids, wrong_fields_are_refused) {
  const auto expect = [&](const std::string& patch, const std::string& message) {
    expect_refusal_of_patch(scene(), patch, message);
  };
  expect(R"({"surface_tension": "1-c"})", "the scene has no field");
  expect(R"({"surface_tension": "1-x"})", "'x'");
  expect(R"({"surface_tension": "1"})", "does not depend on the field c");
  expect(R"({"surface_tension": "-1-c", "field": {"initial": 0}})", "negative or not finite");
  expect(R"({"field": {}})", "'initial'");
  expect(R"({"field": {"initial": "t"}})", "'t'");
  expect(R"({"field": {"initial": 0, "diffusivity": -1}})", "'diffusivity'");
  expect(R"({"field": {"initial": 0, "fixed": {"z-": 0}}})", "z-");
  expect(R"({"field": {"initial": 0, "fixed": {"x-": 0}}})", "no liquid touches the side 'x-'");
}

TEST_F(Planar_fluids, wrong_scenes_are_refused) {
  const auto expect = [&](const std::string& patch, const std::string& message) {
    expect_refusal_of_patch(scene(), patch, message);
  };
  const auto expect_shape = [&](const std::string& shape, const std::string& message) {
    expect_refusal_of_value(scene(), "/liquids/0/shape", shape, message);
  };
  expect(R"({"domain": [0, 0, 1]})", "'domain'");
  expect(R"({"domain": [0, 0, 1, 0]})", "two minimum coordinates");
  expect(R"({"gravity": [0, 0, -1]})", "list of 2 numbers because the scene is in the plane");
  expect(R"({"solids": [{"type": "cylinder", "point": [0, 0], "axis": [1, 0], "radius": 1}]})",
         "exists only in space");
  expect(R"({"solids": [{"type": "mesh", "file": "a.off"}]})", "exists only in space");
  expect(R"({"solids": [{"type": "ball", "center": [9, 0], "radius": 1}]})",
         "solids[0] has no effect");
  expect(R"({"solids": [{"type": "box", "from": [3, 0], "to": [4, 1]}]})",
         "solids[0] has no effect");
  expect(R"({"solids": [{"type": "box", "from": [0, -3], "to": [1, 3]}]})", "inside a solid");
  expect(R"({"solids": [{"type": "plane", "point": [0, 0], "normal": [0, 1],
             "angular_velocity": [0, 0, 1]}]})",
         "angular_velocity");
  expect(R"({"probes": [{"name": "a", "height_at": [0, 0]}]})", "height_at");
  expect(R"({"probes": [{"name": "a", "height_at": 9}]})", "outside the domain");
  expect(R"({"probes": [{"name": "a", "velocity_of": 0}]})", "the label 0");
  expect_shape(R"({"type": "cylinder", "from": [0, 0], "to": [0, 1], "radius": 1})",
               "a cylinder exists only in space");
  expect_shape(R"({"type": "ball", "center": [0, 0], "radius": 1, "triangles": 80})",
               "'triangles'");
  expect_shape(R"({"type": "file", "file": "a.off", "center": [0, 0], "radius": 1})", ".wkt");
  expect_shape(R"({"type": "pool", "level": 0, "height": "y"})", "'y'");
  expect_refusal_of_value(scene(), "/liquids/0/velocity", "\"0,0,0\"", "3 components instead of 2");
  expect_refusal_of_value(
      scene(), "/liquids/-",
      R"({"shape": {"type": "ball", "center": [0.5, 0], "radius": 1}, "density": 1})", "cross");
}

TEST_F(Planar_fluids, options_of_space_are_refused) {
  const std::string file = write_scene(scene());
  const Outcome smooth = run("fluid " + file + " --subdivide 1 --output out");
  EXPECT_EQ(smooth.exit_code, 2);
  EXPECT_PRED2(contains, smooth.err, "--subdivide");
  EXPECT_NE(run("fluid " + file + " --picture a.png").exit_code, 0);
  const std::string picture = path("picture.svg").string();
  EXPECT_EQ(run("fluid " + file + " --steps 1 --picture " + picture).exit_code, 0);
  EXPECT_PRED2(contains, contents(picture), "<svg");
}
