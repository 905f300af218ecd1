// Fluids by the program.
#include "fluid_program.h"
#include "test.h"

namespace {

using namespace program;

// A droplet of 80 triangles that falls onto a floor.
Json scene() {
  return Json::parse(R"json({
    "title": "a test",
    "domain": [-2.5, -2.5, -2.5, 2.5, 2.5, 2.5],
    "edge": 0.6,
    "liquids": [{"shape": {"type": "ball", "center": [0, 0, 0], "radius": 1, "triangles": 80},
                 "density": 1, "velocity": [0, 0, -1]}],
    "surface_tension": 1,
    "gravity": [0, 0, -1],
    "solids": [{"type": "plane", "point": [0, 0, -1.1], "normal": [0, 0, 1]}],
    "probes": [{"name": "mode", "mode": 2, "center": [0, 0, 0]},
               {"name": "top", "height_at": [0.05, 0.02]}],
    "time_step": 0.05,
    "end": 0.4
  })json");
}

class Fluids : public program::Fluid_program_test
{
};

} // namespace

TEST_F(Fluids, scenes_are_listed_and_printed) {
  const Outcome list = run("fluid --list");
  EXPECT_EQ(list.exit_code, 0);
  for (const char* name :
       {"droplet",        "bunny",          "collision",    "bowl",         "dam-break", "crown",
        "capillary-wave", "bubble",         "sessile",      "jet",          "breathing", "tap",
        "rising-bubble",  "u-tube",         "floating-box", "falling-ball", "wheel",     "filling",
        "draining",       "thermocapillary"}) {
    EXPECT_PRED2(contains, list.out, name) << name;
    const Outcome scene = run("fluid --print " + std::string(name));
    EXPECT_EQ(scene.exit_code, 0) << scene.err;
    EXPECT_TRUE(Json::parse(scene.out).contains("liquids"));
  }
  std::vector<std::string> names;
  std::istringstream lines(list.out);
  for (std::string line; std::getline(lines, line);)
    names.push_back(line.substr(0, line.find(' ')));
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
}

TEST_F(Fluids, droplet_falls_onto_a_floor) {
  const Json steps = steps_of(scene());
  ASSERT_EQ(steps.size(), 9u);
  const double volume = steps[0].at("volume"), mass = volume;
  for (const Json& step : steps) {
    EXPECT_NEAR(step.at("volume").get<double>(), volume, 1e-10 * volume);
    EXPECT_TRUE(step.at("probes").at("mode").is_number());
    EXPECT_GT(step.at("probes").at("top").get<double>(), 0);
  }
  // Free fall for one step, then stopped by the floor.
  EXPECT_NEAR(steps[1].at("momentum")[2].get<double>(), -1.05 * mass, 1e-9 * mass);
  EXPECT_GT(steps[8].at("contacts").get<int>(), 0);
  EXPECT_LT(steps[8].at("forces_on_solids")[0][2].get<double>(), 0);
  EXPECT_LE(steps[8].at("depth_in_solids").get<double>(), 1e-6);
  EXPECT_NEAR(steps[8].at("time").get<double>(), .4, 1e-12);
}

TEST_F(Fluids, run_is_resumed_to_the_same_bits) {
  const std::string file = write_scene(scene());
  ASSERT_EQ(run("fluid " + file + " --output " + path("whole").string() + " --threads 1").exit_code,
            0);
  const Outcome half =
      run("fluid " + file + " --steps 4 --subdivide 1 --output " + path("parts").string());
  ASSERT_EQ(half.exit_code, 0) << half.err;
  EXPECT_TRUE(fs::exists(path("parts/smooth_000004.ply")));
  const std::string checkpoint = path("parts/checkpoint.dsc").string();
  const Outcome rest =
      run("fluid --resume " + checkpoint + " --output " + path("parts").string() + " --threads 2");
  ASSERT_EQ(rest.exit_code, 0) << rest.err;
  EXPECT_EQ(contents(path("parts/checkpoint.dsc")), contents(path("whole/checkpoint.dsc")));
  EXPECT_EQ(contents(path("parts/volume_000008.vtu")), contents(path("whole/volume_000008.vtu")));
  EXPECT_TRUE(fs::exists(path("parts/interface.pvd")));
  // Files of another run are not overwritten.
  EXPECT_NE(run("fluid " + file + " --output " + path("whole").string()).exit_code, 0);
}

