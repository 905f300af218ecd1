#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_PROGRAM_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_PROGRAM_H

#include "test.h"

#include <nlohmann/json.hpp>

#include <cstdio>

#include <sys/wait.h>

// Tests of the program from outside: exit codes, messages, files. The tests need the built program.
namespace program {

using Json = nlohmann::json;

#ifdef DSC_PROGRAM
inline const std::string executable = DSC_PROGRAM;
#else
inline const std::string executable = "false";
#endif

struct Outcome
{
  int exit_code;
  std::string out, err;
};

inline std::string contents(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Returns an axis-parallel box as an OFF file.
inline std::string box(double x0, double y0, double z0, double x1, double y1, double z1) {
  std::ostringstream off;
  off << "OFF\n8 12 0\n";
  for (int i = 0; i < 8; ++i)
    off << (i & 1 ? x1 : x0) << ' ' << (i & 2 ? y1 : y0) << ' ' << (i & 4 ? z1 : z0) << '\n';
  off << "3 0 2 3\n3 0 3 1\n3 4 5 7\n3 4 7 6\n3 0 1 5\n3 0 5 4\n"
         "3 2 6 7\n3 2 7 3\n3 0 4 6\n3 0 6 2\n3 1 3 7\n3 1 7 5\n";
  return off.str();
}

// Returns the part of a state in a report that belongs to a label.
inline const Json& label_of(const Json& state, int label) {
  const Json& labels = state.at("labels");
  return *std::find_if(labels.begin(), labels.end(),
                       [&](const Json& entry) { return entry.at("label") == label; });
}

// Runs the program in a separate folder.
class Program_test : public testing::Test
{
protected:
  void SetUp() override {
#ifndef DSC_PROGRAM
    GTEST_SKIP() << "the program is not built";
#endif
    std::string pattern = (fs::temp_directory_path() / "dsc_program_XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    m_folder = pattern;
  }

  void TearDown() override {
    if (!m_folder.empty())
      fs::remove_all(m_folder);
  }

  fs::path path(const std::string& name) const { return m_folder / name; }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
  }

  Outcome run(const std::string& arguments, const std::string& prefix = "") const {
    const std::string command = "cd '" + m_folder.string() + "' && " + prefix + " '" + executable +
                                "' " + arguments + " 2>stderr.txt </dev/null";
    Outcome outcome;
    FILE* pipe = popen(command.c_str(), "r");
    char buffer[4096];
    for (std::size_t n; (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;)
      outcome.out.append(buffer, n);
    const int status = pclose(pipe);
    outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    outcome.err = contents(path("stderr.txt"));
    return outcome;
  }

  // Expects one line on stderr with the error and advice, and no other output.
  void expect_error(const std::string& arguments, int exit_code) const {
    SCOPED_TRACE(arguments);
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, exit_code);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err.rfind("dsc: ", 0), 0u) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_NE(outcome.err.find_first_of(";:", 5), std::string::npos) << outcome.err;
  }

  void expect_success(const std::string& arguments) const {
    SCOPED_TRACE(arguments);
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
  }

  Json report(const std::string& name) const { return Json::parse(contents(path(name))); }

  // Returns the number in the line of `dsc info` that starts with `key`.
  double info(const std::string& file, const std::string& key) const {
    const Outcome outcome = run("info " + file);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    std::istringstream lines(outcome.out);
    for (std::string line; std::getline(lines, line);)
      if (line.rfind(key, 0) == 0)
        return std::atof(line.c_str() + key.size());
    ADD_FAILURE() << "no " << key << " in\n" << outcome.out;
    return 0;
  }

private:
  fs::path m_folder;
};

} // namespace program

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_PROGRAM_H
