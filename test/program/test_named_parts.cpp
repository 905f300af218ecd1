// Solids, objects and groups with names, by the program.
#include "program.h"
#include "test.h"

namespace {

using namespace program;

class Named_parts : public program::Program_test
{
protected:
  // Returns a box as OBJ, whose first point follows `points` other points.
  static std::string obj_box(double x0, double x1, int points, double y1 = 1) {
    std::istringstream off(box(x0, 0, 0, x1, y1, 1));
    std::ostringstream obj;
    std::string line;
    for (int i = 0; std::getline(off, line); ++i) {
      if (i < 2)
        continue;
      std::istringstream numbers(line);
      if (i < 10) {
        obj << "v " << line << '\n';
        continue;
      }
      std::size_t three = 0, a = 0, b = 0, c = 0;
      numbers >> three >> a >> b >> c;
      obj << "f " << a + 1 + points << ' ' << b + 1 + points << ' ' << c + 1 + points << '\n';
    }
    return obj.str();
  }

  // Returns names and volumes of the labels of a state.
  static std::map<std::string, double> volumes(const Json& state) {
    std::map<std::string, double> result;
    for (const Json& label : state.at("labels"))
      result[label.value("name", "label " + label.at("label").dump())] = label.at("volume");
    return result;
  }

  void SetUp() override {
    Program_test::SetUp();
    // two boxes with a common wall, and one apart from them
    write("boxes.obj", "o left\n" + obj_box(0, 1, 0) + "o right <&>\n" + obj_box(1, 3, 8) +
                           "o alone\n" + obj_box(5, 6, 16));
  }

