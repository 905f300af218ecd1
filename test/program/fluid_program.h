#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_FLUID_PROGRAM_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_FLUID_PROGRAM_H

#include "program.h"

#include <string>

namespace program {

// Runs scenes by the program.
class Fluid_program_test : public Program_test
{
protected:
  std::string write_scene(const Json& json) {
    write("scene.json", json.dump());
    return path("scene.json").string();
  }
  void expect_refusal(const Json& json, const std::string& text) {
    const Outcome outcome = run("fluid " + write_scene(json));
    EXPECT_NE(outcome.exit_code, 0) << text;
    EXPECT_NE(outcome.err.find(text), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.substr(0, 5), "dsc: ");
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err; // one line
  }
};

} // namespace program

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_FLUID_PROGRAM_H
