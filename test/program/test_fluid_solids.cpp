// Bodies, moving solids, forces and sources that depend on the time, by the program.
#include "fluid_program.h"
#include "test.h"

namespace {

using namespace program;

// A box that floats in a box of liquid in a tank, partly above the surface.
Json floating() {
  return Json::parse(R"json({
    "domain": [-0.5, -0.5, 2.5, 2],
    "edge": 0.25,
    "liquids": [{"shape": {"type": "box", "from": [0, 0], "to": [2, 1]}, "density": 1}],
    "gravity": [0, -1],
    "solids": [{"type": "tank", "box": [0, 0, 2, 1.5], "open": true},
               {"type": "box", "from": [0.75, 0.8], "to": [1.25, 1.1], "density": 0.6}],
    "time_step": 0.02,
    "end": 0.1
  })json");
}

// A disk of liquid without gravity.
Json disk() {
  return Json::parse(R"json({
    "domain": [-2.5, -2.5, 2.5, 2.5],
    "edge": 0.3,
    "liquids": [{"shape": {"type": "ball", "center": [0, 0], "radius": 1}, "density": 1}],
    "time_step": 0.05,
    "end": 0.2
  })json");
}

// A wheel in a round tank of a viscous liquid.
Json wheel() {
  return Json::parse(R"json({
    "domain": [-1.5, -1.5, 1.5, 1.5],
    "edge": 0.12,
    "liquids": [{"shape": {"type": "ball", "center": [0, 0], "radius": 1}, "density": 1,
                 "viscosity": 1}],
    "solids": [{"type": "ball", "center": [0, 0], "radius": 1, "liquid": "inside", "sticks": true,
                "separates": false},
               {"type": "ball", "center": [0, 0], "radius": 0.5, "rotation": "t", "sticks": true,
                "separates": false}],
    "implicitness": 1,
    "time_step": 0.1,
    "end": 0.5
  })json");
}

class Fluid_solids : public program::Fluid_program_test
{
protected:
  // Expects that a field of a solid of floating() is refused, or that a combination is.
  void expect_refusal_of_solid(std::size_t solid, const std::string& patch,
                               const std::string& text) {
    SCOPED_TRACE(patch);
    Json json = floating();
    json["solids"][solid].merge_patch(Json::parse(patch));
    expect_refusal(json, text);
  }
};

} // namespace

TEST_F(Fluid_solids, box_floats) {
  const Json steps = steps_of(floating());
  ASSERT_EQ(steps.size(), 6u);
  EXPECT_NEAR(steps[0].at("volume").get<double>(), 2 - .5 * .2, 1e-12); // without the hole
  const Json& first = steps[0].at("bodies");
  ASSERT_EQ(first.size(), 1u);
  EXPECT_EQ(first[0].at("solid"), 1);
  EXPECT_NEAR(first[0].at("center")[0].get<double>(), 1, 1e-12);
  EXPECT_NEAR(first[0].at("center")[1].get<double>(), .95, 1e-12);
  EXPECT_EQ(first[0].at("rotation"), Json::parse("[1.0, 0.0, 0.0, 0.0]"));
  // The box displaces more than its weight, so it rises.
  const Json& last = steps[5].at("bodies")[0];
  EXPECT_GT(last.at("velocity")[1].get<double>(), 0);
  EXPECT_GT(last.at("center")[1].get<double>(), .95);
  EXPECT_LT(std::abs(last.at("velocity")[0].get<double>()), .01);
  EXPECT_EQ(last.at("velocity")[2], 0);
  EXPECT_GT(steps[5].at("forces_on_solids")[1][1].get<double>(), .05);
  EXPECT_EQ(steps[5].at("torques_on_solids").size(), 2u);
  EXPECT_NEAR(steps[5].at("volume").get<double>(), 1.9, 1e-10);
  EXPECT_LE(steps[5].at("depth_in_solids").get<double>(), 1e-6);
}