TEST_F(Fluids, run_that_is_killed_is_resumed_to_the_same_bits) {
  const std::string file = write_scene(scene()), parts = path("parts").string(),
                    whole = path("whole").string(), checkpoint = parts + "/checkpoint.dsc";
  const Outcome killed =
      run("fluid " + file + " --end 1000 --output " + parts, "timeout -s KILL 2");
  ASSERT_NE(killed.exit_code, 0);
  const Outcome rest = run("fluid --resume " + checkpoint + " --end 1000 --steps 3 --output " +
                           parts + " --report " + path("report.json").string());
  ASSERT_EQ(rest.exit_code, 0) << rest.err;
  const int steps = report("report.json").at("steps").back().at("step");
  EXPECT_GE(steps, 3);
  ASSERT_EQ(
      run("fluid " + file + " --end 1000 --steps " + std::to_string(steps) + " --output " + whole)
          .exit_code,
      0);
  EXPECT_EQ(contents(checkpoint), contents(whole + "/checkpoint.dsc"));
}

// Boxes of one label that touch form one component.
TEST_F(Fluids, touching_boxes_are_one_component) {
  Json json = scene();
  json["liquids"] = Json::parse(R"json([
    {"shape": {"type": "box", "from": [-1, -0.5, -1], "to": [1, 0.5, 0]}, "label": 1, "density": 1},
    {"shape": {"type": "box", "from": [-1, -0.5, 0], "to": [0, 0.5, 1]}, "label": 1, "density": 1}
  ])json");
  json["probes"] = Json::parse(R"json([{"name": "shape", "circularity_of": 1},
    {"name": "center", "centroid_of": 1}, {"name": "velocity", "velocity_of": 1}])json");
  const Json steps = steps_of(json, "--steps 1");
  ASSERT_EQ(steps.size(), 2u);
  const Json& start = steps[0];
  ASSERT_EQ(start.at("parts").size(), 1u);
  EXPECT_NEAR(start.at("volume").get<double>(), 3, 1e-12);
  EXPECT_NEAR(start.at("probes").at("shape").get<double>(), std::cbrt(36 * M_PI * 9) / 14, 1e-12);
  EXPECT_NEAR(start.at("probes").at("center")[0].get<double>(), -.5 / 3, 1e-12);
  EXPECT_NEAR(start.at("probes").at("center")[2].get<double>(), -.5 / 3, 1e-12);
  EXPECT_NEAR(steps[1].at("probes").at("velocity")[2].get<double>(),
              steps[1].at("momentum")[2].get<double>() / 3, 1e-9);
}

TEST_F(Fluids, cylinder_stands_between_plates) {
  Json json = scene();
  json["liquids"][0]["shape"] = Json::parse(R"json({"type": "cylinder", "from": [0, 0, -1],
    "to": [0, 0, 1], "radius": 0.8, "amplitude": 0.1, "wave_length": 4})json");
  json["liquids"][0].erase("velocity");
  json["gravity"] = {0, 0, 0};
  json["solids"] = Json::parse(R"json([
    {"type": "plane", "point": [0, 0, -1], "normal": [0, 0, 1]},
    {"type": "plane", "point": [0, 0, 1], "normal": [0, 0, -1]}])json");
  const Json steps = steps_of(json, "--steps 2");
  ASSERT_EQ(steps.size(), 3u);
  const Json& start = steps[0];
  EXPECT_NEAR(start.at("extent")[1][0].get<double>(), .86, .03);
  EXPECT_NEAR(start.at("volume").get<double>(), 4.02, .6);
  EXPECT_NEAR(start.at("parts")[0].at("extent")[1][2].get<double>(), 1, 1e-12);
  json["liquids"][0]["shape"]["to"] = {0, 0, -1};
  expect_refusal(json, "no length");
}

