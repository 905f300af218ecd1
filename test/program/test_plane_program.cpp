#include "all_cases.h"
#include "program.h"
#include "test.h"

// Planar commands of the program from outside.

namespace {

using namespace program;

class Planar_program : public Program_test
{
protected:
  void SetUp() override {
    Program_test::SetUp();
    write("square.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n");
    write("two.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\nPOLYGON ((2 0, 3 0, 3 1, 2 1, 2 0))\n");
    write("half.poly", "4 2\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 1 3\n"
                       "0\n1\n1 .9 .1 5\n");
    write("image.pgm", "P2 6 6 9\n0 0 0 0 0 0\n0 0 4 4 0 0\n0 4 4 4 4 0\n0 4 4 4 4 0\n"
                       "0 0 4 4 0 0\n0 0 0 0 0 0\n");
    write("cube.off",
          "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
  }

  Json label(const Json& step, int wanted) const {
    for (const Json& label : step.at("labels"))
      if (label.at("label") == wanted)
        return label;
    ADD_FAILURE() << "no label " << wanted;
    return {};
  }

  Json last_step(const std::string& arguments) const {
    expect_success(arguments + " --quiet --report report.json");
    return report("report.json").at("steps").back();
  }
};

} // namespace

TEST_F(Planar_program, refuses_what_belongs_to_space) {
  for (const std::string arguments :
       {"rotate square.wkt --angle 5 --axis 0,0,1", "rotate square.wkt",
        "offset square.wkt --distance .1 --move-faces", "enright square.wkt",
        "offset square.wkt cube.off --distance .1",
        "offset square.wkt --distance .1 --triangles 99",
        "offset cube.off --distance .1 --segments 99", "zalesak cube.off",
        "vortex cube.off --plane", "rotate cube.off --angle 5",
        "advect square.wkt --velocity x,y,z",
        "offset square.wkt --distance .1 --domain 0,0,0,1,1,1", "vortex square.wkt --fit",
        "offset half.poly square.wkt --distance .1",
        "offset square.wkt --distance .1 --corners sharp"})
    expect_error(arguments, 2);
  write("open.wkt", "POLYGON ((0 0, 1 0, 1 1))");
  write("crossing.wkt", "POLYGON ((0 0, 1 1, 1 0, 0 1, 0 0))");
  for (const std::string arguments :
       {"offset open.wkt --distance .1", "offset crossing.wkt --distance .1",
        "offset nowhere.wkt --distance .1", "offset square.wkt --distance .1 --domain .5,.5,2,2"})
    expect_error(arguments, 1);
}

TEST_F(Planar_program, rotates_and_is_back) {
  const Json step = last_step("rotate two.wkt --angle 30 --steps 12");
  EXPECT_NEAR(label(step, 1).at("area"), 1, 1e-12);
  EXPECT_NEAR(label(step, 2).at("length"), 4, 1e-12);
  EXPECT_EQ(label(step, 0).at("euler_characteristic"), -1);
  EXPECT_EQ(step.at("unfinished_vertices"), 0);
  EXPECT_GT(step.at("min_angle").get<double>(), 1);
}

// The area of a unit square after an offset by d is 1 + 4 d + pi d^2 with round corners.
TEST_F(Planar_program, offsets_with_round_corners) {
  const double pi = std::acos(-1.);
  const double area =
      label(last_step("offset square.wkt --distance .05 --steps 2 --corners round --output round"),
            1)
          .at("area");
  EXPECT_NEAR(area, 1.4 + .01 * pi, 1e-3);
  const Json sharp = last_step("offset square.wkt --distance .05 --steps 2");
  EXPECT_NEAR(label(sharp, 1).at("area"), 1.44, 1e-12);
  // A resumed run keeps the rule.
  const Json next = last_step("offset --resume round/checkpoint.dsc --steps 1");
  EXPECT_NEAR(label(next, 1).at("area"), 1.6 + .0225 * pi, 2e-3);
}

TEST_F(Planar_program, offsets_what_merges) {
  const Json step = last_step("offset two.wkt --segments 80 --distance .15 --steps 2");
  EXPECT_EQ(step.at("interface_segments").get<int>() > 40, true);
  EXPECT_GT(label(step, 1).at("area").get<double>() + label(step, 2).at("area").get<double>(), 3);
}

TEST_F(Planar_program, brings_back_zalesaks_disk) {
  const Json step = last_step("zalesak --segments 60 --dt 15.7 --steps 40");
  EXPECT_NEAR(label(step, 1).at("area"), 582.2070, 1e-4);
  EXPECT_LT(step.at("distance_to_start").at("maximum"), 1e-9);
}

TEST_F(Planar_program, stirs_a_disk_there_and_back) {
  const Json step =
      last_step("vortex --plane --segments 60 --improve-interface --period 1 --dt .05 --steps 20");
  EXPECT_NEAR(label(step, 1).at("area").get<double>(), .0706858, 1.2e-4);
  EXPECT_LT(step.at("distance_to_start").at("maximum"), .05);
}

TEST_F(Planar_program, shortens_curves) {
  const double exact = 1 - .04 * 2 * 3.14159265;
  const std::string arguments = "mean-curvature square.wkt --segments 80 --dt .002 --steps 20";
  EXPECT_NEAR(label(last_step(arguments + " --tolerance 0"), 1).at("area"), exact, .005);
  EXPECT_NEAR(label(last_step(arguments), 1).at("area"), exact, .01); // its mesh is adapted
  const Json kept =
      last_step("mean-curvature square.wkt --segments 80 --dt .01 --steps 4 --keep-volumes");
  EXPECT_NEAR(label(kept, 1).at("area"), 1, 1e-9);
}

TEST_F(Planar_program, reads_segments_and_images) {
  const Json step = last_step("advect half.poly --velocity .1,0 --dt 1 --steps 1");
  EXPECT_NEAR(label(step, 5).at("area"), .5, 1e-9);
  EXPECT_NEAR(label(last_step("advect image.pgm --velocity .1,0 --dt 1 --steps 1"), 4).at("area"),
              12, 1.5);
  EXPECT_EQ(info("two.wkt", "interface segments"), 8);
}

TEST_F(Planar_program, reads_segments_without_regions) {
  const std::string square = "4 2 0 1\n0 0 0 1\n1 1 0 1\n2 1 1 1\n3 0 1 1\n";
  write("square.poly", square + "4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n");
  const Json step = last_step("offset square.poly --distance .1 --steps 1");
  EXPECT_GT(label(step, 1).at("area").get<double>(), 1.2);
  write("diagonal.poly", square + "5 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n4 0 2\n0\n");
  const Outcome told = run("info diagonal.poly");
  EXPECT_PRED2(contains, told.err, "not used: 4 boundary markers");
  EXPECT_PRED2(contains, told.err, "not used: 1 segment with the same label");
  EXPECT_EQ(run("advect diagonal.poly --velocity 1,0 --dt .1 --steps 1 --quiet").err, "");
  write("open.poly", "3 2\n0 0 0\n1 1 0\n2 1 1\n2 0\n0 0 1\n1 1 2\n0\n");
  expect_error("offset open.poly --distance .1", 1);
  write("covered.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 0)) POLYGON ((0 0, 1 0, 1 1, 0 0))");
  EXPECT_PRED2(contains, run("info covered.wkt").err, "1 curve covered by later curves");
  write("point.wkt", "POINT EMPTY");
  EXPECT_EQ(run("info point.wkt").exit_code, 1);
}

TEST_F(Planar_program, moves_images_with_and_without_room_around) {
  write("halves.pgm", "P2 6 4 9\n1 1 1 2 2 2\n1 1 1 2 2 2\n1 1 2 2 2 2\n1 1 2 2 2 2\n");
  Json step = last_step("mean-curvature halves.pgm --dt .2 --steps 3");
  EXPECT_NEAR(label(step, 1).at("area").get<double>() + label(step, 2).at("area").get<double>(), 24,
              1e-9);
  step = last_step("mean-curvature halves.pgm --domain=-3,-3,9,7 --dt .01 --steps 1");
  EXPECT_NEAR(label(step, 0).at("area").get<double>() + label(step, 1).at("area").get<double>() +
                  label(step, 2).at("area").get<double>(),
              120, 1e-9);
  EXPECT_EQ(last_step("mean-curvature halves.pgm --dt .2 --steps 3 --domain 0,0,6,4").at("labels"),
            last_step("mean-curvature halves.pgm --dt .2 --steps 3").at("labels"));
  expect_error("mean-curvature halves.pgm --domain 0,0,9,9", 1);
  write("gray.pgm", "P2 2 2 9\n3 3 3 3\n");
  expect_error("mean-curvature gray.pgm", 1);
  step = last_step("offset gray.pgm --domain=-5,-5,7,7 --distance .5 --steps 1");
  // a square of side length 2, whose corners are round after the motion
  EXPECT_NEAR(label(step, 3).at("area").get<double>(), 8 + std::acos(-1) / 4, .25);
  expect_error("mean-curvature halves.pgm --edge .1", 1);
}

TEST_F(Planar_program, resumes_to_the_same_bits) {
  const std::string vortex = "vortex --plane --segments 40 --period 1 --dt .05 --quiet ";
  expect_success(vortex + "--steps 4 --output whole");
  expect_success(vortex + "--steps 2 --output parts");
  expect_success("vortex --resume parts/checkpoint.dsc --steps 2 --quiet --output parts");
  EXPECT_EQ(contents(path("whole/checkpoint.dsc")), contents(path("parts/checkpoint.dsc")));
  EXPECT_TRUE(fs::exists(path("whole/picture_000004.svg")));
  EXPECT_TRUE(fs::exists(path("whole/volume_000004.vtu")));
  EXPECT_EQ(info("whole/checkpoint.dsc", "step"), 4);
  expect_error("convert whole/checkpoint.dsc out.off", 2);
  expect_error("convert whole/checkpoint.dsc out.off --subdivide 1", 2);
  expect_error("vortex --plane --output out --subdivide 1", 2);
  for (const std::string format : {"wkt", "poly", "svg", "vtu"})
    expect_success("convert whole/checkpoint.dsc out." + format + " --quiet");
  EXPECT_NEAR(last_step("rotate out.wkt --angle 1 --steps 1").at("labels")[1].at("area"), .0706858,
              1e-3);
}

TEST_F(Planar_program, lets_grains_grow) {
  for (const std::string arguments :
       {"--number 1", "--dimension 4", "--energy iron", "--until 1", "--edges 1", "--step -1",
        "--dimension 3 --picture a.svg", "--picture a.png", "--every 2", "--largest-angle x",
        "--domain ball", "--resume a.dsc --seed 2", "--particles 1 --particle-radius .01"})
    expect_error("grains " + arguments, 2);
  const std::string begin = "grains --number 12 --edges 6 --step .3 --quiet --steps ",
                    small = begin + "30 ";
  expect_success(small + "--report a.json --picture a.svg --output grains --every 15");
  const Json isotropic = report("a.json");
  ASSERT_EQ(isotropic.at("steps").size(), 31u);
  EXPECT_EQ(isotropic.at("steps")[0].at("grains"), 12);
  EXPECT_NEAR(isotropic.at("law").at("slope").get<double>(), 1, .1);
  for (const Json& rate : isotropic.at("law").at("rates"))
    if (rate.at("number") > 50) {
      EXPECT_NEAR(rate.at("rate").get<double>(),
                  std::acos(-1.) / 3 * (rate.at("sides").get<double>() - 6), .2);
    }
  double area = 0, sides = 0;
  for (const Json& grain : isotropic.at("grains")) {
    area += grain.at("area").get<double>();
    sides += grain.at("sides").get<double>();
  }
  EXPECT_NEAR(area, 1, 1e-9);
  EXPECT_EQ(sides, 6. * double(isotropic.at("grains").size())); // Euler's formula on a torus
  EXPECT_PRED2(contains, contents(path("grains/volume.pvd")), "volume_000030.vtu");
  EXPECT_PRED2(contains, contents(path("grains/interface_000030.vtu")), "misorientation");
  expect_success("view grains --report a.json -o grains.html --quiet");
  expect_success("view grains --surface -o surface.html --quiet");
  EXPECT_PRED2(contains, contents(path("a.svg")), "<svg");
  expect_error(small + "--output grains", 1); // contains a run
  // The same bits again; other grains with another seed
  expect_success(small + "--report b.json --threads 2");
  EXPECT_EQ(report("b.json").at("steps"), isotropic.at("steps"));
  expect_success(small + "--report b.json --seed 2");
  EXPECT_NE(report("b.json").at("steps"), isotropic.at("steps"));
  // The same bits from a checkpoint
  expect_success(begin + "15 --output half");
  expect_error("grains --resume half/checkpoint.dsc --output half", 1);
  expect_error("grains --resume a.json", 1);
  expect_success("grains --resume half/checkpoint.dsc --steps 15 --report b.json --output whole "
                 "--quiet");
  const Json resumed = report("b.json").at("steps");
  ASSERT_EQ(resumed.size(), 16u);
  EXPECT_EQ(resumed.back(), isotropic.at("steps").back());
  EXPECT_EQ(contents(path("whole/checkpoint.dsc")), contents(path("grains/checkpoint.dsc")));
  // The same bits with particles in a box, which are made again
  const std::string pinned_in_box = begin + "10 --particles 5 --domain box ";
  expect_success(pinned_in_box + "--report b.json --output box --every 5");
  expect_success(
      "grains --number 12 --edges 6 --step .3 --quiet --steps 5 --particles 5 --domain box "
      "--output half_box");
  expect_success("grains --resume half_box/checkpoint.dsc --steps 5 --output rest --quiet");
  EXPECT_EQ(contents(path("rest/checkpoint.dsc")), contents(path("box/checkpoint.dsc")));
  // A box, whose laws count right angles at its sides
  expect_success(small + "--domain box --report b.json --picture b.svg");
  EXPECT_NEAR(report("b.json").at("law").at("slope").get<double>(), 1, .1);
  // Particles stop the growth.
  expect_success("grains --number 30 --edges 6 --particles 40 --until .1 --report b.json --quiet "
                 "--output pinned --every 100000");
  const Json pinned = report("b.json");
  EXPECT_GT(pinned.at("grains").size(), 5u);
  EXPECT_FALSE(pinned.contains("law"));
  double in_grains = 0;
  for (const Json& grain : pinned.at("grains"))
    in_grains += grain.at("area").get<double>();
  const double disks = 40 * std::acos(-1.) * .04 / 30;
  EXPECT_NEAR(1 - in_grains, disks, .05 * disks);
  expect_error("grains --particles 1000", 1); // no room
  expect_error("grains --particle-radius .3", 2);
  // Energies by misorientation
  expect_success(small + "--report b.json --energy read-shockley");
  const Json steps = report("b.json").at("steps");
  for (std::size_t k = 1; k < steps.size(); ++k)
    EXPECT_LT(steps[k].at("energy").get<double>(), steps[k - 1].at("energy").get<double>()) << k;
  EXPECT_FALSE(report("b.json").contains("law"));
  for (const Json& boundary : report("b.json").at("boundaries"))
    EXPECT_LE(boundary.at("misorientation").get<double>(), 45 + 1e-9);
  // A table of energies, and the distributions. Twice the tension gives twice the energy.
  std::ofstream(path("energy.txt")) << "0 2 # angle, tension\n\n45 2 .5\n";
  expect_success(small + "--report c.json --energy energy.txt --plot plot.svg");
  EXPECT_NEAR(report("c.json").at("steps")[0].at("energy").get<double>(),
              2 * isotropic.at("steps")[0].at("energy").get<double>(), 1e-9);
  EXPECT_PRED2(contains, contents(path("plot.svg")), "misorientation");
  for (const std::string table :
       {"", "0", "0 -1", "0 1 0", "0 1\n0 2", "0 x", "0 1 1 1", "nan 1"}) {
    std::ofstream(path("bad.txt")) << table;
    expect_error(small + "--energy bad.txt", 1);
  }
  expect_error(small + "--energy missing.txt", 1);
}

namespace {

/// Returns an image (.inr) of 8 bits with a bright disk on dark ground.
std::string image_of_disk(int n) {
  std::string header = "#INRIMAGE-4#{\nXDIM=" + std::to_string(n) + "\nYDIM=" + std::to_string(n) +
                       "\nZDIM=1\nVDIM=1\nTYPE=unsigned fixed\nPIXSIZE=8 bits\nCPU=decm\n"
                       "VX=0.5\nVY=0.5\nVZ=1\n";
  header.append(256 - header.size() - 4, '\n');
  std::string voxels;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x)
      voxels += char(std::hypot(x - n / 2., y - n / 2.) < n / 4. ? 200 : 50);
  return header + "##}\n" + voxels;
}

} // namespace

