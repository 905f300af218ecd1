#include "program.h"

// `-` is standard input or standard output in all commands.
namespace {

using namespace program;

class Standard_streams : public Program_test
{
protected:
  void SetUp() override {
    Program_test::SetUp();
    write("box.off", box(0, 0, 0, 1, 1, 1));
  }

  // The end of the command hides the redirections of run().
  Outcome run_with_input(const std::string& file, const std::string& arguments) const {
    return run(arguments + " < " + file + " 2> stderr.txt #");
  }
};

TEST_F(Standard_streams, formats_are_known_by_first_bytes) {
  expect_success("convert box.off box.stl --quiet");
  expect_success("convert box.off box.obj --quiet");
  expect_success("convert box.off box.ply --quiet");
  expect_success("offset box.off --distance .01 --steps 1 --output run --quiet");
  expect_success("convert run/checkpoint.dsc box.mesh --quiet");
  for (const std::string file : {"box.off", "box.stl", "box.obj", "box.ply", "box.mesh",
                                 "run/checkpoint.dsc", "run/volume_000001.vtu"}) {
    SCOPED_TRACE(file);
    const Outcome by_name = run("info " + file), piped = run_with_input(file, "info -");
    EXPECT_EQ(piped.exit_code, 0) << piped.err;
    EXPECT_EQ(piped.out, by_name.out);
  }
}

TEST_F(Standard_streams, outputs_contain_only_the_file) {
  const Outcome report = run("offset box.off --distance .01 --steps 1 --report -");
  EXPECT_EQ(report.exit_code, 0);
  EXPECT_EQ(Json::parse(report.out).at("steps").size(), 2u);
  EXPECT_NE(report.err.find("dsc: step 1"), std::string::npos) << report.err;
  const Outcome picture = run("offset box.off --distance .01 --steps 1 --picture - --quiet");
  EXPECT_EQ(picture.out.substr(0, 4), "\x89PNG");
  EXPECT_EQ(picture.err, "");
  EXPECT_FALSE(fs::exists(path("-")));
}

// A program that leaves its input to another one has read it before.
TEST_F(Standard_streams, inputs_reach_other_programs) {
  expect_success("offset box.off --distance .01 --steps 1 --output run --quiet");
  expect_success("convert run/checkpoint.dsc box.mesh --quiet");
  const Outcome report =
      run_with_input("box.mesh", "offset - --distance .01 --steps 1 --report - --quiet");
  EXPECT_EQ(report.exit_code, 0) << report.err;
  EXPECT_EQ(Json::parse(report.out).at("input").dump(), "[\"standard input\"]");
  EXPECT_EQ(report.err, "");
  const Outcome improved = run_with_input("box.mesh", "improve - -o - --to vtu --quiet");
  EXPECT_NE(improved.out.find("<VTKFile"), std::string::npos) << improved.err;
  const Outcome page = run_with_input("run/volume_000001.vtu", "view - -o - --quiet");
  EXPECT_EQ(page.out.rfind("<!DOCTYPE html>", 0), 0u) << page.err;
  const Outcome resumed =
      run_with_input("run/checkpoint.dsc", "offset --resume - --steps 1 --report - --quiet");
  EXPECT_EQ(Json::parse(resumed.out).at("steps").back().at("step"), 2) << resumed.err;
  write("scene.json", run("fluid --print droplet").out);
  EXPECT_TRUE(Json::accept(run_with_input("scene.json", "fluid - --print").out));
}

TEST_F(Standard_streams, misuse_is_a_usage_error) {
  for (const char* arguments :
       {"offset box.off --distance .01 --report - --picture -", "offset - - --distance .01",
        "offset box.off --distance .01 --output -", "convert box.off -",
        "convert box.off - --to sub/off", "convert box.off x.obj --from off",
        "convert box.off x.obj --to obj", "info box.off --from off",
        "offset box.off --distance .01 --report - --to json"})
    expect_error(arguments, 2);
  expect_error("info -", 1); // empty
  write("numbers.txt", "1 2 3\n");
  const Outcome unknown = run_with_input("numbers.txt", "info -");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.err.find("--from"), std::string::npos) << unknown.err;
  EXPECT_EQ(run("convert box.off - --to obj > /dev/full")
                .err.rfind("dsc: cannot write to standard output", 0),
            0u);
}

TEST_F(Standard_streams, messages_are_short_lines) {
  const std::string digits(100000, '9');
  const std::vector<std::string> commands = {"offset box.off --distance " + digits,
                                             "offset " + digits + ".off --distance 1",
                                             "info 'x\033[31m.off'", "offset box.off --" + digits};
  for (const std::string& arguments : commands) {
    const Outcome outcome = run(arguments);
    EXPECT_LT(outcome.err.size(), 2000u);
    EXPECT_EQ(outcome.err.find('\033'), std::string::npos);
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
  }
}

TEST_F(Standard_streams, formats_that_do_not_fit_are_told_with_those_that_do) {
  const std::string list = run("convert box.off x.abc").err;
  for (const char* extension : {".off", ".vtk", ".nii.gz", ".svg"})
    EXPECT_NE(list.find(extension), std::string::npos) << list;
  fs::create_directory(path("folder"));
  EXPECT_NE(run("info folder").err.find("is a folder"), std::string::npos);
}

} // namespace