TEST_F(Fluids, gas_in_a_drop_expands_and_a_source_feeds_it) {
  Json json = scene();
  json["gravity"] = {0, 0, 0};
  json["gases"] = Json::parse(R"json([{"shape": {"type": "ball", "center": [0, 0, 0], "radius": 0.5,
    "triangles": 80}, "pressure": 10}])json");
  json["sources"] = Json::parse(R"json([{"center": [0, 0, 0], "radius": 3, "rate": 0.1}])json");
  const std::string folder = path("run").string();
  const Json steps = steps_of(json, "--steps 3 --output " + folder);
  ASSERT_EQ(steps.size(), 4u);
  const Json first = steps[0].at("gases")[0], last = steps[3].at("gases")[0];
  EXPECT_EQ(first.at("label"), 2);
  EXPECT_GT(last.at("volume").get<double>(), 1.01 * first.at("volume").get<double>());
  EXPECT_NEAR(last.at("pressure").get<double>() * std::pow(last.at("volume").get<double>(), 1.4),
              10 * std::pow(first.at("volume").get<double>(), 1.4), 1e-9);
  EXPECT_NEAR(steps[3].at("volume").get<double>(),
              steps[0].at("volume").get<double>() * std::exp(.1 * .15), 1e-3);
  EXPECT_PRED2(contains, contents(path("run/volume_000003.vtu")), "Name=\"velocity\"");
  EXPECT_PRED2(contains, contents(path("run/volume_000003.vtu")), "Name=\"pressure\"");
  const Outcome rest =
      run("fluid --resume " + folder + "/checkpoint.dsc --steps 1 --output " + folder);
  EXPECT_EQ(rest.exit_code, 0) << rest.err;
  json["gases"][0]["pressure"] = -1;
  expect_refusal(json, "pressure");
  json["gases"][0]["pressure"] = 1;
  json["gases"][0]["label"] = 1;
  expect_refusal(json, "the label of a liquid");
  json["gases"][0].erase("label");
  json["sources"][0].erase("rate");
  expect_refusal(json, "rate");
}

// Coarse drops that land on a plane: the run reaches the end, or reports the failed step and keeps
// the previous one.
TEST_F(Fluids, drop_that_lands_survives_or_leaves_a_checkpoint) {
  Json json = scene();
  json["surface_tension"] = 2;
  json["gravity"] = {0, 0, -4};
  json["solids"][0]["contact_angle"] = 100;
  json["time_step"] = 0.1;
  json["end"] = 2;
  const Outcome outcome = run("fluid " + write_scene(json) + " --output " + path("run").string() +
                              " --report " + path("report.json").string());
  const Json whole = report("report.json");
  const Json& steps = whole.at("steps");
  for (std::size_t k = 1; k < steps.size(); ++k) {
    EXPECT_TRUE(steps[k].at("repetitions").is_array());
    EXPECT_LE(steps[k].at("residual").get<double>(), 1e-8);
    EXPECT_GE(steps[k].at("substeps").get<int>(), 1);
  }
  EXPECT_TRUE(whole.at("repeated").contains("steps"));
  EXPECT_TRUE(fs::exists(path("run/checkpoint.dsc")));
  if (outcome.exit_code != 0) {
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_PRED2(contains, outcome.err, "step " + std::to_string(steps.size()));
  } else
    EXPECT_NEAR(steps.back().at("time").get<double>(), 2, 1e-9);
}