TEST_F(Planar_program, segments_images) {
  std::ofstream(path("disk.inr"), std::ios::binary) << image_of_disk(40);
  expect_success("segment disk.inr -o disk.svg -o disk.vtu -o disk.dsc -o disk.wkt --picture "
                 "disk.png --mesh mesh.vtu --report disk.json --quiet");
  const Json disk = report("disk.json");
  EXPECT_TRUE(disk.at("converged").get<bool>());
  ASSERT_EQ(disk.at("phases").size(), 2u);
  EXPECT_NEAR(disk.at("phases")[1].at("intensities")[0].get<double>(), 200, 10);
  EXPECT_NEAR(disk.at("phases")[1].at("area").get<double>(), std::acos(-1.) * 25, 4);
  EXPECT_NEAR(disk.at("boundaries")[0].at("length").get<double>(), 2 * std::acos(-1.) * 5, 1.5);
  EXPECT_EQ(disk.at("statistics").at("labels")[1].at("components"), 1);
  for (const std::string file :
       {"disk.svg", "disk.vtu", "disk.dsc", "disk.wkt", "disk.png", "mesh.vtu"})
    EXPECT_TRUE(fs::exists(path(file))) << file;
  // From a given complex, and with the same bits
  expect_success("segment disk.inr --start disk.dsc --keep-topology --report again.json --quiet");
  EXPECT_EQ(report("again.json").at("phases")[1].at("components"), 1);
  expect_success("segment disk.inr --threads 2 -o second.dsc --quiet");
  EXPECT_EQ(contents(path("second.dsc")), contents(path("disk.dsc")));
  // Given intensities stay.
  expect_success("segment disk.inr --intensities 40,210 --report given.json --quiet");
  EXPECT_EQ(report("given.json").at("phases")[0].at("intensities")[0], 40);
  for (const std::string arguments :
       {"", "disk.inr --phases 1", "disk.inr --intensities 1,x",
        "disk.inr --intensities 1,2 --phases 3", "disk.inr --intensities 3",
        "disk.inr --smoothing 0", "disk.inr -o a.off", "disk.inr -o disk.inr",
        "disk.inr --picture a.svg"})
    expect_error("segment " + arguments, 2);
  for (const std::string arguments : {"missing.inr", "disk.inr --phases 9",
                                      "disk.inr --start disk.inr", "disk.inr --mask disk.vtu"})
    expect_error("segment " + arguments, 1);
  std::ofstream(path("short.inr"), std::ios::binary) << image_of_disk(40).substr(0, 1500);
  expect_error("segment short.inr", 1);
}

