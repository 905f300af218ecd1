// The commands that move surfaces by flows, compared with exact properties of the flows.
#include "program.h"
#include "test.h"

namespace {

using namespace program;

double volume(const Json& step, int label = 1) { return label_of(step, label).at("volume"); }

// The volume of the sphere that is the initial surface of most flows.
const double volume_of_ball = 4 * std::acos(-1) / 3 * std::pow(.15, 3);

class Flows : public program::Program_test
{
protected:
  void SetUp() override {
    Program_test::SetUp();
    if (!IsSkipped() && !HasFatalFailure())
      write("box.off", box(100, 100, 100, 110, 110, 110));
  }

  Json steps(const std::string& arguments) const {
    expect_success(arguments + " --report report.json");
    return report("report.json").at("steps");
  }
};

// Moves away from the center of the box: lengths grow by exp(t).
const std::string expand = "advect box.off --velocity 'x-105,y-105,z-105' ";

TEST_F(Flows, refuse_wrong_usage) {
  for (const std::string& arguments : std::vector<std::string>{
           "advect box.off", "advect --velocity 1,0,0", "advect box.off --velocity 1,0",
           "advect box.off --velocity 1,0,0,0", "advect box.off --velocity '1,0,'",
           "advect box.off --velocity 'x,y,q'", "advect box.off --velocity 'x,y,sin('",
           "advect box.off --velocity ''", "advect box.off --velocity 1,0,0 --keep-volumes",
           "mean-curvature", "mean-curvature box.off --period 1", "enright --fit",
           "enright --resume a.dsc --fit", "advect box.off --velocity 1,0,0 --report box.off",
           "enright --domain 0,0,0,1,1", "enright --domain 0,0,0,1,1,0",
           "enright --resume a.dsc --domain 0,0,0,1,1,1", "enright box.xyz"})
    expect_error(arguments, 2);
  for (const std::string& option : std::vector<std::string>{
           "--dt 0", "--dt -1", "--dt nan", "--dt 1s", "--period 0", "--period -1", "--period inf",
           "--scheme rk3", "--aggressiveness 0.1", "--improve-interface --aggressiveness -1",
           "--improve-interface --aggressiveness x", "--improve-interface --aggressiveness 1",
           "--period 0.005"})
    expect_error("enright " + option, 2);
}

TEST_F(Flows, refuse_bad_input) {
  for (const std::string& arguments : std::vector<std::string>{
           "enright box.off", // outside the unit cube
           "vortex missing.off", "advect box.off --velocity '1/(x-x),0,0'",
           "advect box.off --velocity 'ln(-1),0,0'", "mean-curvature box.off --domain 0,0,0,1,1,1"})
    expect_error(arguments, 1);
}

TEST_F(Flows, advect_with_velocities_of_the_user) {
  const Json exact = steps(expand + "--dt 0.05 --steps 2");
  ASSERT_EQ(exact.size(), 3u);
  EXPECT_DOUBLE_EQ(exact[2].at("time").get<double>(), .1);
  EXPECT_NEAR(volume(exact[0]), 1000, 1e-8);
  EXPECT_NEAR(volume(exact[2]), 1000 * std::exp(.3), 1e-3);
  EXPECT_FALSE(exact[2].contains("distance_to_start"));

  const Json euler = steps(expand + "--dt 0.05 --steps 2 --scheme euler");
  EXPECT_NEAR(volume(euler[2]), 1000 * std::pow(1.05, 6), 1e-6);

  const Json faster = steps("advect box.off --velocity 't*(x-105),0,0' --dt 0.1 --steps 2");
  EXPECT_NEAR(volume(faster[2]), 1000 * std::exp(.02), 1e-3);
}

TEST_F(Flows, are_back_after_a_period) {
  const Json there_and_back = steps(expand + "--period 0.2 --dt 0.01 --steps 40");
  EXPECT_NEAR(volume(there_and_back[10]), 1000 * std::exp(.6 / std::acos(-1)), 1e-3);
  for (std::size_t i = 0; i < there_and_back.size(); ++i)
    EXPECT_EQ(there_and_back[i].contains("distance_to_start"), i == 20 || i == 40) << i;
  for (const int i : {20, 40}) {
    EXPECT_NEAR(volume(there_and_back[i]), 1000, 1e-3);
    const Json& distance = there_and_back[i].at("distance_to_start");
    EXPECT_LT(distance.at("mean").get<double>(), 1e-6);
    EXPECT_GE(distance.at("maximum").get<double>(), distance.at("mean").get<double>());
  }
  const Json half = steps(expand + "--period 0.4 --dt 0.4 --steps 1 --scheme euler");
  // Farther by 0.4 of the distance from the center, which is at least 5 on an edge of the box. The
  // edges have length 10, or are diagonals.
  const double mean_edge = 10 * (2 + std::sqrt(2.)) / 3;
  const double at_corners = .4 * 5 * std::sqrt(3.);
  EXPECT_NEAR(half[1].at("distance_to_start").at("maximum").get<double>(), at_corners / mean_edge,
              1e-9);
}

TEST_F(Flows, of_enright_deforms_the_ball_and_brings_it_back) {
  const Json ball = steps("enright --triangles 320 --period 0.08 --dt 0.02 --steps 4");
  EXPECT_EQ(ball[0].at("interface_triangles"), 320);
  EXPECT_NEAR(volume(ball[0]), volume_of_ball, .05 * volume_of_ball);
  EXPECT_NEAR(volume(ball[4]), volume(ball[0]), 1e-4 * volume(ball[0]));
  EXPECT_GT(label_of(ball[2], 1).at("area").get<double>(),
            1.0001 * label_of(ball[0], 1).at("area").get<double>());
  EXPECT_LT(ball[4].at("distance_to_start").at("maximum").get<double>(), 1e-3);
}

TEST_F(Flows, fit_surfaces_into_the_ball) {
  const Json step = steps("vortex box.off --fit --steps 1 --dt 0.001")[0];
  EXPECT_NEAR(volume(step), std::pow(.3 / std::sqrt(3.), 3), 1e-12);
}

TEST_F(Flows, of_the_vortex_stay_in_their_planes) {
  const Json vortex = steps("vortex --triangles 320 --dt 0.02 --steps 3 --improve-interface "
                            "--aggressiveness 0");
  EXPECT_NEAR(volume(vortex[3]), volume(vortex[0]), .002 * volume(vortex[0]));
  EXPECT_EQ(vortex[3].at("complete"), true);
}

TEST_F(Flows, keep_the_steps_before_one_that_is_refused) {
  const std::string flow = "advect box.off --velocity '5*sqrt(0.25-t)*(x-105),0,0' --dt 0.1 "
                           "--scheme euler --triangles 100 --improve-interface --every 5 ";
  // The velocities are NaN in the third step, before which the mesh was adapted.
  expect_error(flow + "--steps 5 --output out --report report.json", 1);
  EXPECT_EQ(report("report.json").at("steps").size(), 3u);
  expect_success(flow + "--steps 2 --output two");
  EXPECT_TRUE(contents(path("out/checkpoint.dsc")) == contents(path("two/checkpoint.dsc")));
}

// The time step is in the units of the input, for any enclosing box.
TEST_F(Flows, of_mean_curvature_shrink_a_ball) {
  const double radius = 10;
  expect_success("enright --triangles 1280 --dt 1e-9 --steps 1 --output ball");
  expect_success("convert ball/checkpoint.dsc ball.off");
  const double scale = radius / .15;
  std::istringstream in(program::contents(path("ball.off")));
  std::ostringstream out;
  std::string head;
  std::size_t points, triangles, edges;
  in >> head >> points >> triangles >> edges;
  out << head << '\n' << points << ' ' << triangles << ' ' << edges << '\n';
  for (std::size_t i = 0; i < 3 * points; ++i) {
    double x;
    in >> x;
    out << scale * (x - .35) << (i % 3 == 2 ? '\n' : ' ');
  }
  out << in.rdbuf();
  write("large_ball.off", out.str());

  const Json shrinks = steps("mean-curvature large_ball.off --dt 1 --steps 10");
  EXPECT_NEAR(std::cbrt(volume(shrinks[10]) / volume(shrinks[0])),
              std::sqrt(radius * radius - 4 * 10) / radius, .005);
  const Json stays = steps("mean-curvature large_ball.off --dt 1 --steps 3 --keep-volumes");
  EXPECT_NEAR(volume(stays[3]), volume(stays[0]), 1e-9 * volume(stays[0]));
  const double edge = stays[1].at("time").get<double>();
  EXPECT_EQ(edge, 1);
}

TEST_F(Flows, of_mean_curvature_end_with_nothing) {
  const Json steps_ = steps("mean-curvature box.off --triangles 300 --steps 40");
  const Json& last = steps_.back();
  EXPECT_EQ(last.at("interface_triangles"), 0);
  EXPECT_EQ(last.at("labels").size(), 1u);
  // The default time step is proportional to the square of the edge length.
  const double time = steps_[1].at("time");
  EXPECT_GT(time, 2);
  EXPECT_LT(time, 9);
}

TEST_F(Flows, of_mean_curvature_may_leave_the_mesh_of_the_interface) {
  expect_error("mean-curvature box.off --tolerance -1", 2);
  expect_error("mean-curvature box.off --tolerance .1 --improve-interface", 2);
  const Json last = steps("mean-curvature box.off --triangles 300 --steps 2 --tolerance 0").back();
  EXPECT_EQ(last.at("labels").size(), 2u);
  EXPECT_EQ(report("report.json").at("parameters").at("tolerance"), 0);
}

TEST_F(Flows, stop_at_the_boundary_or_let_it_grow) {
  const std::string outwards = "offset box.off --triangles 200 --distance 2 --steps 4 --domain ";
  const std::string domain = "96,96,96,114,114,114";
  Json steps_ = steps(outwards + domain);
  std::size_t stopped = 0;
  for (std::size_t i = 1; i < steps_.size(); ++i) {
    EXPECT_GE(volume(steps_[i]), volume(steps_[i - 1]));
    stopped += steps_[i].at("stopped_at_boundary").get<std::size_t>();
  }
  EXPECT_GT(stopped, 0u);
  EXPECT_PRED2(contains, run(outwards + domain).out, "--domain grow");

  const double whole = std::pow(18, 3);
  for (const char* growing : {"grow", "96,96,96,114,114,114,grow"}) {
    steps_ = steps(outwards + growing);
    EXPECT_GT(volume(steps_.back()), whole) << growing;
    for (const Json& step : steps_)
      EXPECT_EQ(step.at("stopped_at_boundary"), 0);
  }
  expect_error("offset box.off --distance 1 --domain growth", 2);
  expect_error("offset 'x<1' --distance 1 --domain grow", 2);
}

// Without --dt, the fastest vertex moves by a mean edge, and steps end with the period.
TEST_F(Flows, choose_a_time_step) {
  const double mean_edge = 10 * (2 + std::sqrt(2.)) / 3;
  const Json step = steps("advect box.off --velocity '0,4,3' --steps 1")[1];
  EXPECT_NEAR(step.at("time").get<double>(), mean_edge / 5, 1e-9);
  EXPECT_PRED2(contains, run("advect box.off --velocity '0,4,3' --steps 1").out,
               "the time step is 2.27");
  const Json back = steps("advect box.off --velocity '0,4,3' --period 5 --steps 3");
  EXPECT_NEAR(back[3].at("time").get<double>(), 5, 1e-9);
  EXPECT_LT(back[3].at("distance_to_start").at("maximum").get<double>(), 1e-6);
}

TEST_F(Flows, divide_steps_as_far_as_they_are_told) {
  const std::string turn = "advect box.off --velocity '105-y,x-105,0' --dt 1.5 --steps 1 ";
  EXPECT_NEAR(volume(steps(turn)[1]), 1000, .05);
  EXPECT_GT(report("report.json").at("steps")[1].at("parts").get<int>(), 2);
  EXPECT_EQ(steps(turn + "--largest-displacement 0")[1].at("parts"), 1);
  const int half = steps(turn + "--largest-displacement .25")[1].at("parts");
  EXPECT_GT(half, 5);
  expect_error(turn + "--largest-displacement -1", 2);
  expect_error(turn + "--largest-displacement x", 2);
}

// The volumes are those of the start of the run, also after a resume.
TEST_F(Flows, keep_the_volumes_of_the_start) {
  write("other.off", box(100, 100, 110, 110, 110, 118)); // on the box, with a wall
  const std::string flow = "mean-curvature --dt .2 --keep-volumes ";
  const Json start = steps(flow + "box.off other.off --steps 3 --output out --domain grow")[0];
  const Json last = steps(flow + "--resume out/checkpoint.dsc --steps 3").back();
  for (const int label : {1, 2})
    EXPECT_NEAR(volume(last, label) / volume(start, label), 1, 1e-6) << label;
}

TEST_F(Flows, tell_of_thin_parts_that_stay_coarse) {
  write("plate.off", box(0, 0, 0, 100, 100, 1));
  const std::string motion = "offset plate.off --distance .1 --steps 1 ";
  const Json resolved = steps(motion + "--edge-per-thickness 8")[0];
  EXPECT_GT(resolved.at("interface_triangles").get<int>(), 400);
  EXPECT_PRED2(contains, run(motion + "--most-new-facets 100").out,
               "more facets would resolve them");
  EXPECT_EQ(steps(motion + "--edge-per-thickness 0")[0].at("interface_triangles"), 12);
  const std::string turn = "rotate plate.off --axis 0,0,1 --angle 10 --steps 1 ";
  EXPECT_EQ(steps(turn)[1].at("interface_triangles"), 12);
  for (const char* wrong : {"--edge-per-thickness .5", "--edge-per-thickness -1",
                            "--most-new-facets -1", "--edge-per-thickness 3 --resume a.dsc"})
    expect_error(turn + wrong, 2);
}

// A vanished surface has no distance to the start.
TEST_F(Flows, are_resumed) {
  const std::string flow = "enright --period 0.08 --dt 0.02 ";
  const auto distance_after_resuming = [&](const std::string& inputs) {
    expect_success(flow + inputs + " --triangles 100 --steps 2 --output out");
    const Json last = steps(flow + "--resume out/checkpoint.dsc --steps 2").back();
    fs::remove_all(path("out"));
    return last.contains("distance_to_start")
               ? last.at("distance_to_start").at("mean").get<double>()
               : -1;
  };
  const double of_ball = distance_after_resuming("");
  EXPECT_GE(of_ball, 0);
  EXPECT_LT(of_ball, 1e-3);
  const double of_box = distance_after_resuming("box.off --fit");
  EXPECT_GE(of_box, 0);
  EXPECT_LT(of_box, 1e-2);

  // Without its input, a run resumes without the distances to the start.
  expect_success(flow + "box.off --fit --steps 2 --output out");
  fs::remove(path("box.off"));
  const Json last = steps(flow + "--resume out/checkpoint.dsc --steps 2").back();
  EXPECT_FALSE(last.contains("distance_to_start"));
}

// A plate of twelve triangles, whose cells are all flat.
TEST_F(Flows, keep_a_plate_of_twelve_triangles) {
  write("plate.off", box(0, 0, 0, 50, 50, 1));
  for (const double d : {.05, -.05, .2}) {
    const Json moved = steps("offset plate.off --steps 1 --distance=" + std::to_string(d));
    const double exact = (50 + 2 * d) * (50 + 2 * d) * (1 + 2 * d);
    EXPECT_NEAR(volume(moved[1]), exact, 1e-3 * exact) << d;
    const Json balance = report("report.json").at("balance");
    ASSERT_EQ(balance.size(), 2u);
    EXPECT_NEAR(balance[1].at("volume_before").get<double>(), 2500, 1e-6);
    EXPECT_NEAR(balance[1].at("volume_swept").get<double>(), exact - 2500, 1e-3 * exact);
    EXPECT_NEAR(balance[1].at("volume_unexplained").get<double>(), 0, 1e-3 * exact);
  }
  EXPECT_EQ(run("mean-curvature plate.off --steps 1 --dt 0.001").out.find("vanished"),
            std::string::npos);
}

TEST_F(Flows, tell_of_labels_that_vanish_and_of_divided_steps) {
  write("small.off", box(0, 0, 0, 1, 1, 1));
  const std::string shrunk = run("offset small.off --steps 2 --distance=-0.3").out;
  EXPECT_PRED2(contains, shrunk, "label 1 (step 2) vanished");
  const std::string turned = run("rotate small.off --axis 0,0,1 --angle 180 --steps 1").out;
  EXPECT_PRED2(contains, turned, "was too long");
}

} // namespace