TEST_F(Fluids, wrong_scenes_are_refused_by_name) {
  const auto expect = [&](const std::string& place, const std::string& value,
                          const std::string& message) {
    expect_refusal_of_value(scene(), place, value, message);
  };
  expect("/liquids/0/density", "-1", "density");
  expect("/liquids/0/densty", "1", "densty");
  expect("/colour", "\"blue\"", "colour");
  expect("/liquids/0/viscosity", "\"much\"", "viscosity");
  expect("/liquids/0/velocity", "\"0,0\"", "components");
  expect("/liquids/0/shape",
         R"({"type": "file", "file": "nothing.off", "center": [0, 0, 0], "radius": 1})",
         "nothing.off");
  expect("/liquids/-",
         R"({"shape": {"type": "ball", "center": [0.5, 0, 0], "radius": 1, "triangles": 80},
             "density": 1, "velocity": [0, 0, -1]})",
         "cross");
  expect(
      "/liquids/-",
      R"({"shape": {"type": "ball", "center": [0, 0, 0], "radius": 1}, "density": 2, "label": 1})",
      "the same density");
  expect("/solids/0/point", "[0, 0, 0]", "inside a solid");
  expect("/time_step", "0", "time_step");
  expect("/surface_tension", R"([{"labels": [0, 1.7], "value": 1}])", "must be an integer");
  Json json = scene();
  json.erase("domain");
  expect_refusal(json, "domain");
  json = scene();
  json["edge"] = 1e-9;
  json["liquids"][0]["shape"].erase("triangles");
  expect_refusal(json, "too small");
  write("broken.json", "{\"domain\": [0, 0");
  EXPECT_NE(run("fluid " + path("broken.json").string()).exit_code, 0);
  EXPECT_NE(run("fluid no-such-scene").exit_code, 0);
  EXPECT_NE(run("fluid").exit_code, 0);
  write("other.dsc", "nothing");
  EXPECT_NE(run("fluid --resume " + path("other.dsc").string()).exit_code, 0);
}

// Names of liquids reach tensions, probes, reports, files, checkpoints and pages.
TEST_F(Fluids, have_labels_with_names) {
  Json json = Json::parse(R"json({
    "domain": [0, 0, 1, 1], "edge": 0.25,
    "liquids": [{"shape": {"type": "pool", "level": 0.5}, "label": "water <&>", "density": 1},
                {"shape": {"type": "box", "from": [0, 0.5], "to": [0.25, 0.75]}, "label": "7",
                 "density": 0.5},
                {"shape": {"type": "box", "from": [0.5, 0.75], "to": [1, 1]}, "label": "7",
                 "density": 0.5}],
    "gases": [{"shape": {"type": "surroundings"}, "label": "air", "pressure": 1}],
    "surface_tension": [{"labels": ["water <&>", "7"], "value": 0.1},
                        {"labels": [0, "7"], "value": 0.2}],
    "probes": [{"name": "where", "centroid_of": "water <&>"}],
    "time_step": 0.01, "end": 0.01
  })json");
  ASSERT_EQ(run("fluid " + write_scene(json) + " --report r.json --output run --quiet").err, "");
  const Json step = report("r.json").at("steps").back();
  EXPECT_EQ(step.at("parts").at(0).at("name"), "water <&>");
  EXPECT_EQ(step.at("parts").at(1).at("label"), 2);
  EXPECT_EQ(step.at("parts").at(2).at("name"), "7");
  EXPECT_EQ(step.at("gases").at(0).at("name"), "air");
  EXPECT_NEAR(step.at("probes").at("where").at(1).get<double>(), .25, .01);
  EXPECT_PRED2(contains, run("info run/checkpoint.dsc").out, "label 1 'water <&>': ");
  ASSERT_EQ(run("view run -o page.html --without air,7").exit_code, 1); // 7 is a number
  ASSERT_EQ(run("view run -o page.html --without air").exit_code, 0);
  EXPECT_PRED2(contains, contents(path("page.html")), R"("names":[[0,"air"],[1,"water )");
  ASSERT_EQ(run("fluid --resume run/checkpoint.dsc --output run --end 0.02 --quiet").err, "");
  EXPECT_PRED2(contains, contents(path("run/volume_000002.vtu")), "\"label_names\"");

  expect_refusal_of_value(json, "/probes/0/centroid_of", "\"wate <&>\"",
                          "no label has the name 'wate <&>' (0 'air', 1 'water <&>', 2 '7'); did "
                          "you mean 'water <&>'?");
  expect_refusal_of_value(json, "/surface_tension/0/labels/1", "\"oil\"", "name 'oil' (0 'air'");
  expect_refusal_of_value(json, "/liquids/0/label", "\"\"", "in one line");
  expect_refusal_of_value(json, "/liquids/0/label", "\"a\\n\"", "in one line");
  expect_refusal_of_value(json, "/liquids/0/label", "\"air\"", "label 0 is reserved");
  expect_refusal_of_value(json, "/liquids/1/label", "\"water <&>\"", "the same density");

  // A name does not get the label of another liquid.
  json = Json::parse(R"json({
    "domain": [0, 0, 1, 1], "edge": 0.12, "time_step": 0.01, "end": 0.01,
    "liquids": [{"shape": {"type": "ball", "center": [0.25, 0.5], "radius": 0.18}, "label": 2,
                 "density": 1},
                {"shape": {"type": "ball", "center": [0.75, 0.5], "radius": 0.18}, "label": "b",
                 "density": 1}]
  })json");
  ASSERT_EQ(run("fluid " + write_scene(json) + " --report s.json --quiet").err, "");
  EXPECT_EQ(report("s.json").at("steps").back().at("parts").back().at("label"), 3);
}

