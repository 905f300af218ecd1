#include "program.h"
#include "test.h"

// No data are lost: long operations stop on request, results are written completely or not at all,
// and failed writing is reported.
namespace {

using namespace program;
using fs::directory_iterator;

class Stopping : public program::Program_test
{
protected:
  std::set<std::string> files() const {
    std::set<std::string> result;
    for (const auto& entry : directory_iterator(path("")))
      result.insert(entry.path().filename().string());
    result.erase("stderr.txt");
    return result;
  }

  // Starts a long command, interrupts it, and expects that it wrote nothing.
  void expect_stops(const std::string& arguments, const std::string& signal,
                    const std::string& seconds = "0.7") const {
    SCOPED_TRACE(arguments + ", " + signal);
    const std::set<std::string> before = files();
    const Outcome outcome =
        run(arguments, "timeout --preserve-status -s " + signal + ' ' + seconds);
    EXPECT_EQ(outcome.exit_code, 130) << outcome.err << outcome.out;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err.rfind("dsc: interrupted", 0), 0u) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(files(), before);
  }

  // A closed surface of 20 n^2 / 2 triangles.
  std::string sphere(int n) const {
    std::ostringstream off;
    const int m = 2 * n;
    off << "OFF\n" << m * (n - 1) + 2 << ' ' << 2 * m * (n - 1) << " 0\n0 0 1\n0 0 -1\n";
    for (int i = 1; i < n; ++i)
      for (int j = 0; j < m; ++j) {
        const double a = M_PI * i / n, b = 2 * M_PI * j / m;
        off << std::sin(a) * std::cos(b) << ' ' << std::sin(a) * std::sin(b) << ' ' << std::cos(a)
            << '\n';
      }
    const auto at = [&](int i, int j) { return 2 + (i - 1) * m + j % m; };
    for (int j = 0; j < m; ++j) {
      off << "3 0 " << at(1, j) << ' ' << at(1, j + 1) << '\n';
      off << "3 1 " << at(n - 1, j + 1) << ' ' << at(n - 1, j) << '\n';
      for (int i = 1; i + 1 < n; ++i)
        off << "3 " << at(i, j) << ' ' << at(i + 1, j) << ' ' << at(i + 1, j + 1) << "\n3 "
            << at(i, j) << ' ' << at(i + 1, j + 1) << ' ' << at(i, j + 1) << '\n';
    }
    return off.str();
  }
};

const std::string ball_in_box = "'x^2+y^2+z^2<.5' --domain -1,-1,-1,1,1,1";

TEST_F(Stopping, building_stops) {
  write("sphere.off", sphere(250));
  for (const char* signal : {"INT", "TERM", "HUP"})
    expect_stops("offset " + ball_in_box + " --edge .012 --distance .001", signal);
  expect_stops("offset sphere.off --distance .001", "INT");
  expect_stops("offset sphere.off --triangles 400000 --distance .001", "INT");
}

TEST_F(Stopping, a_long_step_stops_and_the_one_before_is_kept) {
  expect_success("enright --period 50 --dt .01 --steps 1 --output out --quiet");
  const Outcome outcome = run("enright --resume out/checkpoint.dsc --dt 5 --steps 5 --output out "
                              "--report r.json",
                              "timeout --preserve-status -s INT 2");
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  EXPECT_PRED2(contains, outcome.err, "--resume out/checkpoint.dsc");
  const int step = int(info("out/checkpoint.dsc", "step"));
  EXPECT_EQ(report("r.json").at("steps").back().at("step"), step);
}

TEST_F(Stopping, improvement_stops_and_keeps_its_input) {
  expect_success("offset " + ball_in_box + " --edge .07 --distance .001 --steps 1 --output out");
  expect_success("convert out/checkpoint.dsc mesh.vtu --quiet");
  const std::string before = contents(path("mesh.vtu"));
  expect_stops("improve --aggressive mesh.vtu -o mesh.vtu --report r.json", "INT", "1");
  EXPECT_TRUE(contents(path("mesh.vtu")) == before);
}

TEST_F(Stopping, other_commands_stop) {
  expect_stops("cut-locus --point 0.4,0.3 --spacing .05 -o out.svg", "INT", "0.4");
  const Outcome outcome =
      run("fluid dam-break --report r.json --quiet", "timeout --preserve-status -s TERM 1.5");
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  EXPECT_EQ(outcome.err.rfind("dsc: interrupted after step", 0), 0u) << outcome.err;
  expect_success("fluid --resume dsc_interrupted.dsc --steps 1 --quiet");
}

TEST_F(Stopping, a_reconstruction_keeps_the_previous_result) {
  std::ostringstream points;
  for (int i = 0; i < 40000; ++i) { // points of a spiral on a sphere
    const double z = 1 - (2 * i + 1) / 40000., r = std::sqrt(1 - z * z), a = 2.399963 * i;
    points << r * std::cos(a) << ' ' << r * std::sin(a) << ' ' << z << '\n';
  }
  write("points.xyz", points.str());
  write("out.off", "precious");
  expect_stops("reconstruct points.xyz -o out.off", "INT");
  EXPECT_EQ(contents(path("out.off")), "precious");
}

