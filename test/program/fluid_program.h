#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_FLUID_PROGRAM_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_FLUID_PROGRAM_H

#include "program.h"
#include "test.h"

namespace program {

// Runs scenes by the program.
class Fluid_program_test : public Program_test
{
protected:
  std::string write_scene(const Json& json) {
    write("scene.json", json.dump());
    return path("scene.json").string();
  }
  // Runs a scene and returns the steps of its report.
  Json steps_of(const Json& json, const std::string& options = "") {
    const Outcome outcome = run("fluid " + write_scene(json) + " --report " +
                                path("report.json").string() + " " + options);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.exit_code == 0 ? report("report.json").at("steps") : Json::array();
  }
  void expect_refusal(const Json& json, const std::string& text) {
    const Outcome outcome = run("fluid " + write_scene(json));
    EXPECT_NE(outcome.exit_code, 0) << text;
    EXPECT_PRED2(contains, outcome.err, text);
    EXPECT_EQ(outcome.err.substr(0, 5), "dsc: ");
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err; // one line
  }
  // Expects that a scene is refused after a change, given as a JSON merge patch.
  void expect_refusal_of_patch(Json json, const std::string& patch, const std::string& text) {
    SCOPED_TRACE(patch);
    json.merge_patch(Json::parse(patch));
    expect_refusal(json, text);
  }
  // Expects that a scene is refused with another value at a place, given as a JSON pointer.
  void expect_refusal_of_value(Json json, const std::string& place, const std::string& value,
                               const std::string& text) {
    SCOPED_TRACE(place + ": " + value);
    json[Json::json_pointer(place)] = Json::parse(value);
    expect_refusal(json, text);
  }
};

} // namespace program

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_FLUID_PROGRAM_H
