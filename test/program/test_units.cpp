// The same input in another unit gives the same result in this unit, for all readers and commands.
// Powers of two change exponents only; powers of ten change rounding.
#include "all_cases.h"
#include "program.h"
#include "scaled_inputs.h"
#include "test.h"
#include "units.h"

namespace {

using namespace program;
using scaled_inputs::digits;
using scaled_inputs::list;
using namespace units;

struct Result
{
  Json report;
  std::string output;
};

class Any_unit : public program::Program_test
{
protected:
  using Arguments = std::function<std::string(double)>;

  const std::string moving = " --steps 2 --output o --report r.json --quiet --threads 1";

  // The inputs are the files among the arguments. The checkpoint of the run becomes the output.
  Result result_in(double unit, const Arguments& arguments, const std::string& output) const {
    using namespace scaled_inputs;
    static const std::map<std::string, std::string (*)(double)> inputs = {
        {"a.off", [](double u) { return off(u); }},
        {"broken.off", broken_off},
        {"a.obj", obj},
        {"a.ply", ply},
        {"a.stl", stl},
        {"binary.stl", binary_stl},
        {"a.mesh", medit},
        {"a.vtu", vtu},
        {"a.inr", inr},
        {"a.xyz", xyz},
        {"a.wkt", wkt},
        {"a.poly", poly}};
    const std::string text = arguments(unit);
    for (const auto& [name, content] : inputs)
      if (text.find(' ' + name) != std::string::npos)
        write(name, content(unit));
    return result_of(text, output);
  }

  Result result_of(const std::string& arguments, const std::string& output) const {
    fs::remove_all(path("o"));
    if (!output.empty())
      fs::remove(path(output));
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << arguments << '\n' << outcome.err;
    if (outcome.exit_code != 0)
      return {};
    if (fs::exists(path("o/checkpoint.dsc")) && !output.empty() && !fs::exists(path(output)))
      expect_success("convert o/checkpoint.dsc --quiet " + output);
    return {of_any_run(report("r.json")), output.empty() ? "" : contents(path(output))};
  }

  void expect_same_in_any_unit(const Arguments& arguments, const std::string& output,
                               const Dimensions& dimensions, double part = 1e-3) const {
    const Result expected = result_in(1, arguments, output);
    std::vector<double> powers_of_two = {0x1p-30, 0x1p30}, powers_of_ten = {1e-9, 1e9};
    if (all_cases()) {
      powers_of_two.push_back(2);
      powers_of_ten.insert(powers_of_ten.end(), {1e-4, 1e4});
    }
    for (const double unit : powers_of_two) {
      SCOPED_TRACE(arguments(unit));
      const Result result = result_in(unit, arguments, output);
      expect_equal(scaled(expected.report, {unit}, dimensions), result.report);
      if (output == "c.png" || output == "c.svg") // in pixels
        EXPECT_TRUE(expected.output == result.output);
      else
        expect_scaled(expected.output, result.output, unit);
    }
    for (const double unit : powers_of_ten) {
      SCOPED_TRACE(arguments(unit));
      expect_near(scaled(expected.report, {unit}, dimensions),
                  result_in(unit, arguments, "").report, part);
    }
  }
};

std::string distance(double x) { return " --distance=" + digits(x); }

std::string domain(double unit, const std::vector<double>& box) {
  return " --domain=" + list(box, unit);
}

// Velocities that are not a linear function of the position.
std::string velocity(double u, int dimension) {
  const std::string l = digits(u);
  return " --dt .05 --velocity '" + l + "*sin(3*y/" + l + ")," + l + "*cos(2*x/" + l + ')' +
         (dimension == 3 ? ",0.3*x'" : "'");
}

} // namespace

TEST_F(Any_unit, surfaces_of_every_format) {
  for (const std::string file : {"a.off", "a.obj", "a.ply", "a.stl", "binary.stl"})
    expect_same_in_any_unit([&](double u) { return "offset " + file + distance(.11 * u) + moving; },
                            "c.off", in_space);
}

