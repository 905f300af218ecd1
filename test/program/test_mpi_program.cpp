#include "all_cases.h"
#include "processes.h"
#include "test.h"

#include <chrono>

// Runs of several processes that hold a complex together.
namespace {

using namespace program;

class Mpi_runs : public Processes_test
{
protected:
  void SetUp() override {
    Processes_test::SetUp();
    write("cube.off", program::box(-1, -1, -1, 1, 1, 1));
  }

  // Returns the steps of a report without the times.
  Json steps(const std::string& file) const {
    Json result = report(file).at("steps");
    for (Json& step : result) {
      step.erase("seconds");
      step.erase("sweeps");
    }
    return result;
  }
};

TEST_F(Mpi_runs, give_the_same_complex_for_any_number_of_processes) {
  std::vector<std::string> commands = {
      "offset cube.off --triangles 500 --distance -0.5e --steps 8",
      "enright --triangles 800 --dt .05 --steps 6",
      "advect --velocity 'sin(7*y),sin(9*z),cos(8*x)' cube.off --triangles 500 --dt .02 --steps "
      "3"};
  if (all_cases())
    commands.insert(commands.end(),
                    {"rotate cube.off --triangles 500 --axis 1,2,3 --angle 9 --steps 2",
                     "mean-curvature cube.off --triangles 500 --steps 3"});
  for (const std::string& command : commands) {
    SCOPED_TRACE(command);
    Json expected;
    for (int processes : {1, 2, 5}) {
      if (processes == 2 && !all_cases())
        continue;
      const Outcome outcome = run(command + " --report report.json", mpirun(processes));
      ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
      EXPECT_EQ(lines(outcome.out, "dsc: step"), 1u) << outcome.out;
      if (processes == 1)
        expected = steps("report.json");
      else
        EXPECT_EQ(steps("report.json"), expected) << processes;
    }
  }
}

TEST_F(Mpi_runs, agree_with_one_process) {
  for (const std::string command : {"mean-curvature cube.off --triangles 500 --steps 3",
                                    "enright --triangles 800 --dt .05 --steps 10"}) {
    SCOPED_TRACE(command);
    ASSERT_EQ(run(command + " --report two.json", mpirun(2)).exit_code, 0);
    ASSERT_EQ(run(command + " --report one.json").exit_code, 0);
    const Json one = steps("one.json"), two = steps("two.json");
    for (std::size_t k = 0; k < one.size(); ++k) {
      const double volume = program::label_of(one[k], 1).at("volume");
      EXPECT_NEAR(program::label_of(two[k], 1).at("volume"), volume, 1e-2 * volume);
    }
    const double cells = one.back().at("tetrahedra");
    EXPECT_NEAR(two.back().at("tetrahedra"), cells, .1 * cells);
  }
}

TEST_F(Mpi_runs, resume_with_another_number_of_processes) {
  const std::string command = "offset cube.off --triangles 500 --distance 0.3e ";
  ASSERT_EQ(run(command + "--steps 4 --report all.json", mpirun(2)).exit_code, 0);
  ASSERT_EQ(run(command + "--steps 2 --output run", mpirun(3)).exit_code, 0);
  const std::string resume = "offset --resume run/checkpoint.dsc --steps 2 --output run ";
  const Outcome outcome = run(resume + "--report rest.json", mpirun(2));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(steps("rest.json").back(), steps("all.json").back());
  EXPECT_TRUE(fs::exists(path("run/volume_000004.pvtu")));
  EXPECT_TRUE(fs::exists(path("run/interface_000004_1.vtu")));
  // One process without mpirun names the remedy, and several can resume the run of one.
  const Outcome alone = run(resume);
  EXPECT_EQ(alone.exit_code, 1);
  EXPECT_PRED2(contains, alone.err, "mpirun");
  ASSERT_EQ(run(command + "--steps 1 --output one").exit_code, 0);
  EXPECT_EQ(run("offset --resume one/checkpoint.dsc --steps 1", mpirun(2)).exit_code, 0);
}

TEST_F(Mpi_runs, print_errors_once) {
  std::vector<std::string> calls = {"offset missing.off --distance 1",
                                    "offset cube.off --distanse 1", "offset --resume missing.dsc",
                                    "advect --velocity 'x/0,0,0' cube.off --triangles 200"};
  if (all_cases())
    calls.insert(calls.end(), {"zalesak", "offset cube.off --distance 1 --move-faces",
                               "offset cube.off --distance 0.1e --steps 1 --report no/folder.json",
                               "rotate cube.off --axis 0,0,1 --angle 5 --improve-interface",
                               "enright --scheme adaptive"});
  for (const std::string& arguments : calls)
    expect_one_error(arguments);
}

// One process is killed in a step. All processes end, and the run continues from the checkpoint
// with another number of processes.
TEST_F(Mpi_runs, continue_after_a_process_was_killed) {
  const std::string command = "offset cube.off --triangles 2000 --distance 0.1e ";
  const std::string rest = command + "--steps 100000 --output run";
  const Outcome killed = run(
      rest + " : -n 1 timeout --preserve-status -s KILL 3 '" DSC_PROGRAM "' " + rest, mpirun(1));
  EXPECT_NE(killed.exit_code, 0);
  EXPECT_PRED2(contains, killed.err, "illed"); // mpirun names the signal
  const Outcome resumed =
      run("offset --resume run/checkpoint.dsc --steps 1 --report rest.json", mpirun(3));
  ASSERT_EQ(resumed.exit_code, 0) << resumed.err;
  const Json last = steps("rest.json").back();
  const int step = last.at("step");
  ASSERT_EQ(
      run(command + "--steps " + std::to_string(step) + " --report all.json", mpirun(2)).exit_code,
      0);
  EXPECT_EQ(last, steps("all.json").back());
}

TEST_F(Mpi_runs, stop_together) {
  expect_stop("offset cube.off --triangles 2000 --distance 0.01e --steps 100000", 3);
}

// Open MPI passes USR1 on. After other signals, it can kill the processes before they end.
TEST_F(Mpi_runs, stop_with_a_checkpoint_if_mpirun_passes_a_signal_on) {
  const Outcome outcome = run("offset cube.off --distance 0.001e --steps 1000000 --quiet",
                              "timeout --foreground -s USR1 2 " + mpirun(2));
  EXPECT_EQ(lines(outcome.err, "dsc: stopping; "), 1u) << outcome.err;
  EXPECT_EQ(lines(outcome.err, "dsc: interrupted after step "), 1u) << outcome.err;
  EXPECT_EQ(run("offset --resume dsc_interrupted.dsc --steps 1", mpirun(2)).exit_code, 0);
}

// The second process starts in another folder, where it cannot write its pieces.
TEST_F(Mpi_runs, end_soon_if_one_process_fails) {
  fs::create_directories(path("other"));
  const std::string arguments = "offset cube.off --distance 0.1e --steps 9 --output run";
  const auto start = std::chrono::steady_clock::now();
  const Outcome outcome =
      run(arguments + " : -n 1 -wdir other '" DSC_PROGRAM "' " + arguments, mpirun(1));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_EQ(lines(outcome.err, "dsc: cannot write run/"), 1u) << outcome.err;
}

TEST_F(Mpi_runs, need_one_command_line) {
  const std::string arguments = "offset cube.off --steps 1 --distance ";
  const Outcome outcome =
      run(arguments + "1e : -n 1 '" DSC_PROGRAM "' " + arguments + "2e", mpirun(1));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(lines(outcome.err, "dsc: process 1 has another command line"), 1u) << outcome.err;
  EXPECT_EQ(lines(outcome.err, "dsc: "), 1u) << outcome.err;
}

TEST_F(Mpi_runs, are_not_commands_of_one_process) {
  for (const char* arguments : {"info cube.off", "convert cube.off cube.stl", "--help"}) {
    const Outcome outcome = run(arguments, mpirun(2));
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(lines(outcome.err, "dsc: "), 1u) << outcome.err;
    EXPECT_PRED2(contains, outcome.err, "runs as one process, but OMPI_COMM_WORLD_SIZE is 2");
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(run(arguments, mpirun(1)).exit_code, 0);
  }
  // Another launcher than that of the MPI of the program starts processes that do not meet.
  const Outcome outcome = run("offset cube.off --distance 1e", "PMI_SIZE=2 PMI_RANK=0");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_PRED2(contains, outcome.err, "PMI_SIZE is 2, but MPI finds one process");
}

} // namespace