TEST_F(Planar_program, lets_grains_grow_on_a_torus_in_space) {
  expect_success("grains --dimension 3 --number 6 --edges 4 --step .3 --steps 3 --quiet "
                 "--report a.json");
  const Json grown = report("a.json"), steps = grown.at("steps");
  double volume = 0;
  for (const Json& grain : grown.at("grains"))
    volume += grain.at("volume").get<double>();
  EXPECT_NEAR(volume, 1, 1e-12);
  for (std::size_t k = 1; k < steps.size(); ++k)
    EXPECT_LT(steps[k].at("energy").get<double>(), steps[k - 1].at("energy").get<double>());
}

TEST_F(Planar_program, finds_cut_loci) {
  for (const std::string arguments :
       {"", "--point 0", "--point 0,0 --surface u,v", "--point 0,0 --surface u+,v,1",
        "--point 0,0 --spacing 0", "--point 0,0 -o a.png"})
    expect_error("cut-locus " + arguments, 2);
  expect_error("cut-locus --point 0,0 --spacing 1", 1);
  expect_error("cut-locus --point 0,0 --surface u,0,0", 1);
  // The default surface is the same torus by formulas.
  const std::string torus =
      all_cases() ? " --surface '(2+cos(v))*cos(u),(2+cos(v))*sin(u),sin(v)'" : "";
  expect_success("cut-locus --point 0,0 --spacing .3 --quiet -o a.svg --report a.json" + torus);
  const Json locus = report("a.json");
  double farthest = 0;
  for (const Json& vertex : locus.at("vertices"))
    farthest = (std::max)(farthest, vertex.at("distance").get<double>());
  EXPECT_NEAR(farthest, 7.63112309, .01);
  EXPECT_PRED2(contains, contents(path("a.svg")), "cut_locus");
}