TEST_F(Any_unit, motions_of_surfaces) {
  const std::vector<double> box = {-2.5, -2.25, -2, 2.5, 2.5, 2.25};
  const std::vector<Arguments> all = {
      [&](double) { return "offset a.off --distance=-0.5e"; },
      [&](double u) { return "offset a.off --move-faces" + distance(.1 * u); },
      [&](double u) { return "offset a.off --triangles 60" + distance(.1 * u); },
      [&](double u) { return "offset a.off --triangles 300" + distance(.1 * u); },
      [&](double u) { return "offset a.off" + distance(.1 * u) + domain(u, box); },
      [&](double u) { return "offset a.off --improve-interface" + distance(.1 * u); },
      [&](double u) { return "offset broken.off --repair" + distance(.1 * u); },
      [&](double) { return "rotate a.off --axis 1,2,3 --angle 11"; },
      [&](double u) { return "advect a.off" + velocity(u, 3); },
      [&](double u) { return "advect a.off --tolerance 0 --scheme euler" + velocity(u, 3); }};
  for (const Arguments& arguments : all)
    expect_same_in_any_unit([&](double u) { return arguments(u) + moving; }, "c.mesh", in_space);
  for (const std::string options : {"", " --keep-volumes"})
    for (const bool tells_dt : {false, true})
      expect_same_in_any_unit(
          [&](double u) {
            return "mean-curvature a.off" + options +
                   (tells_dt ? " --dt " + digits(.02 * u * u) : "") + moving;
          },
          "c.mesh", in_space + squared_time);
}

TEST_F(Any_unit, other_outputs) {
  for (const std::string output : {"c.obj", "c.ply", "c.stl", "c.png", "o/smooth_000002.ply"})
    expect_same_in_any_unit(
        [&](double u) {
          return "offset a.off" + distance(.1 * u) + moving +
                 (output[0] == 'o' ? " --subdivide 1" : "");
        },
        output, in_space);
}

TEST_F(Any_unit, inequalities) {
  expect_same_in_any_unit(
      [&](double u) {
        const std::string l = digits(u);
        return "offset '(x/" + l + ")^2+(y/" + l + ")^2+(z/" + l + ")^2<1.03' --edge " +
               digits(.31 * u) + domain(u, {-2.5, -2.25, -2, 2.5, 2.5, 2.25}) + distance(.1 * u) +
               moving;
      },
      "c.off", in_space);
}

TEST_F(Any_unit, tetrahedra) {
  for (const std::string format : {"mesh", "vtu"}) {
    const std::string input = " a." + format, box = " --domain";
    expect_same_in_any_unit([&](double u) { return "offset" + input + distance(.11 * u) + moving; },
                            "c.mesh", in_space);
    expect_same_in_any_unit(
        [&](double u) {
          return "offset" + input + distance(.11 * u) + domain(u, {-2, -2, -2, 5, 5, 5}) + moving;
        },
        "c.mesh", in_space);
    for (const std::string options : {"", " --aggressive"})
      expect_same_in_any_unit(
          [&](double) {
            return "improve" + input + options + " -o c.mesh --report r.json --quiet";
          },
          "c.mesh", in_space);
  }
}

TEST_F(Any_unit, images) {
  for (const bool tells_edge : {false, true})
    expect_same_in_any_unit(
        [&](double u) {
          return "offset a.inr" + distance(.11 * u) +
                 (tells_edge ? " --edge " + digits(1.5 * u) : "") + moving;
        },
        "c.off", in_space);
}

TEST_F(Any_unit, figures_in_the_plane) {
  for (const std::string file : {"a.wkt", "a.poly"}) {
    const std::vector<Arguments> all = {
        [&](double u) { return "offset " + file + distance(.11 * u); },
        [&](double u) {
          return "offset " + file + domain(u, {-2, -2, 2.5, 2}) + distance(.11 * u);
        },
        [&](double u) { return "offset " + file + " --segments 90" + distance(.11 * u); },
        [&](double) { return "rotate " + file + " --angle 11"; },
        [&](double u) { return "advect " + file + velocity(u, 2); }};
    for (const Arguments& arguments : all)
      expect_same_in_any_unit([&](double u) { return arguments(u) + moving; }, "c.wkt",
                              in_the_plane);
    for (const std::string options : {"", " --keep-volumes"})
      expect_same_in_any_unit(
          [&](double u) {
            return "mean-curvature " + file + options + " --dt " + digits(.01 * u * u) + moving;
          },
          "c.poly", in_the_plane + squared_time);
  }
}

