#include "processes.h"
#include "test.h"

// Fluids that PETSc solves in several processes.
namespace {

using namespace program;

class Petsc_fluids : public Processes_test
{
protected:
  std::set<std::string> files(const std::string& folder) const {
    std::set<std::string> result;
    for (const auto& entry : fs::directory_iterator(path(folder)))
      result.insert(entry.path().filename().string());
    return result;
  }
};

TEST_F(Petsc_fluids, agree_with_built_in_solver) {
  const std::string command = "fluid droplet --steps 4 --report ";
  ASSERT_EQ(run(command + "one.json").exit_code, 0);
  const Json expected = report("one.json").at("steps");
  for (int processes : {1, 2, 4}) {
    SCOPED_TRACE(processes);
    const std::string file = std::to_string(processes) + ".json",
                      folder = std::to_string(processes);
    const Outcome outcome = run(
        command + file + " --solver petsc --output " + folder + " -ksp_view", mpirun(processes));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(lines(outcome.out, "dsc: "), 1u) << outcome.out; // the summary
    EXPECT_PRED2(contains, outcome.out, "type: fgmres");
    const Json found = report(file).at("steps");
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 1; k < found.size(); ++k) {
      EXPECT_EQ(found[k].at("vertices"), expected[k].at("vertices"));
      EXPECT_NEAR(found[k].at("volume"), expected[k].at("volume"), 1e-9);
      EXPECT_NEAR(found[k].at("probes").at("amplitude"), expected[k].at("probes").at("amplitude"),
                  1e-5);
      EXPECT_LT(found[k].at("residual"), 1e-8);
    }
    EXPECT_EQ(files(folder),
              (std::set<std::string>{"checkpoint.dsc", "interface.pvd", "interface_000000.vtu",
                                     "interface_000001.vtu", "interface_000002.vtu",
                                     "interface_000003.vtu", "interface_000004.vtu", "volume.pvd",
                                     "volume_000000.vtu", "volume_000001.vtu", "volume_000002.vtu",
                                     "volume_000003.vtu", "volume_000004.vtu"}));
  }
}

// The first process continues from its own checkpoint; the others read it.
TEST_F(Petsc_fluids, resume) {
  ASSERT_EQ(run("fluid droplet --solver petsc --steps 1 --output run", mpirun(2)).exit_code, 0);
  const Outcome outcome =
      run("fluid --resume run/checkpoint.dsc --solver petsc --steps 1 --output run", mpirun(2));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(files("run").count("volume_000002.vtu"), 1u);
}

TEST_F(Petsc_fluids, print_errors_once) {
  for (const std::string arguments :
       {"fluid dropelt", "fluid droplet --sterps 3", "fluid droplet --end 0"})
    expect_one_error(arguments + " --solver petsc");
}

TEST_F(Petsc_fluids, name_unused_options_of_petsc) {
  const Outcome outcome =
      run("fluid droplet --steps 1 --solver petsc -ksp_tipe gcr -ksp_type gcr", mpirun(2));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(lines(outcome.err, "dsc: "), 1u) << outcome.err;
  EXPECT_PRED2(contains, outcome.err, "-ksp_tipe;");
}

// The first process alone writes the report, so it alone meets the error.
TEST_F(Petsc_fluids, end_if_the_first_process_fails) {
  expect_one_error("fluid droplet --steps 3 --solver petsc --report no/report.json");
}

TEST_F(Petsc_fluids, stop_together) { expect_stop("fluid droplet --end 1000 --solver petsc", 4); }

} // namespace