  const std::string m_motion = " --axis 0,0,1 --angle 5 --steps 1 ";
};

TEST_F(Named_parts, are_labels_in_messages_reports_files_and_checkpoints) {
  const Outcome outcome = run("rotate boxes.obj --report a.json --output run" + m_motion);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_PRED2(contains, outcome.out, "names of labels: 1 'left', 2 'right <&>', 3 'alone'\n");
  auto result = volumes(report("a.json").at("steps").back());
  EXPECT_NEAR(result.at("left"), 1, 1e-9);
  EXPECT_NEAR(result.at("right <&>"), 2, 1e-9);
  EXPECT_NEAR(result.at("alone"), 1, 1e-9);

  ASSERT_EQ(
      run("rotate --resume run/checkpoint.dsc --report b.json --output run --steps 1").exit_code,
      0);
  EXPECT_NEAR(volumes(report("b.json").at("steps").back()).at("right <&>"), 2, 1e-9);
  EXPECT_PRED2(contains, run("info run/checkpoint.dsc").out, "label 2 'right <&>': ");
  EXPECT_PRED2(contains, run("info run/volume_000002.vtu").out, "label 2 'right <&>': ");

  ASSERT_EQ(run("view run -o page.html --report b.json").exit_code, 0);
  EXPECT_PRED2(contains, contents(path("page.html")), R"("names":[[1,"left"],[2,"right )");
  ASSERT_EQ(run("view run -o page.html --without left").exit_code, 0);
  EXPECT_EQ(run("view run -o page.html --without up").err,
            "dsc: --without: no label has the name 'up' (1 'left', 2 'right <&>', 3 'alone'); give "
            "the number of a label\n");
  EXPECT_EQ(run("view run -o page.html --without 1,lef").err,
            "dsc: --without: no label has the name 'lef' (1 'left', 2 'right <&>', 3 'alone'); did "
            "you mean 'left'?\n");
  EXPECT_EQ(run("view run -o page.html --without 9").err,
            "dsc: no state has the label 9; correct the option --without\n");
}

TEST_F(Named_parts, are_converted) {
  for (const std::string name : {"a.stl", "b.obj"}) {
    expect_success("convert boxes.obj " + name);
    const Outcome outcome = run("rotate " + name + " --report a.json" + m_motion);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NEAR(volumes(report("a.json").at("steps").back()).at("right <&>"), 2, 1e-9);
  }
  EXPECT_PRED2(contains, contents(path("a.stl")), "solid right <&>\n");
  EXPECT_EQ(
      run("convert boxes.obj a.off").err,
      "dsc: a.off: the format contains no names of labels (1 'left', 2 'right <&>', 3 'alone')\n");
  EXPECT_PRED2(contains, run("info boxes.obj").out, "part 'left': 12 triangles\n");

  ASSERT_EQ(run("rotate boxes.obj --output run" + m_motion).exit_code, 0);
  expect_success("convert run/checkpoint.dsc a.stl");
  EXPECT_PRED2(contains, run("rotate a.stl" + m_motion).out, "1 'left', 2 'right <&>', 3 'alone'");
  ASSERT_EQ(run("improve run/volume_000001.vtu -o better.vtu").exit_code, 0);
  EXPECT_PRED2(contains, run("info better.vtu").out, "label 3 'alone': ");
  ASSERT_EQ(run("rotate better.vtu --report a.json" + m_motion).exit_code, 0);
  EXPECT_NEAR(volumes(report("a.json").at("steps").back()).at("left"), 1, 1e-9);
  EXPECT_PRED2(contains, run("improve better.vtu -o better.mesh").err,
               "better.mesh: the format contains no names of labels");
}

TEST_F(Named_parts, are_named_in_messages) {
  std::string open = "o left\n" + obj_box(0, 1, 0);
  open.resize(open.rfind('f'));
  write("open.obj", open + "o alone\n" + obj_box(5, 6, 8));
  expect_error("rotate open.obj" + m_motion, 1);
  EXPECT_PRED2(contains, run("rotate open.obj" + m_motion).err, "dsc: open.obj, part 'left': ");
  const Outcome repaired =
      run("rotate open.obj --repair --largest-hole 4 --report a.json" + m_motion);
  EXPECT_PRED2(contains, repaired.out, "open.obj, part 'left': 1 hole filled");
  EXPECT_PRED2(contains, repaired.out, "open.obj, part 'alone': bounds a solid");
  EXPECT_EQ(report("a.json").at("repairs").at(0).at("surface"), "open.obj, part 'left'");
}

TEST_F(Named_parts, that_bound_a_solid_only_together_are_one_surface) {
  std::string text = obj_box(0, 1, 0);
  text.insert(text.find('f'), "g some\n");
  text.insert(text.rfind('f'), "g others\n");
  write("patches.obj", text);
  const Outcome outcome = run("rotate patches.obj --report a.json" + m_motion);
  EXPECT_EQ(outcome.err, "dsc: patches.obj: the parts 'some', 'others' do not bound solids by "
                         "themselves and are read as one surface\n");
  EXPECT_NEAR(volumes(report("a.json").at("steps").back()).at("label 1"), 1, 1e-9);
}

TEST_F(Named_parts, of_several_files_have_different_names) {
  write("left.obj", "g left\n" + obj_box(8, 9, 0));
  EXPECT_PRED2(contains, run("rotate boxes.obj left.obj" + m_motion).out,
               "1 'left', 2 'right <&>', 3 'alone', 4 'left (2)'");
}

TEST_F(Named_parts, may_touch_overlap_and_have_internal_walls) {
  const auto volumes_of = [&](const std::string& obj, const std::string& printed) {
    write("a.obj", obj);
    const Outcome outcome = run("rotate a.obj --report a.json" + m_motion);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_PRED2(contains, outcome.out, printed);
    return volumes(report("a.json").at("steps").back());
  };
  // The parts divide their common wall differently.
  auto result = volumes_of("o a\n" + obj_box(0, 1, 0) + "o b\n" + obj_box(1, 3, 8, .5),
                           "names of labels: 1 'a', 2 'b'\n");
  EXPECT_NEAR(result.at("a"), 1, 1e-9);
  EXPECT_NEAR(result.at("b"), 1, 1e-9);
  result = volumes_of("o a\n" + obj_box(0, 2, 0) + "o b\n" + obj_box(1, 3, 8),
                      "a.obj, part 'b' covers a.obj, part 'a' where they overlap\n");
  EXPECT_NEAR(result.at("a"), 1, 1e-9);
  EXPECT_NEAR(result.at("b"), 2, 1e-9);
  result = volumes_of("o a\n" + obj_box(0, 1, 0) + obj_box(1, 3, 8) + "o b\n" + obj_box(5, 6, 16),
                      "names of labels: 1 'a', 2 'b', 3 'a (2)'\n");
  EXPECT_NEAR(result.at("a"), 1, 1e-9);
  EXPECT_NEAR(result.at("a (2)"), 2, 1e-9);
}

TEST_F(Named_parts, follow_a_grid_with_arrays) {
  ASSERT_EQ(run("rotate boxes.obj --output run" + m_motion).exit_code, 0);
  std::string grid = contents(path("run/volume_000001.vtu"));
  grid.replace(grid.find("\"quality\""), 9, "\"density\"");
  grid.replace(grid.find("\"interface\""), 11, "\"otherface\"");
  write("grid.vtu", grid);
  ASSERT_EQ(run("rotate grid.vtu --output next" + m_motion).exit_code, 0);
  for (const std::string name : {"checkpoint.dsc", "volume_000001.vtu"})
    EXPECT_PRED2(contains, run("info next/" + name).out, "label 2 'right <&>': ");
  EXPECT_PRED2(contains, contents(path("next/interface_000001.vtu")), "\"label_names\"");
}

TEST_F(Named_parts, may_have_names_with_commas_and_numbers_as_names) {
  write("a.obj",
        "o a\n" + obj_box(0, 1, 0) + "o a,b\n" + obj_box(1, 3, 8) + "o 1\n" + obj_box(5, 6, 16));
  ASSERT_EQ(run("rotate a.obj --output run" + m_motion).exit_code, 0);
  const auto labels_without = [&](const std::string& list) {
    EXPECT_EQ(run("view run -o page.html --without " + list).err, "");
    const std::string page = contents(path("page.html"));
    const std::size_t begin = page.find("\"labels\":[");
    return page.substr(begin, page.find(']', begin) - begin);
  };
  EXPECT_EQ(labels_without("a,b"), "\"labels\":[0,1,3");
  EXPECT_EQ(labels_without("a,b,3,0"), "\"labels\":[1");
  EXPECT_EQ(labels_without("a,1"), "\"labels\":[0,2,3"); // 1 is the number of a
}

TEST_F(Named_parts, of_reports_have_names_in_events_and_balances) {
  const Outcome outcome =
      run("mean-curvature boxes.obj --dt .2 --steps 2 --report a.json --edge-per-thickness 0");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json run_report = report("a.json");
  EXPECT_EQ(run_report.at("balance").at(1).at("name"), "left");
  bool vanishes = false;
  for (const Json& step : run_report.at("steps"))
    for (const Json& event : step.at("events"))
      vanishes = vanishes || event.value("name", "") == "alone";
  EXPECT_TRUE(vanishes);
}

TEST_F(Named_parts, have_one_label_on_request) {
  const Outcome outcome = run("rotate boxes.obj --labels none --report a.json" + m_motion);
  EXPECT_EQ(outcome.err, "dsc: boxes.obj: not used: 3 objects\n");
  EXPECT_EQ(volumes(report("a.json").at("steps").back()).count("left"), 0u);
  write("overlapping.obj", "o a\n" + obj_box(0, 2, 0) + "o b\n" + obj_box(1, 3, 8));
  ASSERT_EQ(
      run("rotate overlapping.obj --labels none --repair --report a.json" + m_motion).exit_code, 0);
  EXPECT_NEAR(volumes(report("a.json").at("steps").back()).at("label 1"), 3, 1e-3);
  EXPECT_EQ(run("rotate boxes.obj --labels other" + m_motion).exit_code, 2);
}

} // namespace
