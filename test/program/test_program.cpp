// Surfaces in motion, and features that all commands share.
#include "program.h"
#include "test.h"

#include <CGAL/Mesh_files/checkpoint.h>

namespace {

using namespace program;

const char* const octahedron = "OFF\n6 8 0\n1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n"
                               "3 0 2 4\n3 2 1 4\n3 1 3 4\n3 3 0 4\n"
                               "3 2 0 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n";

// All tests have the inputs in their folder.
class Program : public program::Program_test
{
protected:
  void SetUp() override {
    Program_test::SetUp();
    if (IsSkipped() || HasFatalFailure())
      return;
    write("octahedron.off", octahedron);
    write("cube.off", box(0, 0, 0, 1, 1, 1));
    write("cube_beside.off", box(2, 0, 0, 3, 1, 1));
  }
};

TEST_F(Program, says_what_it_can_do_without_arguments) {
  const Outcome outcome = run("");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, run("--help").out);
  EXPECT_PRED2(contains, outcome.out, "reconstruct");
}

TEST_F(Program, names_the_missing_program_of_a_command) {
#ifdef DSC_PROGRAM
  write("cube.off", box(0, 0, 0, 1, 1, 1));
  write("square.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 1))");
  write("cells.mesh", "");
  fs::copy_file(DSC_PROGRAM, path("dsc"));
  const std::string turn = " --axis 0,0,1 --angle 5 --steps 1";
  for (const auto& [arguments, program] : std::vector<std::array<std::string, 2>>{
           {"fluid --list", "dsc-fluid"},
           {"info cube.off", "dsc-full"},
           {"rotate cube.off --repair" + turn, "dsc-full"},
           {"rotate cells.mesh" + turn, "dsc-full"},
           {"rotate square.wkt --angle 5 --steps 1", "dsc-full"}}) {
    const Outcome outcome = run("", "./dsc " + arguments + " 2>stderr.txt; exit; ");
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_PRED2(contains, outcome.err, program + ", which contains");
  }
  EXPECT_EQ(run("", "./dsc rotate cube.off" + turn + " 2>stderr.txt; exit; ").exit_code, 0);
#endif
}

TEST_F(Program, draws_pictures) {
  write("cube.off", program::box(0, 0, 0, 1, 1, 1));
  const std::string cube = path("cube.off").string(), picture = path("cube.png").string();
  const Outcome outcome =
      run("rotate " + cube + " --axis 0,0,1 --angle 5 --steps 1 --picture " + picture);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string png = contents(picture);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  EXPECT_GT(png.size(), 1000u);
  EXPECT_EQ(run("rotate " + cube + " --axis 0,0,1 --angle 5 --picture a.jpg").exit_code, 2);
  EXPECT_NE(run("zalesak --steps 1 --picture " + picture).exit_code, 0);
}

TEST_F(Program, refuses_wrong_usage) {
  const std::string rotate = "rotate cube.off --axis 0,0,1 --angle 5 ";
  for (const std::string& arguments :
       std::vector<std::string>{"turn",
                                "rotate cube.off",
                                "rotate cube.off --axis 0,0,0 --angle 5",
                                "rotate cube.off --axis 0,0 --angle 5",
                                "rotate cube.off --axis 0,0,1,1 --angle 5",
                                "rotate cube.off --axis nan,0,1 --angle 5",
                                "rotate cube.off --axis 0,0,1 --angle nan",
                                "rotate cube.off --axis 0,0,1 --angle inf",
                                "rotate cube.off --axis 0,0,1 --angle 5x",
                                "rotate --axis 0,0,1 --angle 5",
                                "offset cube.off --distance nan",
                                "offset cube.off --distance 0.1f",
                                "offset cube.off --distance e",
                                "offset cube.off --distance 1ee",
                                "rotate cube.xyz --axis 0,0,1 --angle 5",
                                "rotate cube --axis 0,0,1 --angle 5",
                                "info cube.txt",
                                "convert a.dsc out.xyz",
                                "convert a.dsc",
                                "convert a.dsc out.off --subdivide 0",
                                "convert a.dsc out.off --subdivide 6",
                                "convert a.dsc out.off --subdivide x",
                                "convert a.dsc out.vtu --subdivide 1",
                                "convert a.dsc out.mesh --subdivide 1",
                                "convert a.dsc out.wkt --subdivide 1",
                                "info"})
    expect_error(arguments, 2);
  for (const std::string& option : std::vector<std::string>{
           "--steps 0", "--steps -3", "--steps x", "--steps 1.5", "--threads 0", "--threads -1",
           "--triangles 0", "--triangles -4", "--output out --every -1", "--every 2",
           "--output out --every 0", "--resume checkpoint.dsc", "--colour red"})
    expect_error(rotate + option, 2);
  expect_error("rotate --resume a.dsc --triangles 100 --axis 0,0,1 --angle 5", 2);
}