TEST_F(Planar_program, finds_cut_loci_of_surfaces_like_a_sphere) {
  for (const std::string arguments :
       {"ellipsoid --point 0,0", "torus --point 1,0,0", "u,v,x --point 1,0,0",
        "1,2,3 --point 1,0,0", "ellipsoid --point 1,0,0 --radius 0",
        "ellipsoid --point 1,0,0 -o a.vtu"})
    expect_error("cut-locus --surface " + arguments, 2);
  expect_error("cut-locus --surface ellipsoid --point 0,0,0", 1);
  expect_error("cut-locus --surface x,0,0 --point 1,0,0", 1);
  if (all_cases()) { // a sphere
    expect_success(
        "cut-locus --surface x,y,z --point 1,2,3 --spacing .4 --quiet --report a.json -o a.svg");
    ASSERT_EQ(report("a.json").at("vertices").size(), 1u);
    EXPECT_NEAR(report("a.json").at("vertices")[0].at("distance").get<double>(), std::acos(-1.),
                1e-6);
  }
  expect_success(
      "cut-locus --point 1,0,0 --surface x,y,.8*z --spacing .2 --quiet -o a.svg --report a.json");
  EXPECT_TRUE(report("a.json").at("is_complete").get<bool>());
  const Json locus = report("a.json");
  EXPECT_EQ(locus.at("arcs").size(), 1u);
  for (const Json& vertex : locus.at("vertices"))
    if (vertex.at("multiplicity") == 1) {
      EXPECT_NEAR(vertex.at("distance").get<double>(), .8 * std::acos(-1.), 1e-6);
    }
}

TEST_F(Planar_program, draws_balls_of_surfaces) {
  expect_error("cut-locus --point 0,0 --radius .01", 2);
  expect_success("cut-locus --point 0,0 --radius 2 --quiet -o a.svg --report a.json");
  EXPECT_NEAR(report("a.json").at("ball").at("radius").get<double>(), 2, 1e-12);
  expect_success("cut-locus --surface ellipsoid --point 1,0,0 --radius .7 --quiet -o a.vtu");
  EXPECT_PRED2(contains, contents(path("a.vtu")), "UnstructuredGrid");
}