TEST_F(Any_unit, points) {
  const Dimensions dimensions = {{"spacing", {1, 0, 0}},
                                 {"noise", {1, 0, 0}},
                                 {"root_mean_square", {1, 0, 0}},
                                 {"maximum_distance", {1, 0, 0}},
                                 {"facets_without_points", {1, 0, 0}}};
  expect_same_in_any_unit(
      [](double) { return "reconstruct a.xyz -o c.off --report r.json --quiet"; }, "c.off",
      dimensions + in_space, 1e-2); // other triangles, because of rounding
}

// Scales the lengths on the surface, and the coordinates of its chart.
TEST_F(Any_unit, surfaces_with_charts) {
  const auto torus = [](double unit, double chart) {
    const std::string l = digits(unit), c = digits(chart);
    const std::string radius = l + "*(2+cos(v/" + c + "))";
    return "cut-locus --surface '" + radius + "*cos(u/" + c + ")," + radius + "*sin(u/" + c + ")," +
           l + "*sin(v/" + c + ")' --periods " +
           list({6.283185307179586, 6.283185307179586}, chart) + " --point 0," +
           digits(.3 * chart) + " --spacing " + digits(.3 * chart) + " --radius " +
           digits(3 * unit) + " -o c.svg --report r.json --quiet";
  };
  const Dimensions on_surface = {{"radius", {1, 0, 0}}};
  expect_same_in_any_unit([&](double u) { return torus(u, 1); }, "c.svg", on_surface);
  expect_same_in_any_unit([&](double u) { return torus(1, u); }, "c.svg", {});
  expect_same_in_any_unit(
      [](double u) {
        return "cut-locus --surface '" + digits(u) + "*x," + digits(.8 * u) + "*y," +
               digits(.6 * u) +
               "*z' --point .3,.2,.7 --spacing .4 -o c.svg --report r.json --quiet" + " --radius " +
               digits(1.5 * u);
      },
      "c.svg", on_surface);
}

namespace {

const Dimensions of_scenes = {{"domain", {1, 0, 0}},
                              {"edge", {1, 0, 0}},
                              {"center", {1, 0, 0}},
                              {"radius", {1, 0, 0}},
                              {"from", {1, 0, 0}},
                              {"to", {1, 0, 0}},
                              {"wave_length", {1, 0, 0}},
                              {"level", {1, 0, 0}},
                              {"point", {1, 0, 0}},
                              {"box", {1, 0, 0}},
                              {"height_at", {1, 0, 0}},
                              {"velocity", {1, -1, 0}},
                              {"angular_velocity", {0, -1, 0}},
                              {"rate", {0, -1, 0}},
                              {"gravity", {1, -2, 0}},
                              {"density", {-3, 0, 1}},
                              {"viscosity", {-1, -1, 1}},
                              {"pressure", {-1, -2, 1}},
                              {"surface_tension", {0, -2, 1}},
                              {"labels", {0, 0, 0}},
                              {"time_step", {0, 1, 0}},
                              {"end", {0, 1, 0}}};

const Dimensions of_fluids = {{"volume", {3, 0, 0}},
                              {"wanted_volume", {3, 0, 0}},
                              {"lost_volume", {3, 0, 0}},
                              {"gained_volume", {3, 0, 0}},
                              {"volume_through_sides", {3, 0, 0}},
                              {"volumes_before", {3, 0, 0}},
                              {"volumes_after", {3, 0, 0}},
                              {"energy", {2, -2, 1}},
                              {"energy_before", {2, -2, 1}},
                              {"energy_moved", {2, -2, 1}},
                              {"kinetic_energy", {2, -2, 1}},
                              {"potential_energy", {2, -2, 1}},
                              {"surface_energy", {2, -2, 1}},
                              {"gas_energy", {2, -2, 1}},
                              {"momentum", {1, -1, 1}},
                              {"angular_momentum", {2, -1, 1}},
                              {"time", {0, 1, 0}},
                              {"dt", {0, 1, 0}},
                              {"greatest_velocity", {1, -1, 0}},
                              {"greatest_change_of_velocity", {1, -1, 0}},
                              {"greatest_correction", {1, -1, 0}},
                              {"depth_in_solids", {1, 0, 0}},
                              {"forces_on_solids", {1, -2, 1}},
                              {"torques_on_solids", {2, -2, 1}},
                              {"extent", {1, 0, 0}},
                              {"top", {1, 0, 0}},
                              {"where", {1, 0, 0}},
                              {"pressure", {-1, -2, 1}}};

// A droplet of 80 triangles, with some fields changed or added.
Json droplet(const std::string& fields) {
  Json scene = Json::parse(R"json({
    "domain": [-2.5, -2.5, -2.5, 2.5, 2.5, 2.5],
    "edge": 0.6,
    "liquids": [{"shape": {"type": "ball", "center": [0.03, 0.02, 0], "radius": 1, "triangles": 80},
                 "density": 1, "viscosity": 0.1, "velocity": [0.1, 0.05, -1]}],
    "surface_tension": 1,
    "gravity": [0, 0, -1],
    "probes": [{"name": "mode", "mode": 2, "center": [0, 0, 0]},
               {"name": "top", "height_at": [0.05, 0.02]}],
    "time_step": 0.05,
    "end": 0.15
  })json");
  scene.update(Json::parse(fields));
  return scene;
}