TEST_F(Fluid_solids, body_is_fixed) {
  Json json = floating();
  json["solids"][1]["fixed"] = {"x", "y", "rotation"};
  const Json steps = steps_of(json);
  ASSERT_EQ(steps.size(), 6u);
  EXPECT_EQ(steps[5].at("bodies"), steps[0].at("bodies"));
  EXPECT_LT(steps[5].at("kinetic_energy").get<double>(), 1e-9);
  EXPECT_NEAR(steps[5].at("forces_on_solids")[1][1].get<double>(), .1, .01); // buoyancy
  EXPECT_NEAR(steps[5].at("torques_on_solids")[1][2].get<double>(), 0, .01);
}

TEST_F(Fluid_solids, run_with_a_body_is_resumed_to_the_same_bits) {
  Json json = floating();
  json["gravity"] = "0.1*sin(9*t),-1";
  json["sources"] = Json::parse(R"json([{"center": [0.3, 0.3], "radius": 0.3, "flux": "t"}])json");
  json["solids"][1]["velocity"] = {0, -.1};
  json["solids"][1]["angular_velocity"] = .1;
  json["solids"][0].erase("open");
  json["solids"][0]["displacement"] = "0.01*sin(t),0";
  const std::string file = write_scene(json);
  const Outcome outcome = run("fluid " + file + " --output " + path("whole").string());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string parts = path("parts").string();
  ASSERT_EQ(run("fluid " + file + " --steps 2 --output " + parts).exit_code, 0);
  const Outcome rest = run("fluid --resume " + parts + "/checkpoint.dsc --output " + parts);
  ASSERT_EQ(rest.exit_code, 0) << rest.err;
  EXPECT_EQ(contents(path("parts/checkpoint.dsc")), contents(path("whole/checkpoint.dsc")));
  EXPECT_EQ(contents(path("parts/volume_000005.vtu")), contents(path("whole/volume_000005.vtu")));
}

// The first report of the rest repeats the last report of the first part.
TEST_F(Fluid_solids, energy_at_a_time_is_the_same_in_a_resumed_run) {
  Json json = disk();
  json["gravity"] = "0,-1-5*t";
  json["liquids"][0]["shape"]["center"] = {0, 1};
  const std::string file = write_scene(json), parts = path("parts").string();
  ASSERT_EQ(run("fluid " + file + " --steps 2 --report first.json --output " + parts).exit_code, 0);
  const Outcome rest =
      run("fluid --resume " + parts + "/checkpoint.dsc --steps 1 --report rest.json");
  ASSERT_EQ(rest.exit_code, 0) << rest.err;
  const Json last = Json::parse(contents(path("first.json"))).at("steps").back(),
             first = Json::parse(contents(path("rest.json"))).at("steps").front();
  ASSERT_EQ(last.at("time"), first.at("time"));
  for (const char* field : {"potential_energy", "energy"})
    EXPECT_NEAR(last.at(field).get<double>(), first.at(field).get<double>(), 1e-12);
}

TEST_F(Fluid_solids, ball_sinks_in_space) {
  Json json = Json::parse(R"json({
    "domain": [-1.5, -1.5, -1.5, 1.5, 1.5, 1.5], "edge": 0.5,
    "liquids": [{"shape": {"type": "box", "from": [-1, -1, -1], "to": [1, 1, 1]}, "density": 1,
                 "viscosity": 1}],
    "gravity": [0, 0, -1],
    "solids": [{"type": "tank", "box": [-1, -1, -1, 1, 1, 1], "open": true},
               {"type": "ball", "center": [0, 0, 0], "radius": 0.5, "density": 4, "sticks": true}],
    "time_step": 0.02, "end": 0.04
  })json");
  const Json steps = steps_of(json);
  ASSERT_EQ(steps.size(), 3u);
  EXPECT_LT(steps[0].at("volume").get<double>(), 8 - .2);
  EXPECT_GT(steps[0].at("volume").get<double>(), 8 - 4. / 3 * M_PI * .125); // a polyhedron inside
  EXPECT_LT(steps[2].at("bodies")[0].at("velocity")[2].get<double>(), 0);
  json["solids"][1]["center"] = {0, 0, .8};
  expect_refusal(json, "partly inside a solid");
}