// The solids of a file with several parts: a liquid and a wall.
TEST_F(Fluids, are_parts_of_files) {
  const auto solid = [](const std::string& name, double low, double high) {
    std::istringstream off(box(low, low, low, high, high, high));
    std::string line, stl = "solid " + name + "\n";
    std::vector<std::string> points;
    for (int i = 0; std::getline(off, line); ++i) {
      if (i >= 2 && i < 10)
        points.push_back(line);
      std::istringstream numbers(line);
      std::size_t three = 0, a = 0, b = 0, c = 0;
      if (i >= 10 && numbers >> three >> a >> b >> c)
        stl += "facet normal 0 0 0\nouter loop\nvertex " + points[a] + "\nvertex " + points[b] +
               "\nvertex " + points[c] + "\nendloop\nendfacet\n";
    }
    return stl + "endsolid\n";
  };
  write("parts.stl", solid("drop", -.5, .5) + solid("vessel", -2, 2));
  Json json = scene();
  json["edge"] = 0.8;
  json["end"] = 0.05;
  json["liquids"][0]["shape"] = Json::parse(
      R"({"type": "file", "file": "parts.stl", "part": "drop", "center": [0, 0, 0], "radius": 1})");
  json["solids"] = Json::parse(
      R"([{"type": "mesh", "file": "parts.stl", "part": "vessel", "liquid": "inside"}])");
  const Json steps = steps_of(json);
  EXPECT_NEAR(steps.back().at("volume").get<double>(), 8 / (3 * std::sqrt(3.)), 1e-6);
  expect_refusal_of_value(json, "/solids/0/part", "\"vesel\"",
                          "parts.stl: no part has the name 'vesel'; its parts are drop, vessel");
}

// Two liquids in a box are dragged by the upper side.
TEST_F(Fluids, stick_to_sides) {
  Json json = Json::parse(R"json({
    "domain": [0, 0, 0, 1, 0.5, 1], "edge": 0.25,
    "liquids": [{"shape": {"type": "pool", "level": 0.5}, "density": 1},
                {"shape": {"type": "surroundings"}, "density": 1}],
    "sides": {"z+": [1, 0, 0]}, "time_step": 0.02, "end": 0.04
  })json");
  EXPECT_EQ(run("fluid " + write_scene(json) + " --report report.json --quiet").err, "");
  EXPECT_GT(report("report.json").at("steps").back().at("kinetic_energy").get<double>(), 1e-3);
  json["sides"]["z+"] = {1, 0, 1};
  expect_refusal(json, "along the side");
  json["sides"] = Json::parse(R"({"top": [1, 0, 0]})");
  expect_refusal(json, "top");
  json = scene();
  json["sides"] = Json::parse(R"({"x-": [0, 0, 0]})");
  expect_refusal(json, "no liquid touches the side 'x-'");
}

TEST_F(Fluids, misspelt_fields_get_advice) {
  const auto expect = [&](const std::string& place, const std::string& value,
                          const std::string& message) {
    expect_refusal_of_value(scene(), place, value, message);
  };
  expect("/liquids/0/shape/type", "\"bal\"", "did you mean 'ball'?");
  expect("/liquids/0/shape", R"({"tpye": "ball"})", "did you mean 'type'?");
  expect("/solids/0/type", "\"plain\"", "did you mean 'plane'?");
  expect("/solids/0/contactangle", "60", "did you mean 'contact_angle'?");
  expect("/probes/1", R"({"name": "a", "hight_at": [0, 0]})", "did you mean 'height_at'?");
  expect("/edge", "\"0.6\"", "without quotes");
  expect_refusal_of_patch(scene(), R"({"gravitiy": [0, 0, -1], "gravity": null, "end": null})",
                          "did you mean 'gravity'?");
  EXPECT_PRED2(contains, run("fluid dropelt").err, "did you mean 'droplet'?");
}