TEST_F(Program, refuses_bad_input) {
  const std::string motion = " --distance 0.01 --steps 1";
  write("empty.off", "");
  write("text.off", "this is not a surface\n");
  write("open.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  write("infinite.off", box(0, 0, 0, 1, 1, 1).replace(11, 1, "inf"));
  write("damaged.dsc", "this is not a checkpoint");
  write("flat.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n"
                     "1 1 0 0\nTetrahedra\n1\n1 2 3 4 1\nEnd\n");
  fs::create_directory(path("folder.json"));
  for (const std::string& arguments :
       std::vector<std::string>{"offset missing.off" + motion,
                                "offset empty.off" + motion,
                                "offset text.off" + motion,
                                "offset open.off" + motion,
                                "offset infinite.off" + motion,
                                "offset open.off --triangles 100" + motion,
                                "offset --resume missing.dsc" + motion,
                                "offset --resume damaged.dsc" + motion,
                                "offset cube.off --output cube.off" + motion,
                                "offset cube.off --output cube.off/below" + motion,
                                "offset cube.off --report missing/report.json" + motion,
                                "offset cube.off --report folder.json" + motion,
                                "info missing.off",
                                "info missing.dsc",
                                "info missing.mesh",
                                "info flat.mesh",
                                "info damaged.dsc",
                                "info text.off",
                                "convert missing.dsc out.off",
                                "convert damaged.dsc out.off"})
    expect_error(arguments, 1);
}

TEST_F(Program, names_the_bad_surface) {
  write("open.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const Outcome outcome = run("offset cube.off open.off --distance 0.01");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_PRED2(contains, outcome.err, "open.off");
}

TEST_F(Program, finds_an_unwritable_folder_first) {
  expect_error("offset missing.off --distance 0.01 --output cube.off/below", 1);
  EXPECT_PRED2(contains, contents(path("stderr.txt")), "cube.off/below");
}

TEST_F(Program, prints_help) {
  for (const std::string arguments : {"--help", "info --help", "rotate --help", "offset --help",
                                      "convert --help", "improve --help", "enright --help",
                                      "vortex --help", "advect --help", "mean-curvature --help"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_NE(outcome.out, "");
    EXPECT_EQ(outcome.err, "");
  }
}

TEST_F(Program, prints_one_line_or_nothing) {
  const std::string arguments = "rotate octahedron.off --axis 1,1,1 --angle 3 --steps 2";
  const Outcome loud = run(arguments);
  EXPECT_EQ(std::count(loud.out.begin(), loud.out.end(), '\n'), 1) << loud.out;
  EXPECT_EQ(loud.err, ""); // no progress line in a file
  EXPECT_EQ(run(arguments + " --quiet").out, "");
}

TEST_F(Program, informs_about_surfaces) {
  EXPECT_EQ(info("cube.off", "vertices"), 8);
  EXPECT_EQ(info("cube.off", "triangles"), 12);
  EXPECT_EQ(info("cube.off", "Euler characteristic"), 2);
  EXPECT_EQ(info("cube.off", "area"), 6);
  EXPECT_EQ(info("cube.off", "volume"), 1);
  EXPECT_EQ(info("cube.off", "angles"), 45);
}

TEST_F(Program, reports_each_step) {
  write("large.off", box(100, 100, 100, 110, 110, 110));
  expect_success("rotate large.off --axis 0,0,-2 --angle 5 --steps 3 --report report.json");
  const Json report = this->report("report.json");
  EXPECT_EQ(report.at("input"), Json::array({"large.off"}));
  EXPECT_EQ(report.at("parameters").at("command"), "rotate");
  EXPECT_EQ(report.at("parameters").at("angle"), 5);
  EXPECT_GT(report.at("sweep_seconds").get<double>(), 0);
  ASSERT_EQ(report.at("steps").size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const Json& step = report.at("steps")[i];
    std::set<std::string> keys;
    for (const auto& item : step.items())
      keys.insert(item.key());
    EXPECT_EQ(keys, (std::set<std::string>{"step",
                                           "time",
                                           "seconds",
                                           "sweeps",
                                           "complete",
                                           "unfinished_vertices",
                                           "parts",
                                           "passes",
                                           "vertices",
                                           "tetrahedra",
                                           "interface_triangles",
                                           "labels",
                                           "min_dihedral",
                                           "max_dihedral",
                                           "dihedral_histogram",
                                           "dihedrals_outside_6_171",
                                           "min_quality",
                                           "split",
                                           "collapsed",
                                           "flipped",
                                           "relabeled",
                                           "stopped_at_boundary",
                                           "cells_below_floor",
                                           "estimated_error",
                                           "events",
                                           "balance"}));
    EXPECT_EQ(step.at("step"), i);
    EXPECT_EQ(step.at("time"), double(i));
    EXPECT_EQ(step.at("complete"), true);
    EXPECT_EQ(step.at("unfinished_vertices"), 0);
    EXPECT_EQ(step.at("cells_below_floor"), 0);
    EXPECT_NEAR(step.at("sweeps").get<double>(),
                step.at("seconds").get<double>() / report.at("sweep_seconds").get<double>(),
                1e-9 * step.at("sweeps").get<double>());
    const auto histogram = step.at("dihedral_histogram").get<std::vector<std::size_t>>();
    EXPECT_EQ(histogram.size(), 18u);
    std::size_t angles = 0;
    for (const std::size_t n : histogram)
      angles += n;
    EXPECT_EQ(angles, 6 * step.at("tetrahedra").get<std::size_t>());
    EXPECT_GT(step.at("min_dihedral").get<double>(), 0);
    EXPECT_LT(step.at("max_dihedral").get<double>(), 180);
    EXPECT_GT(step.at("min_quality").get<double>(), 0);

    ASSERT_EQ(step.at("labels").size(), 2u);
    const Json& solid = label_of(step, 1);
    EXPECT_NEAR(solid.at("volume").get<double>(), 1000, 1e-6);
    EXPECT_NEAR(solid.at("area").get<double>(), 600, 1e-6);
    EXPECT_EQ(solid.at("components"), 1);
    EXPECT_EQ(solid.at("euler_characteristic"), 2);
    EXPECT_EQ(label_of(step, 0).at("tetrahedra").get<std::size_t>() +
                  solid.at("tetrahedra").get<std::size_t>(),
              step.at("tetrahedra").get<std::size_t>());
  }
  EXPECT_EQ(report.at("steps")[0].at("seconds"), 0);
  EXPECT_EQ(contents(path("report.json")).find("nan"), std::string::npos);
  EXPECT_FALSE(fs::exists(path("report.partial.json")));
}

// Temporary files may have any name.
TEST_F(Program, keeps_files_that_are_not_its_own) {
  for (const char* name : {"report.json.probe", "report.partial.json"})
    std::ofstream(path(name)) << "precious";
  expect_success("rotate cube.off --axis 0,0,1 --angle 2 --steps 1 --report report.json");
  for (const char* name : {"report.json.probe", "report.partial.json"})
    EXPECT_EQ(contents(path(name)), "precious") << name;
}

TEST_F(Program, gives_several_surfaces_labels) {
  expect_success(
      "rotate cube.off cube_beside.off --axis 1,0,0 --angle 2 --steps 1 --report r.json");
  const Json step = report("r.json").at("steps")[1];
  ASSERT_EQ(step.at("labels").size(), 3u);
  for (int label : {1, 2})
    EXPECT_NEAR(label_of(step, label).at("volume").get<double>(), 1, 1e-9);
}

TEST_F(Program, offsets_in_units_of_the_input) {
  write("large.off", box(100, 100, 100, 110, 110, 110));
  const std::string arguments = "offset large.off --triangles 300 --steps 1 --report r.json ";
  const auto volumes = [&](const std::string& distance) {
    expect_success(arguments + "--distance " + distance);
    const Json steps = report("r.json").at("steps");
    return std::make_pair(label_of(steps[0], 1).at("volume").get<double>(),
                          label_of(steps[1], 1).at("volume").get<double>());
  };
  const auto [before, outwards] = volumes("0.1");
  EXPECT_NEAR(before, 1000, 1e-6);
  EXPECT_GT(outwards, 1000 + 0.7 * 60); // area times distance, minus the loss at the edges
  EXPECT_LT(outwards, 1000 + 1.2 * 60);
  EXPECT_LT(volumes("-0.1").second, 1000 - 0.7 * 60);
  // 300 triangles on an area of 600: edges are slightly longer than 2
  EXPECT_GT(volumes("0.1e").second, 1000 + 0.7 * 0.1 * 1.8 * 600);
}

TEST_F(Program, resamples) {
  expect_success(
      "rotate cube.off --axis 0,0,1 --angle 1 --steps 1 --triangles 900 --report fine.json "
      "--output fine");
  EXPECT_EQ(report("fine.json").at("steps")[0].at("interface_triangles"), 900);
  expect_success("convert fine/checkpoint.dsc fine.off");
  expect_success("rotate fine.off --axis 0,0,1 --angle 1 --steps 1 --triangles 200 "
                 "--report coarse.json");
  const Json step = report("coarse.json").at("steps")[0];
  EXPECT_NEAR(step.at("interface_triangles").get<double>(), 200, 10);
  EXPECT_NEAR(label_of(step, 1).at("volume").get<double>(), 1, 0.01);
}

TEST_F(Program, tracks_and_resamples_parts_that_touch) {
  // Two tetrahedra at an edge; a bipyramid around another edge, with the same three edges.
  write("parts.off", "OFF\n6 8 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0\n0 0 -1\n"
                     "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"
                     "3 0 4 1\n3 0 1 5\n3 1 4 5\n3 0 5 4\n");
  write("shell.off", "OFF\n7 12 0\n0 0 0\n4 0 0\n0 4 0\n1 1 -3\n1 1 3\n1 1 -1\n1 1 1\n"
                     "3 0 1 4\n3 1 2 4\n3 2 0 4\n3 1 0 3\n3 2 1 3\n3 0 2 3\n"
                     "3 0 1 6\n3 1 2 6\n3 2 0 6\n3 1 0 5\n3 2 1 5\n3 0 2 5\n");
  const std::pair<const char*, double> volumes[] = {{"parts", 1. / 3.}, {"shell", 32. / 3.}};
  for (const auto& [name, volume] : volumes) {
    SCOPED_TRACE(name);
    const std::string run = " --axis 1,2,3 --angle 1 --steps 1 --report " + std::string(name);
    const auto check = [&, name = name, volume = volume](const char* report_name, double triangles,
                                                         double tolerance) {
      const Json step = report(name + std::string(report_name)).at("steps")[0];
      EXPECT_NEAR(step.at("interface_triangles").get<double>(), triangles, tolerance);
      EXPECT_NEAR(label_of(step, 1).at("volume").get<double>(), volume, 1e-6);
      EXPECT_EQ(label_of(step, 1).at("components"), 2);
    };
    expect_success("rotate " + std::string(name) + ".off --triangles 300" + run +
                   "_fine.json --output fine_" + name);
    check("_fine.json", 300, 30);
    expect_success("convert fine_" + std::string(name) + "/checkpoint.dsc fine_" + name + ".off");
    expect_success("rotate fine_" + std::string(name) + ".off --triangles 100" + run +
                   "_coarse.json");
    check("_coarse.json", 100, 20);
  }
}

TEST_F(Program, tracks_surfaces_that_touch) {
  write("at_an_edge.off", box(1, 1, 0, 2, 2, 1));
  const std::string run = "rotate cube.off at_an_edge.off --axis 1,2,3 --angle 1 --steps 1 ";
  expect_success(run + "--report r.json");
  const Json step = report("r.json").at("steps")[0];
  EXPECT_EQ(step.at("interface_triangles"), 24);
  EXPECT_NEAR(label_of(step, 1).at("volume").get<double>(), 1, 1e-12);
  EXPECT_NEAR(label_of(step, 2).at("volume").get<double>(), 1, 1e-12);
  expect_error(run + "--triangles 100", 1);
}

TEST_F(Program, writes_every_step_asked_for) {
  expect_success(
      "rotate octahedron.off --axis 1,2,3 --angle 2 --steps 5 --output new/out --every 2");
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(path("new/out")))
    names.insert(entry.path().filename().string());
  EXPECT_EQ(names,
            (std::set<std::string>{"checkpoint.dsc", "interface.pvd", "interface_000000.vtu",
                                   "interface_000002.vtu", "interface_000004.vtu",
                                   "interface_000005.vtu", "volume.pvd", "volume_000000.vtu",
                                   "volume_000002.vtu", "volume_000004.vtu", "volume_000005.vtu"}));
  for (const char* collection : {"new/out/volume.pvd", "new/out/interface.pvd"})
    for (const char* step : {"_000000", "_000002", "_000004", "_000005"})
      EXPECT_PRED2(contains, contents(path(collection)), step);
}

TEST_F(Program, resumes_to_the_same_bits) {
  const std::string motions[] = {"rotate --axis 1,2,3 --angle 7 ", "offset --distance 0.2e "};
  for (const std::string& motion : motions) {
    SCOPED_TRACE(motion);
    const std::string input = "octahedron.off cube_beside.off --triangles 100 ";
    write("cube_beside.off", box(1.5, 0, 0, 2.5, 1, 1));
    expect_success(motion + input + "--steps 4 --output whole");
    expect_success(motion + input + "--steps 2 --output parts");
    expect_success(motion + "--resume parts/checkpoint.dsc --steps 2 --threads 2 --output parts "
                            "--report r.json");
    for (const char* name : {"checkpoint.dsc", "volume.pvd", "interface.pvd", "volume_000004.vtu",
                             "interface_000004.vtu"})
      EXPECT_TRUE(contents(path("whole") / name) == contents(path("parts") / name)) << name;
    const Json steps = report("r.json").at("steps");
    ASSERT_EQ(steps.size(), 3u);
    EXPECT_EQ(steps[0].at("step"), 2);
    EXPECT_EQ(steps[2].at("time"), 4);
    EXPECT_EQ(report("r.json").at("input"), Json::array({"octahedron.off", "cube_beside.off"}));
    fs::remove_all(path("whole"));
    fs::remove_all(path("parts"));
  }
}

TEST_F(Program, goes_on_as_before_where_it_is_not_told_otherwise) {
  const std::string motion = "rotate octahedron.off --axis 1,2,3 --angle 7 --improve-interface ";
  expect_success(motion + "--steps 3 --output whole");
  expect_success(motion + "--steps 2 --output parts");
  const Outcome same = run("rotate --resume parts/checkpoint.dsc --steps 1 --output parts");
  EXPECT_EQ(same.exit_code, 0);
  EXPECT_EQ(std::count(same.out.begin(), same.out.end(), '\n'), 1) << same.out;
  EXPECT_TRUE(contents(path("whole/checkpoint.dsc")) == contents(path("parts/checkpoint.dsc")));

  const std::string go_on =
      " --resume parts/checkpoint.dsc --steps 1 --output parts --report r.json ";
  const Outcome other_angle = run("rotate" + go_on + "--angle 2 --improve-interface=false");
  EXPECT_PRED2(contains, other_angle.out,
               "step 3; --angle, --improve-interface differ from the previous run\n");
  EXPECT_EQ(run("rotate" + go_on + "--axis 1,2,3 --quiet").out, "");
  const Json parameters = report("r.json").at("parameters");
  EXPECT_EQ(parameters.at("axis"), Json::array({1, 2, 3}));
  EXPECT_EQ(parameters.at("angle"), 2);
  EXPECT_EQ(parameters.at("improve_interface"), false);

  expect_error("offset" + go_on, 2); // the distance is missing
  const Outcome other_motion = run("offset" + go_on + "--distance 0.1e");
  EXPECT_PRED2(contains, other_motion.out, "step 5; the command changes from rotate to offset\n");
}

// A complex alone is not a run, even in a checkpoint of the program.
TEST_F(Program, resumes_only_runs) {
  expect_success("rotate octahedron.off --axis 0,0,1 --angle 5 --steps 1 --output out");
  const auto checkpoint = CGAL::IO::read_checkpoint(path("out/checkpoint.dsc").string());
  Json without_motion = Json::parse(checkpoint.metadata);
  without_motion.at("parameters").erase("angle");
  for (const std::string& metadata :
       std::vector<std::string>{"", "6", "{}", "step 6", without_motion.dump()}) {
    CGAL::IO::write_checkpoint(path("library.dsc").string(), checkpoint.state, metadata);
    expect_error("rotate --resume library.dsc --axis 0,0,1 --angle 5", 1);
    EXPECT_EQ(info("library.dsc", "tetrahedra"), info("out/checkpoint.dsc", "tetrahedra"));
  }
}

TEST_F(Program, does_not_keep_moments_that_are_undone) {
  const std::string motion = "rotate --axis 0,0,1 --angle 7 ";
  expect_success(motion + "octahedron.off --steps 1 --output short");
  expect_success(motion + "octahedron.off --steps 3 --output long");
  fs::copy_file(path("short/checkpoint.dsc"), path("long/checkpoint.dsc"),
                fs::copy_options::overwrite_existing);
  expect_success(motion + "--resume long/checkpoint.dsc --steps 1 --output long");
  EXPECT_EQ(contents(path("long/volume.pvd")).find("volume_000003"), std::string::npos);
  EXPECT_PRED2(contains, contents(path("long/volume.pvd")), "volume_000002");
}

TEST_F(Program, keeps_the_results_of_other_runs) {
  const std::string motion = "rotate --axis 0,0,1 --angle 7 --steps 1 --output ";
  expect_success(motion + "out octahedron.off");
  expect_success(motion + "other octahedron.off");
  const std::string before = contents(path("out/checkpoint.dsc"));
  expect_error(motion + "out octahedron.off", 1);
  expect_error(motion + "out --resume other/checkpoint.dsc", 1);
  EXPECT_TRUE(contents(path("out/checkpoint.dsc")) == before);
  expect_success(motion + "out --resume out/checkpoint.dsc");
}

TEST_F(Program, goes_back_to_the_last_step_when_interrupted) {
  const std::string arguments =
      "rotate octahedron.off --axis 0,0,1 --angle 1 --steps 10000000 --report r.json";
  for (const char* signal : {"INT", "TERM"}) {
    const std::string prefix = std::string("timeout --preserve-status -s ") + signal + " 1";
    const Outcome outcome = run(arguments, prefix);
    EXPECT_EQ(outcome.exit_code, 130);
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    const unsigned step = report("r.json").at("steps").back().at("step");
    EXPECT_EQ(info("dsc_interrupted.dsc", "step"), step);
    fs::remove(path("dsc_interrupted.dsc"));

    EXPECT_EQ(run(arguments + " --quiet --output out", prefix).exit_code, 130);
    EXPECT_FALSE(fs::exists(path("dsc_interrupted.dsc")));
    EXPECT_EQ(info("out/checkpoint.dsc", "step"), report("r.json").at("steps").back().at("step"));
    fs::remove_all(path("out"));
  }
}

TEST_F(Program, converts) {
  expect_success("offset octahedron.off --distance 0.01 --steps 1 --output out");
  for (const std::string format : {"off", "obj", "ply", "stl"}) {
    SCOPED_TRACE(format);
    expect_success("convert out/checkpoint.dsc interface." + format);
    EXPECT_EQ(info("interface." + format, "Euler characteristic"), 2);
    EXPECT_NEAR(info("interface." + format, "volume"), 4. / 3, 0.1);
  }
  expect_success("convert out/checkpoint.dsc all.mesh");
  EXPECT_EQ(info("all.mesh", "tetrahedra"), info("out/checkpoint.dsc", "tetrahedra"));
  EXPECT_EQ(info("all.mesh", "interface triangles"),
            info("out/checkpoint.dsc", "interface triangles"));
  expect_success("convert out/checkpoint.dsc all.vtu");
  EXPECT_TRUE(contents(path("all.vtu")) == contents(path("out/volume_000001.vtu")));
}

TEST_F(Program, converts_to_subdivided_surfaces) {
  expect_success("offset octahedron.off --distance 0.01 --steps 1 --output out");
  const double triangles = info("out/checkpoint.dsc", "interface triangles");
  for (const std::string format : {"off", "obj", "ply", "stl"}) {
    SCOPED_TRACE(format);
    expect_success("convert out/checkpoint.dsc interface." + format + " --subdivide 2");
    EXPECT_EQ(info("interface." + format, "triangles"), 16 * triangles);
    EXPECT_EQ(info("interface." + format, "Euler characteristic"), 2);
    EXPECT_LT(info("interface." + format, "volume"), 4. / 3); // smooth
    EXPECT_GT(info("interface." + format, "volume"), 4. / 3 / 4);
  }
}

TEST_F(Program, does_not_depend_on_the_number_of_threads) {
  const std::string arguments =
      "offset cube.off --triangles 400 --distance 0.2e --steps 2 --output ";
  expect_success(arguments + "one --threads 1");
  expect_success(arguments + "two --threads 2");
  EXPECT_TRUE(contents(path("one/checkpoint.dsc")) == contents(path("two/checkpoint.dsc")));
}

} // namespace