TEST_F(Fluid_solids, mesh_falls_freely) {
  write("body.off", program::box(-.2, -.2, -1.6, .2, .2, -1.2));
  const Json steps = steps_of(Json::parse(R"json({
    "domain": [-2, -2, -2, 2, 2, 2], "edge": 0.6,
    "liquids": [{"shape": {"type": "ball", "center": [0, 0, 0], "radius": 1, "triangles": 80},
                 "density": 1}],
    "gravity": [0, 0, -1],
    "solids": [{"type": "mesh", "file": "body.off", "density": 2, "fixed": ["x"]}],
    "time_step": 0.05, "end": 0.1
  })json"),
                              "--data " + path("").string());
  ASSERT_EQ(steps.size(), 3u);
  EXPECT_NEAR(steps[0].at("bodies")[0].at("center")[2].get<double>(), -1.4, 1e-12);
  EXPECT_NEAR(steps[2].at("bodies")[0].at("velocity")[2].get<double>(), -.1, 1e-9);
  EXPECT_NEAR(steps[2].at("bodies")[0].at("center")[2].get<double>(), -1.405, 1e-9);
}

// The torque of Couette flow, and the same motion by two fields.
TEST_F(Fluid_solids, wheel_is_turned) {
  const double torque = 4 * M_PI * .25 / .75;
  Json json = wheel();
  const Json steps = steps_of(json);
  ASSERT_EQ(steps.size(), 6u);
  const Json& torques = steps[5].at("torques_on_solids");
  EXPECT_NEAR(torques[0][2].get<double>(), torque, .05 * torque);
  EXPECT_NEAR(torques[1][2].get<double>(), -torque, .05 * torque);
  EXPECT_EQ(torques[0][0], 0);
  json["solids"][1].erase("rotation");
  json["solids"][1]["angular_velocity"] = 1;
  const Json same = steps_of(json);
  ASSERT_EQ(same.size(), 6u);
  EXPECT_NEAR(same[5].at("torques_on_solids")[1][2].get<double>(), torques[1][2].get<double>(),
              1e-4 * torque);
}

TEST_F(Fluid_solids, tank_is_displaced) {
  Json json = floating();
  json["solids"].erase(1);
  json["solids"][0]["displacement"] = "0.1*t,0";
  const Json steps = steps_of(json);
  ASSERT_EQ(steps.size(), 6u);
  EXPECT_GT(steps[5].at("kinetic_energy").get<double>(), 1e-4);
  json["solids"][0].erase("displacement");
  json["solids"][0]["velocity"] = {.1, 0};
  const Json same = steps_of(json);
  ASSERT_EQ(same.size(), 6u);
  EXPECT_NEAR(same[5].at("kinetic_energy").get<double>(),
              steps[5].at("kinetic_energy").get<double>(), 1e-6);
  EXPECT_NEAR(same[5].at("torques_on_solids")[0][2].get<double>(),
              steps[5].at("torques_on_solids")[0][2].get<double>(), 1e-4);
}

// A tank that rotates about its middle does not displace its liquid. With another center, the
// middle of the tank moves.
TEST_F(Fluid_solids, tank_rotates_about_its_center) {
  Json json = Json::parse(R"json({
    "domain": [1.5, 1.5, 4.5, 4.5], "edge": 0.2,
    "liquids": [{"shape": {"type": "box", "from": [2.5, 2.5], "to": [3.5, 3.5]}, "density": 1}],
    "solids": [{"type": "tank", "box": [2.5, 2.5, 3.5, 3.5], "angular_velocity": 0.5,
                "separates": false}],
    "time_step": 0.02, "end": 0.06
  })json");
  const auto momentum = [&] {
    const Json steps = steps_of(json);
    EXPECT_EQ(steps.size(), 4u);
    return steps.empty() ? Json() : steps.back().at("momentum");
  };
  EXPECT_NEAR(momentum()[0].get<double>(), 0, .005);
  json["solids"][0]["center"] = {3, 2};
  EXPECT_NEAR(momentum()[0].get<double>(), -.5, .01);
  json["solids"][0].erase("angular_velocity");
  json["solids"][0]["rotation"] = "0.5*t";
  EXPECT_NEAR(momentum()[0].get<double>(), -.5, .01);
  json["solids"][0]["center"] = {3};
  expect_refusal(json, "center");
}