TEST_F(Fluids, fields_are_there_once_in_json_without_comments) {
  const std::string text = scene().dump();
  const auto expect = [&](const std::string& file, const std::string& message) {
    write("text.json", file);
    const Outcome outcome = run("fluid " + path("text.json").string());
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_PRED2(contains, outcome.err, message);
  };
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string result = text;
    const std::size_t place = result.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    return result.replace(place, from.size(), to);
  };
  expect(changed("\"density\":1", "\"density\":1,\"density\":2"),
         "'liquids[0].density' occurs twice");
  expect(changed("\"end\"", "\"edge\":1,\"end\""), "'edge' occurs twice");
  expect(text + "{}", "end of input");
  expect(changed("{", "{ // comment\n"), "no comments");
  expect(changed("\"end\":0.4", "\"end\":1e999"), "1e999");
  expect(changed("\"end\":0.4", "\"end\":NaN"), "JSON");
}

TEST_F(Fluids, what_has_no_effect_is_refused) {
  const auto expect = [&](const std::string& patch, const std::string& message) {
    expect_refusal_of_patch(scene(), patch, message);
  };
  const auto expect_shape = [&](const std::string& shape, const std::string& message) {
    expect_refusal_of_value(scene(), "/liquids/0/shape", shape, message);
  };
  expect_shape(R"({"type": "ball", "center": [0, 0, 0], "radius": 1, "mode": 2})", "'amplitude'");
  expect_shape(R"({"type": "ball", "center": [0, 0, 0], "radius": 1, "amplitude": 0.1})", "'mode'");
  expect_shape(R"({"type": "ball", "center": [0, 0, 0], "radius": 1, "level": 1})", "'level'");
  expect_shape(R"({"type": "cylinder", "from": [0, 0, 0], "to": [0, 0, 1], "radius": 1,
                   "wave_length": 1})",
               "'amplitude'");
  expect_shape(R"({"type": "pool", "level": 0, "height": "z"})", "'z'");
  expect(R"({"probes": [{"name": "a", "height_at": [0, 0]}, {"name": "a", "height_at": [1, 0]}]})",
         "the name 'a'");
  expect(R"({"probes": [{"name": "a", "height_at": [9, 0]}]})", "outside the domain");
  expect(R"({"probes": [{"name": "a", "height_at": [0, 0], "center": [0, 0, 0]}]})", "'center'");
  expect(R"({"probes": [{"name": "a", "centroid_of": 2}]})", "the label 2");
  expect(R"({"probes": [{"name": "a", "centroid_of": 1, "mode": 2}]})", "'mode'");
  expect(R"({"surface_tension": [{"labels": [0, 3], "value": 1}]})", "the label 3");
  expect(R"({"surface_tension": [{"labels": [1, 1], "value": 1}]})", "two different labels");
  expect(R"({"surface_tension": [{"labels": [0, 1], "value": 1}, {"labels": [1, 0], "value": 1}]})",
         "0 and 1 occur twice");
  expect(R"({"sources": [{"center": [2, 0, 0], "radius": 0.5, "rate": 1}]})", "contains no liquid");
  expect(R"({"sources": [{"center": [9, 0, 0], "radius": 0.5, "rate": 1}]})", "contains no liquid");
  expect(R"({"sources": [{"center": [0, 0, 0], "radius": 0.5, "rate": 0}]})", "no effect");
  expect(R"({"solids": [{"type": "plane", "point": [0, 0, -3], "normal": [0, 0, 1]}]})",
         "solids[0] has no effect");
  expect(R"({"solids": [{"type": "plane", "point": [0, 0, -1], "normal": [0, 0, 0]}]})",
         "zero vector");
  expect(R"({"solids": [{"type": "ball", "center": [9, 0, 0], "radius": 1}]})",
         "solids[0] has no effect");
  expect(R"({"solids": [{"type": "tank", "box": [-3, -3, -3, 3, 3, 2], "open": true}]})",
         "solids[0] has no effect");
  expect(R"({"surface_tension": 0, "solids": [{"type": "plane", "point": [0, 0, -1.1],
             "normal": [0, 0, 1], "contact_angle": 60}]})",
         "contact_angle");
  expect(R"({"relaxation": {"time_step": 0.1, "steps": 0}})", "no effect");
  const auto expect_velocity = [&](const std::string& velocity, const std::string& message) {
    expect_refusal_of_value(scene(), "/liquids/0/velocity", Json(velocity).dump(), message);
  };
  expect_velocity("x=1,0,0", "velocity of liquids[0] of the scene 'x=1,0,0'");
  expect_velocity("0,t,0", "'t'");
  expect_velocity("0,sqrt(x),0", "nan at x = -");
  expect_refusal_of_value(scene(), "/liquids/-",
                          R"({"shape": {"type": "surroundings"}, "density": 1, "label": 2})",
                          "'label'");
}

