#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_PROCESSES_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_PROCESSES_H

#include "program.h"
#include "test.h"

namespace program {

// Returns the number of lines that begin with a text.
inline std::size_t lines(const std::string& text, const std::string& begin) {
  std::istringstream in(text);
  std::size_t result = 0;
  for (std::string line; std::getline(in, line);)
    result += line.rfind(begin, 0) == 0;
  return result;
}

inline std::string mpirun(int processes) { return DSC_MPIRUN " " + std::to_string(processes); }

// Runs the program in several processes.
class Processes_test : public Program_test
{
protected:
  // Expects that two processes fail and print one error.
  void expect_one_error(const std::string& arguments) const {
    SCOPED_TRACE(arguments);
    const Outcome outcome = run(arguments, mpirun(2));
    EXPECT_NE(outcome.exit_code, 0);
    EXPECT_EQ(lines(outcome.err, "dsc: "), 1u) << outcome.err;
  }

  // Expects that two processes stop when the first one gets the signal after some seconds.
  void expect_stop(const std::string& arguments, int seconds) const {
    const Outcome outcome =
        run(arguments + " : -n 1 '" DSC_PROGRAM "' " + arguments,
            mpirun(1) + " timeout --preserve-status -s INT " + std::to_string(seconds));
    EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
    EXPECT_EQ(lines(outcome.err, "dsc: interrupted"), 1u) << outcome.err;
  }
};

} // namespace program

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_PROCESSES_H