TEST_F(Fluid_solids, gravity_depends_on_the_time) {
  Json json = disk();
  json["gravity"] = "0,-1-2*t";
  const Json steps = steps_of(json);
  ASSERT_EQ(steps.size(), 5u);
  const double mass = steps[0].at("volume");
  EXPECT_NEAR(steps[4].at("momentum")[1].get<double>(), -(.2 + .04) * mass, 1e-9 * mass);
  json["gravity"] = "0,-1,0";
  expect_refusal(json, "3 components instead of 2");
}

TEST_F(Fluid_solids, sides_depend_on_the_time) {
  Json json = Json::parse(R"json({
    "domain": [0, 0, 1, 1], "edge": 0.25,
    "liquids": [{"shape": {"type": "pool", "level": 0.5}, "density": 1},
                {"shape": {"type": "surroundings"}, "density": 1}],
    "sides": {"y+": "sin(9*t),0"}, "time_step": 0.02, "end": 0.1
  })json");
  const Json steps = steps_of(json);
  ASSERT_EQ(steps.size(), 6u);
  EXPECT_GT(steps[5].at("kinetic_energy").get<double>(),
            2 * steps[1].at("kinetic_energy").get<double>());
  json["sides"]["y+"] = "0,1";
  expect_refusal(json, "along the side");
  json["sides"]["y+"] = "0,t";
  expect_refusal(json, "along the side");
}

// The liquid rises like a piston.
TEST_F(Fluid_solids, liquid_enters_through_a_side) {
  Json json = Json::parse(R"json({
    "domain": [0, 0, 1, 3], "edge": 0.25,
    "liquids": [{"shape": {"type": "pool", "level": 1}, "density": 1, "velocity": "0,0.5"}],
    "gravity": [0, -1], "sides": {"y-": {"inflow": "0,0.5"}}, "time_step": 0.05, "end": 0.5
  })json");
  for (const Json& step : steps_of(json)) {
    const double level = 1 + .5 * step.at("time").get<double>();
    EXPECT_NEAR(step.at("volume").get<double>(), level, 1e-10);
    // The weight of new liquid acts from the next step on.
    EXPECT_NEAR(step.at("extent")[1][1].get<double>(), level, 1e-4);
  }
  json["sides"]["y-"] = {{"inflow", {0, 1}}, {"from", {0, 0}}, {"to", {-1, 0}}};
  expect_refusal(json, "must not be smaller than 'from'");
  json["sides"]["y-"] = Json::object();
  expect_refusal(json, "inflow");
  json["sides"] = {{"y+", {{"inflow", {0, -1}}}}};
  expect_refusal(json, "no liquid touches the side");
}

// Water leaves a tank through the lower half of a side.
TEST_F(Fluid_solids, liquid_leaves_through_an_open_side) {
  Json json = Json::parse(R"json({
    "domain": [0, 0, 1, 2], "edge": 0.25,
    "liquids": [{"shape": {"type": "pool", "level": 1}, "density": 1}],
    "gravity": [0, -1],
    "sides": {"x+": {"pressure": 0, "from": [1, 0], "to": [1, 0.6]}},
    "time_step": 0.05, "end": 0.3
  })json");
  double left = 0;
  for (const Json& step : steps_of(json)) {
    if (step.contains("volume_through_sides"))
      left -= step.at("volume_through_sides")[1].get<double>();
    EXPECT_NEAR(step.at("volume").get<double>() + left, 1, 1e-10);
  }
  EXPECT_GT(left, 0);
  json["sides"]["x+"] = {{"pressure", "1-y"}}; // hydrostatic pressure
  for (const Json& step : steps_of(json))
    EXPECT_NEAR(step.at("kinetic_energy").get<double>(), 0, 1e-12);
  json["sides"]["x+"]["velocity"] = {1, 0};
  expect_refusal(json, "along the side");
  json["sides"]["x+"] = {{"pressure", 0}, {"inflow", {0, 1}}};
  expect_refusal(json, "cannot be combined with 'pressure'");
  json["sides"]["x+"] = {{"pressure", 0}, {"from", {0, 0}}, {"to", {0.5, 0.5}}};
  expect_refusal(json, "meets the side");
  json["sides"]["x+"] = {{"inflow", {-1, 0}}, {"from", {1, 3}}, {"to", {1, 4}}};
  expect_refusal(json, "meets the side");
  json["sides"]["x+"] = {{"pressur", 0}};
  expect_refusal(json, "did you mean 'pressure'");
}