const std::string long_run = "enright --period 50 --dt .01 --steps 100000 --output out";

// A run in the background, until its first checkpoint; its number is in the file pid.
std::string in_background(const std::string& arguments) {
  return "(exec '" + executable + "' " + arguments +
         " >/dev/null 2>&1 & echo $! >pid); while ! [ -e out/checkpoint.dsc ]; do sleep .05; "
         "done; ";
}

TEST_F(Stopping, a_folder_belongs_to_one_run) {
  const Outcome second = run("grains --number 9 --output out", in_background(long_run));
  EXPECT_EQ(second.exit_code, 1);
  EXPECT_EQ(second.err.rfind("dsc: another run writes in the folder 'out' (process ", 0), 0u)
      << second.err;
  EXPECT_PRED2(contains, second.err, "enright --period 50");
  const std::string resume = "enright --resume out/checkpoint.dsc --steps 1 --quiet --output out";
  EXPECT_EQ(run(resume).exit_code, 1);
  run("--help", "kill -KILL $(cat pid); ");
  write("out/.partial-0123456789abcdef", "left by the killed run");
  expect_success(resume);
  for (const auto& entry : directory_iterator(path("out")))
    EXPECT_NE(entry.path().filename().string().front(), '.') << entry.path();
}

// The folder is moved away while the first state is written, or later. To remove it would take
// time, in which a state can be saved there.
TEST_F(Stopping, a_run_outlives_its_folder) {
  for (const char* file : {"checkpoint.dsc", "volume_000002.vtu"}) {
    SCOPED_TRACE(file);
    const std::string remover = std::string("{ (while ! [ -e out/") + file +
                                " ]; do sleep .002; done; mv out gone; mkdir out) >/dev/null & }; ";
    const Outcome outcome = run(long_run, remover);
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_EQ(outcome.err.rfind("dsc: ", 0), 0u) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_PRED2(contains, outcome.err, "is in dsc_failed.dsc");
    expect_success("enright --resume dsc_failed.dsc --steps 1 --quiet");
    for (const char* left : {"out", "gone", "dsc_failed.dsc"})
      fs::remove_all(path(left));
  }
}

// A link at the name of a result is replaced, and what it names stays.
TEST_F(Stopping, links_are_not_followed) {
  write("sphere.off", sphere(10));
  const std::string offset = "offset sphere.off --distance .01 --steps 1 --quiet ";
  for (const char* name : {"r.json", "p.png"}) {
    write(std::string("victim_") + name, "precious");
    fs::create_symlink(std::string("victim_") + name, path(name));
  }
  expect_success(offset + "--report r.json --picture p.png");
  EXPECT_EQ(contents(path("victim_r.json")), "precious");
  EXPECT_EQ(contents(path("victim_p.png")), "precious");
  fs::create_directory(path("out"));
  fs::create_symlink("../victim_r.json", path("out/.dsc-lock"));
  EXPECT_EQ(run(offset + "--output out").exit_code, 1);
  EXPECT_EQ(contents(path("victim_r.json")), "precious");
}

// A file size limit of some blocks: writing fails as on a full disk.
TEST_F(Stopping, what_cannot_be_written_leaves_what_was_there) {
  write("sphere.off", sphere(40));
  expect_success("offset sphere.off --distance .01 --steps 1 --output out");
  for (const char* name : {"x.off", "x.vtu", "x.mesh", "x.png", "x.stl", "x.ply", "x.obj"}) {
    SCOPED_TRACE(name);
    write(name, "precious");
    const auto before = files();
    const Outcome outcome = run(std::string("convert out/checkpoint.dsc ") + name, "ulimit -f 4; ");
    EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("dsc: cannot write", 0), 0u) << outcome.err;
    EXPECT_EQ(contents(path(name)), "precious");
    EXPECT_EQ(files(), before);
  }
}

TEST_F(Stopping, standard_output_that_fails_is_told) {
  write("sphere.off", sphere(10));
  for (const char* arguments : {"info sphere.off > /dev/full", "fluid --list > /dev/full",
                                "--help > /dev/full", "fluid --print dam-break > /dev/full",
                                "offset sphere.off --distance .01 --steps 1 > /dev/full"}) {
    SCOPED_TRACE(arguments);
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_EQ(outcome.err.rfind("dsc: cannot write to standard output", 0), 0u) << outcome.err;
  }
}

// The outputs of a command replace neither its inputs nor other outputs.
TEST_F(Stopping, outputs_have_places_of_their_own) {
  write("sphere.off", sphere(4));
  write("scene.json", run("fluid --print droplet").out);
  for (const char* arguments :
       {"fluid scene.json --report scene.json", "fluid scene.json --report x.png --picture x.png",
        "offset sphere.off --distance .01 --report x.png --picture x.png",
        "offset sphere.off --distance .01 --report ./sphere.off",
        "reconstruct sphere.off -o sphere.off", "reconstruct sphere.off -o x.off --report x.off"}) {
    const auto before = files();
    expect_error(arguments, 2);
    EXPECT_EQ(files(), before);
  }
}

} // namespace