const std::string bubble = R"({
  "liquids": [{"label": 1, "density": 1,
               "shape": {"type": "ball", "center": [0, 0, 0], "radius": 1.2, "triangles": 80}}],
  "surface_tension": [{"labels": [0, 1], "value": 1}, {"labels": [1, 2], "value": 0.5}],
  "gases": [{"label": 2, "pressure": 3, "exponent": EXPONENT,
             "shape": {"type": "ball", "center": [0.1, 0, 0], "radius": 0.6, "triangles": 80}}]
})";

} // namespace

TEST_F(Any_unit, fluids) {
  const auto gas = [](const std::string& exponent) {
    return std::string(bubble).replace(bubble.find("EXPONENT"), 8, exponent);
  };
  for (const std::string& fields :
       {std::string(R"({"cfl": 0.25, "interface_tolerance": 0.01, "adaptation_interval": 1,
                           "end": 0.03})"),
        std::string(R"({"solids": [{"type": "plane", "point": [0, 0, -1.02], "normal": [0, 0, 1],
                                       "contact_angle": 70}]})"),
        std::string(R"({"solids": [{"type": "plane", "point": [0, 0, -1.02], "normal": [0, 0, 1],
                                       "sticks": true, "velocity": [0.1, 0, 0]}]})"),
        std::string(R"({"solids": [{"type": "cylinder", "point": [0.03, 0.02, 0], "radius": 1.05,
                                       "axis": [0, 0, 1], "liquid": "inside",
                                       "angular_velocity": [0, 0, 1]},
                                      {"type": "ball", "center": [0, 2.9, -1.3], "radius": 0.5}]})"),
        std::string(R"({"sources": [{"center": [0, 0, 0], "radius": 0.8, "rate": 1}],
                           "relaxation": {"time_step": 0.1, "steps": 3}})"),
        std::string(R"({"domain": [-1.5, -1.5, -1.5, 1.5, 1.5, 1.5], "liquids": [
               {"shape": {"type": "cylinder", "from": [-1, 0, 0], "to": [1, 0.1, 0.2],
                          "radius": 0.5, "amplitude": 0.1, "wave_length": 1}, "density": 1},
               {"shape": {"type": "surroundings"}, "density": 0.1, "viscosity": 0.01}],
               "probes": []})"),
        std::string(R"({"domain": [-1, -0.5, -1, 1, 0.5, 1], "edge": 0.35, "probes": [],
               "liquids": [{"shape": {"type": "pool", "level": 0}, "density": 1}],
               "solids": [{"type": "tank", "box": [-1, -0.5, -1, 1, 0.5, 1]}]})"),
        gas("1.4"), gas("1")}) {
    const Json scene = droplet(fields);
    const auto report_in = [&](const Units& units) {
      write("scene.json", scaled(scene, units, of_scenes).dump());
      return result_of("fluid scene.json --report r.json --quiet --threads 1", "").report;
    };
    const Json expected = report_in({});
    for (const Units& units : {Units{0x1p-30, 0x1p-11, 0x1p-63}, Units{0x1p60, 0x1p9, 0x1p20}}) {
      SCOPED_TRACE(scaled(scene, units, of_scenes).dump());
      expect_equal(scaled(expected, units, of_fluids), report_in(units));
    }
    for (const Units& units : {Units{1e-4, 1e-2, 1e-9}, Units{1e9, 1e4, 1e20}}) {
      SCOPED_TRACE(scaled(scene, units, of_scenes).dump());
      expect_near(scaled(expected, units, of_fluids), report_in(units), 2e-2);
    }
  }
}