// Their boundaries would have up to 1e8 triangles.
TEST_F(Fluids, shapes_far_larger_than_the_domain_are_refused_before_they_are_meshed) {
  for (const char* shape :
       {R"({"type": "ball", "center": [0, 0, 0], "radius": 1000})",
        R"({"type": "ball", "center": [0, 0, 1e6], "radius": 1})",
        R"({"type": "box", "from": [0, 0, 0], "to": [1, 1, 65536]})",
        R"({"type": "cylinder", "from": [0, 0, 0], "to": [0, 0, 1], "radius": 1000})",
        R"({"type": "cylinder", "from": [0, 0, 0], "to": [0, 0, 65536], "radius": 1})"}) {
    const std::string message = "liquids[0] of the scene is not inside the domain";
    expect_refusal_of_value(scene(), "/liquids/0/shape", shape, message);
  }
}

// Next to a pool, shapes are cut out of tetrahedra.
TEST_F(Fluids, liquids_that_others_cover_are_refused) {
  Json json = Json::parse(R"json({
    "domain": [0, 0, 0, 1, 1, 1], "edge": 0.2,
    "liquids": [{"shape": {"type": "pool", "level": 0.3}, "density": 1},
                {"shape": {"type": "ball", "center": [0.5, 0.5, 0.7], "radius": 0.2},
                 "density": 2}],
    "gravity": [0, 0, -1], "time_step": 0.01, "end": 0.01
  })json");
  const Outcome outcome = run("fluid " + write_scene(json));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  json["liquids"][1]["shape"]["radius"] = .001;
  expect_refusal(json, "label 2 of the scene has no cells");
  json["liquids"][1]["shape"]["radius"] = .2;
  json["liquids"].push_back(json["liquids"][1]);
  json["liquids"][2]["label"] = 3;
  json["liquids"][2]["shape"]["radius"] = .25;
  expect_refusal(json, "label 2 of the scene has no cells");
  json["liquids"][2]["label"] = 2;
  expect_refusal(json, "liquids[1] of the scene has no cells");
}

TEST_F(Fluids, solver_is_known_and_built) {
  expect_error("fluid droplet --solver other", 2);
  expect_error("fluid droplet -ksp_view", 2);
  const fs::path folder = fs::path(DSC_PROGRAM).parent_path();
  if (!fs::exists(folder / "dsc-fluid-petsc"))
    expect_error("fluid droplet --solver petsc -ksp_view", 1);
}

TEST_F(Fluids, options_without_effect_are_refused) {
  const std::string file = write_scene(scene());
  const auto expect = [&](const std::string& arguments, const std::string& message) {
    const Outcome outcome = run("fluid " + arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_PRED2(contains, outcome.err, message);
  };
  expect(file + " --data .", "--data");
  expect("droplet --data .", "--data");
  expect(file + " --every 2", "--output");
  expect("--print droplet --steps 3", "--steps");
  expect("--list droplet", "SCENE");
  ASSERT_EQ(run("fluid " + file + " --steps 1 --output out").exit_code, 0);
  expect("--resume out/checkpoint.dsc --end 0.05", "--end");
}