// The state before the step is kept, and the message tells the step and the time.
TEST_F(Fluid_solids, steps_that_fail_leave_a_checkpoint) {
  Json json = floating();
  json["sources"] = {{{"center", {1, 0.4}}, {"radius", 0.3}, {"flux", "t<0.05?0.1:1/0"}}};
  const Outcome outcome = run("fluid " + write_scene(json));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_PRED2(contains, outcome.err, "step 3 of the fluid at time 0.04 failed: ");
  EXPECT_PRED2(contains, outcome.err, "the state after step 2 is in ");
  EXPECT_TRUE(std::filesystem::exists(path("dsc_failed.dsc")));
}

// A box that floats in equilibrium stays there.
TEST_F(Fluid_solids, relaxation_of_a_fluid_at_rest_ends) {
  Json json = floating();
  json["solids"][1]["from"] = {0.75, 0.82};
  json["solids"][1]["to"] = {1.25, 1.12};
  json["relaxation"] = {{"time_step", 0.1}, {"steps", 30}};
  json["end"] = 0.02;
  EXPECT_EQ(steps_of(json).size(), 2u);
}

TEST_F(Fluid_solids, flux_is_exact) {
  Json json = disk();
  json["sources"] = Json::parse(R"json([
    {"center": [0, 0], "radius": 0.5, "flux": "0.3*(1+t)"},
    {"center": [0.5, 0], "radius": 0.5, "flux": -0.1}])json");
  const Json steps = steps_of(json);
  ASSERT_EQ(steps.size(), 5u);
  for (std::size_t i = 1; i < 5; ++i) {
    const double gained = (.3 * (1 + (double(i) - .5) * .05) - .1) * .05;
    EXPECT_NEAR(steps[i].at("gained_volume").get<double>(), gained, 1e-10);
    EXPECT_NEAR(steps[i].at("volume").get<double>() - steps[i - 1].at("volume").get<double>(),
                gained, 1e-10);
  }
  json["sources"][0]["rate"] = 1;
  expect_refusal(json, "'flux': cannot be combined with the field 'rate'");
  json["sources"][0].erase("rate");
  json["sources"][0].erase("flux");
  expect_refusal(json, "'rate': is missing");
  json["sources"][0]["flux"] = "0*1";
  expect_refusal(json, "no effect");
  json["sources"][0]["flux"] = "x";
  expect_refusal(json, "'x'");
}

TEST_F(Fluid_solids, holes_are_cut_out_of_pools) {
  Json json = floating();
  json["domain"] = {0, 0, 2, 2};
  json["liquids"][0]["shape"] = {{"type", "pool"}, {"level", 1}};
  json["solids"].erase(0);
  Json steps = steps_of(json, "--steps 1");
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_NEAR(steps[0].at("volume").get<double>(), 1.9, 1e-12);
  // A ball is cut out by the labels of points.
  json["edge"] = .1;
  json["solids"][0] =
      Json::parse(R"json({"type": "ball", "center": [1, 0.5], "radius": 0.3, "density": 2})json");
  steps = steps_of(json, "--steps 1");
  ASSERT_EQ(steps.size(), 2u);
  // The hole is a polygon inscribed in a circle. An edge of the length e cuts off at most about
  // e^3 / (12 radius), so all edges cut off at most pi e^2 / 6 for the longest edge e.
  const double cut_off = steps[0].at("volume").get<double>() - (2 - M_PI * .09), longest = .15;
  EXPECT_GT(cut_off, 0);
  EXPECT_LT(cut_off, M_PI * longest * longest / 6);
  json["liquids"][0]["shape"]["height"] = "1+0.01*cos(pi*x)";
  expect_refusal(json, "solids in liquids");
}

TEST_F(Fluid_solids, holes_are_cut_out_of_other_shapes) {
  Json json = disk();
  json["solids"] = Json::parse(R"json([
    {"type": "box", "from": [-0.3, -0.3], "to": [0.3, 0.3], "density": 1},
    {"type": "box", "from": [-9, -9], "to": [9, -2], "contact_angle": 90}])json");
  const Json in_disk = steps_of(json, "--steps 1");
  ASSERT_EQ(in_disk.size(), 2u);
  EXPECT_NEAR(in_disk[0].at("volume").get<double>(), M_PI - .36, 1e-9);
  // In a liquid with the label 0, a hole has another label.
  json["liquids"].push_back(
      Json::parse(R"json({"shape": {"type": "surroundings"}, "density": 2})json"));
  json["solids"].erase(1);
  const Json around = steps_of(json, "--steps 1");
  ASSERT_EQ(around.size(), 2u);
  EXPECT_NEAR(around[0].at("volume").get<double>(), 25 - .36, 1e-9);
  json["solids"][0]["to"] = {1, 1};
  expect_refusal(json, "inside a solid");
  json = floating();
  json["solids"][1]["from"] = {-1, -1};
  json["solids"][1]["to"] = {3, 3};
  expect_refusal(json, "liquids[0] of the scene has no cells");
}

TEST_F(Fluid_solids, wrong_solids_are_refused) {
  expect_refusal_of_solid(0, R"({"density": 1})", "'density': applies only to a box, ball or mesh");
  expect_refusal_of_solid(1, R"({"density": 0})", "positive");
  expect_refusal_of_solid(1, R"({"density": null, "fixed": ["x"]})", "without the field 'density'");
  expect_refusal_of_solid(1, R"({"fixed": ["z"]})", "\"x\", \"y\" and \"rotation\"");
  expect_refusal_of_solid(1, R"({"fixed": "x"})", "list");
  expect_refusal_of_solid(1, R"({"fixed": ["rotation", "x", "rotation"]})", "twice");
  expect_refusal_of_solid(1, R"({"fixed": ["x"], "velocity": [1, 0]})", "'velocity': must be 0");
  expect_refusal_of_solid(1, R"({"fixed": ["rotation"], "angular_velocity": 1})",
                          "'angular_velocity': must be 0");
  expect_refusal_of_solid(1, R"({"displacement": "t,0"})",
                          "cannot be combined with the field 'density'");
  expect_refusal_of_solid(0, R"({"displacement": "t,0", "velocity": [1, 0]})",
                          "cannot be combined with the field 'velocity'");
  expect_refusal_of_solid(0, R"({"rotation": "t", "angular_velocity": 1})",
                          "cannot be combined with the field 'angular_velocity'");
  expect_refusal_of_solid(0, R"({"displacement": "t"})", "1 component instead of 2");
  expect_refusal_of_solid(0, R"({"rotation": "0,0,t"})", "3 components instead of 1");
  expect_refusal_of_solid(0, R"({"displacement": [0, 0]})", "string");
  expect_refusal_of_solid(1, R"({"from": [5, 0.8], "to": [5.5, 1.1]})", "outside the domain");
  expect_refusal_of_solid(1, R"({"center": [0, 0]})",
                          "'center': cannot be combined with the field 'density'");
  expect_refusal_of_solid(1, R"({"density": null, "rotation": "1+t"})", "must be 0 at the time 0");
}
