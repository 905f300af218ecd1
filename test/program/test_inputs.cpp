// All kinds of INPUT of the moving commands, by the program.
#include "program.h"
#include "test.h"

namespace {

using namespace program;

class Inputs : public program::Program_test
{
protected:
  // Returns the labels and their volumes after a rotation, which preserves the volumes unless the
  // interface ends on the sides of the domain; or the volumes before the rotation.
  std::map<int, double> volumes(const std::string& input, bool after = true) {
    const std::string report = path("report.json").string();
    const Outcome outcome =
        run("rotate " + input + " --axis 0,0,1 --angle 5 --steps 1 --report " + report);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    std::map<int, double> result;
    if (outcome.exit_code != 0)
      return result;
    const Json json = Json::parse(contents(path("report.json")));
    for (const Json& label : (after ? json["steps"].back() : json["steps"].front())["labels"])
      result[label["label"]] = label["volume"];
    return result;
  }

  void expect_refusal(const std::string& input, int code, const std::string& text) {
    const Outcome outcome = run("rotate " + input + " --axis 0,0,1 --angle 5");
    EXPECT_EQ(outcome.exit_code, code) << input;
    EXPECT_PRED2(contains, outcome.err, text);
  }
};

// A Kuhn cube of label 2 in MEDIT format.
const char* const cube = R"(MeshVersionFormatted 2
Dimension 3
Vertices 8
0 0 0 0
1 0 0 0
0 1 0 0
1 1 0 0
0 0 1 0
1 0 1 0
0 1 1 0
1 1 1 0
Tetrahedra 6
1 2 4 8 2
1 2 6 8 2
1 3 4 8 2
1 3 7 8 2
1 5 6 8 2
1 5 7 8 2
End
)";

// A header of an INR file, 256 bytes long, and one byte for each voxel.
std::string inr(int n, const std::string& voxels) {
  std::ostringstream header;
  header << "#INRIMAGE-4#{\nXDIM=" << n << "\nYDIM=" << n << "\nZDIM=" << n
         << "\nVDIM=1\nTYPE=unsigned fixed\nPIXSIZE=8 bits\nCPU=decm\nVX=1\nVY=1\nVZ=1\n";
  std::string text = header.str();
  const std::string end = "##}\n";
  text += std::string(256 - end.size() - text.size(), '\n') + end;
  return text + voxels;
}

TEST_F(Inputs, may_be_inequalities) {
  const auto result =
      volumes("'x^2+y^2+z^2<0.5' '(x^2+y^2+z^2<0.5)&&(z>0)' --domain -1,-1,-1,1,1,1 --edge 0.1");
  ASSERT_EQ(result.size(), 3u);
  const double half = 2 * 3.14159265358979 / 3 * std::pow(.5, 1.5);
  EXPECT_NEAR(result.at(1), half, .01 * half);
  EXPECT_NEAR(result.at(2), half, .01 * half);
}

// No file can have a name of more than 255 characters, and no path one of more than 4096.
TEST_F(Inputs, may_be_inequalities_of_any_length) {
  for (const std::size_t length : {std::size_t(300), std::size_t(5000)}) {
    std::string inequality = "x^2+y^2+z^2<0.5";
    while (inequality.size() < length)
      inequality += "||x^2+y^2+z^2<0.25";
    const auto result = volumes("'" + inequality + "' --domain -1,-1,-1,1,1,1 --edge 0.1");
    ASSERT_EQ(result.size(), 2u);
    EXPECT_NEAR(result.at(1), 1.481, .01);
    const std::string name(length, 'a');
    for (const char* extension : {".off", ".vtu", ".msh", ".inr"})
      expect_refusal(name + extension, 1, "cannot open " + name.substr(0, 300));
  }
}

TEST_F(Inputs, may_be_tetrahedra_without_space_around) {
  write("cube.mesh", cube);
  const auto result = volumes(path("cube.mesh").string());
  ASSERT_EQ(result.size(), 2u);
  EXPECT_NEAR(result.at(2), 1, 1e-12);
  EXPECT_NEAR(volumes(path("cube.mesh").string() + " --domain -1,-1,-1,2,2,2").at(0), 26, 1e-12);
}

// The mesh of a file is the domain if the user asks for it and the mesh is a ball.
TEST_F(Inputs, may_be_tetrahedra_that_are_the_domain) {
  std::string halves = cube;
  for (const char* tetrahedron : {"\n1 2 4 8 2", "\n1 2 6 8 2", "\n1 5 6 8 2"})
    halves[halves.find(tetrahedron) + 9] = '5';
  write("halves.mesh", halves);
  const std::string mesh = path("halves.mesh").string();
  const auto result = volumes(mesh + " --domain mesh", false);
  ASSERT_EQ(result.size(), 2u);
  EXPECT_NEAR(result.at(2), .5, 1e-12);
  EXPECT_NEAR(result.at(5), .5, 1e-12);
  EXPECT_EQ(volumes(mesh).size(), 3u);

  write("two.mesh", R"(MeshVersionFormatted 2
Dimension 3
Vertices 7
0 0 0 0
1 0 0 0
0 1 0 0
0 0 1 0
-1 0 0 0
0 -1 0 0
0 0 -1 0
Tetrahedra 2
1 2 3 4 1
1 5 6 7 2
End
)");
  const std::string two = path("two.mesh").string();
  expect_refusal(two + " --domain mesh", 1, "leave out --domain mesh");
  const auto parts = volumes(two); // they touch in a vertex
  EXPECT_NEAR(parts.at(1), 1. / 6, 1e-12);
  EXPECT_NEAR(parts.at(2), 1. / 6, 1e-12);
  write("cube.mesh", cube);
  expect_refusal(path("cube.mesh").string() + " --domain mesh", 1, "all tetrahedra have the same");
  write("box.off", program::box(0, 0, 0, 1, 1, 1));
  expect_refusal(path("box.off").string() + " --domain mesh", 2, "applies only to tetrahedra");
}

TEST_F(Inputs, may_be_images_of_voxels) {
  std::string voxels(6 * 6 * 6, '\0');
  for (std::size_t i = 0; i < voxels.size(); ++i)
    voxels[i] = i % 6 < 3 ? '\1' : i / 36 < 3 ? '\4' : '\0';
  write("halves.inr", inr(6, voxels));
  const auto result = volumes(path("halves.inr").string(), false);
  ASSERT_EQ(result.size(), 3u);
  EXPECT_NEAR(result.at(0), 54, 1e-6); // the voxels fill the domain
  EXPECT_NEAR(result.at(1), 108, 1e-6);
  EXPECT_NEAR(result.at(4), 54, 1e-6);

  write("eighths.inr", inr(2, std::string("\1\2\3\4\5\6\7\10")));
  const std::string eighths = path("eighths.inr").string();
  EXPECT_EQ(volumes(eighths, false).size(), 8u); // no label 0
  const auto surrounded = volumes(eighths + " --domain -1,-1,-1,2,2,2");
  ASSERT_EQ(surrounded.size(), 9u);
  EXPECT_NEAR(surrounded.at(0), 19, 1e-6);
  for (int label = 1; label <= 8; ++label)
    EXPECT_NEAR(surrounded.at(label), 1, 1e-6);
}

// A box with one duplicated triangle and some corners apart from the others.
TEST_F(Inputs, may_be_surfaces_to_be_repaired) {
  const std::string text = program::box(0, 0, 0, 1, 1, 1);
  write("box.off", text);
  write("broken.off", "OFF\n8 13 0\n" + text.substr(text.find('\n', 4) + 1) + "3 0 2 3\n");
  const std::string box = path("box.off").string(), broken = path("broken.off").string();
  EXPECT_NEAR(volumes(broken).at(1), 1, 1e-9);
  EXPECT_NEAR(volumes(broken + " --repair").at(1), 1, 1e-9);
  const Json report = Json::parse(contents(path("report.json")));
  EXPECT_TRUE(report["parameters"]["repair"]);
  ASSERT_EQ(report["repairs"].size(), 1u);
  EXPECT_EQ(report["repairs"][0]["repeated_triangles"], 1);
  EXPECT_EQ(report["repairs"][0]["distance_to_input"], 0);

  const Outcome outcome = run("rotate " + broken + " --repair --axis 0,0,1 --angle 5 --steps 1");
  EXPECT_PRED2(contains, outcome.out, "1 duplicate triangle removed; maximum displacement 0 (");
  const Outcome sound = run("rotate " + box + " --repair --axis 0,0,1 --angle 5 --steps 1");
  EXPECT_PRED2(contains, sound.out, "no repair is necessary");

  write("sheet.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  expect_refusal(path("sheet.off").string() + " --repair", 1, "cannot be repaired");
  expect_refusal("'x<1' --repair --domain -2,-2,-2,2,2,2", 2, "--repair");
}

// Concatenates the triangles of several OFF files.
std::string join(const std::vector<std::string>& files) {
  std::ostringstream points, triangles;
  std::size_t offset = 0, number = 0;
  for (const std::string& file : files) {
    std::istringstream in(file);
    std::string line, off;
    std::size_t n = 0, m = 0, edges = 0;
    in >> off >> n >> m >> edges;
    std::getline(in, line);
    for (std::size_t i = 0; i < n && std::getline(in, line); ++i)
      points << line << '\n';
    for (std::size_t i = 0; i < m; ++i) {
      std::size_t three, a, b, c;
      in >> three >> a >> b >> c;
      triangles << "3 " << a + offset << ' ' << b + offset << ' ' << c + offset << '\n';
    }
    offset += n;
    number += m;
  }
  std::ostringstream result;
  result << "OFF\n" << offset << ' ' << number << " 0\n" << points.str() << triangles.str();
  return result.str();
}

TEST_F(Inputs, may_be_parts_that_cross) {
  write("cross.off", join({program::box(0, 0, 0, 2, 1, 2), program::box(1, .5, 1, 3, 1.5, 2)}));
  const std::string cross = path("cross.off").string();
  expect_refusal(cross, 1, "--repair");
  EXPECT_NEAR(volumes(cross + " --repair").at(1), 4 + 2 - .5, 1e-9);
  const Json report = Json::parse(contents(path("report.json")));
  EXPECT_EQ(report["repairs"][0]["united_parts"], 2);
  EXPECT_TRUE(report["repairs"][0]["wrap"].is_null());
  const Outcome outcome = run("rotate " + cross + " --repair --axis 0,0,1 --angle 5 --steps 1");
  EXPECT_PRED2(contains, outcome.out, "2 intersecting components united");
}

TEST_F(Inputs, may_have_t_junctions) {
  // The edge from vertex 0 to vertex 1 has an additional vertex on the bottom, but not on the
  // front.
  const std::string text = program::box(0, 0, 0, 1, 1, 1);
  std::istringstream in(text);
  std::string line, file;
  for (int i = 0; std::getline(in, line); ++i)
    if (i == 1)
      file += "9 13 0\n";
    else if (line == "3 0 3 1")
      file += "3 0 3 8\n3 8 3 1\n";
    else
      file += line + '\n' + (i == 9 ? ".5 1e-9 -1e-9\n" : "");
  write("junction.off", file);
  const std::string junction = path("junction.off").string();
  expect_refusal(junction, 1, "--repair");
  EXPECT_NEAR(volumes(junction + " --repair").at(1), 1, 1e-8);
  EXPECT_EQ(Json::parse(contents(path("report.json")))["repairs"][0]["split_edges"], 1);
}

// Two octahedra whose tips are so close that TetGen fails.
TEST_F(Inputs, may_have_vertices_that_nearly_coincide) {
  std::ostringstream off;
  off << "OFF\n12 16 0\n";
  for (int side : {-1, 1})
    off << "1 0 " << side << "\n0 1 " << side << "\n-1 0 " << side << "\n0 -1 " << side << "\n0 0 "
        << side * 1e-15 << "\n0 0 " << 2 * side << '\n';
  for (int first : {0, 6})
    for (int i = 0; i < 4; ++i)
      for (int tip : {4, 5})
        off << "3 " << first + i << ' ' << first + (i + 1) % 4 << ' ' << first + tip << '\n';
  write("tips.off", off.str());
  const std::string tips = path("tips.off").string();
  EXPECT_NEAR(volumes(tips).at(1), 8. / 3, 1e-9);
  EXPECT_NEAR(volumes(tips + " --repair").at(1), 8. / 3, 1e-9);
}

// With six digits, places at a distance of .006 are welded by default.
TEST_F(Inputs, may_be_thin_although_coordinates_have_few_digits) {
  write("plate.off", program::box(0, 0, 0, 100.123, 100.123, .005));
  const auto file = [&](const char* name) { return path(name).string(); };
  EXPECT_NEAR(volumes(file("plate.off")).at(1), 100.123 * 100.123 * .005, 1e-6);
  write("left.off", program::box(0, 0, 0, 100, 100, 100));
  write("right.off", program::box(100.005, 0, 0, 200.123, 100, 100));
  const Outcome gap = run("rotate " + file("left.off") + ' ' + file("right.off") +
                          " --axis 0,0,1 --angle 5 --steps 1");
  EXPECT_EQ(gap.exit_code, 0);
  EXPECT_PRED2(contains, gap.out, "nearer to each other than");
}

TEST_F(Inputs, may_overlap) {
  write("one.off", program::box(0, 0, 0, 2, 1, 1));
  write("two.off", program::box(1, .25, .25, 3, .75, .75));
  const std::string both = path("one.off").string() + ' ' + path("two.off").string();
  const auto of_both = volumes(both);
  EXPECT_NEAR(of_both.at(1), 2 - .25, 1e-9);
  EXPECT_NEAR(of_both.at(2), .5, 1e-9);
  const Outcome outcome = run("offset " + both + " --distance .01 --steps 1");
  EXPECT_PRED2(contains, outcome.out, "two.off covers");
  const auto resampled = volumes(both + " --triangles 500");
  EXPECT_NEAR(resampled.at(1), 2 - .25, 1e-9);
  EXPECT_NEAR(resampled.at(2), .5, 1e-9);
}

TEST_F(Inputs, may_have_holes_up_to_a_length) {
  std::string text = program::box(0, 0, 0, 1, 1, 1);
  text.replace(text.find("8 12 0"), 6, "8 11 0");
  text.erase(text.find("3 1 7 5"));
  write("hole.off", text);
  const std::string hole = path("hole.off").string();
  expect_refusal(hole, 1, "--repair");
  expect_refusal(hole + " --repair --largest-hole 3.4", 1, "--largest-hole");
  EXPECT_NEAR(volumes(hole + " --repair --largest-hole 3.5").at(1), 1, 1e-9);
  EXPECT_NEAR(volumes(hole + " --repair --largest-hole 4e").at(1), 1, 1e-9);
  EXPECT_EQ(run("rotate " + hole + " --largest-hole 3 --axis 0,0,1 --angle 5").exit_code, 2);
  EXPECT_EQ(run("rotate " + hole + " --repair --largest-hole=-1 --axis 0,0,1 --angle 5").exit_code,
            2);
}

TEST_F(Inputs, may_share_walls) {
  const std::string left = program::box(0, 0, 0, 1, 1, 1), right = program::box(1, 0, 0, 3, 1, 1),
                    small = program::box(1, .25, .25, 2, .5, .5);
  write("left.off", left);
  write("right.off", right);
  write("small.off", small);
  write("both.off", join({left, right}));
  const auto file = [&](const char* name) { return path(name).string(); };
  auto result = volumes(file("left.off") + " " + file("right.off"));
  EXPECT_NEAR(result.at(1), 1, 1e-9);
  EXPECT_NEAR(result.at(2), 2, 1e-9);
  result = volumes(file("left.off") + " " + file("small.off"));
  EXPECT_NEAR(result.at(2), .0625, 1e-9);
  result = volumes(file("both.off"));
  EXPECT_NEAR(result.at(1), 1, 1e-9);
  EXPECT_NEAR(result.at(2), 2, 1e-9);
  const Outcome outcome = run("rotate " + file("both.off") + " --axis 0,0,1 --angle 5 --steps 1");
  EXPECT_PRED2(contains, outcome.out, "2 regions with the labels 1, 2");
  EXPECT_NEAR(volumes(file("both.off") + " --repair").at(1), 3, 1e-9);
}

TEST_F(Inputs, that_are_refused_are_told_of_options_of_the_program) {
  std::string text = program::box(0, 0, 0, 1, 1, 1);
  write("crossing.off", join({text, program::box(.5, .5, .5, 2, 2, 2)}));
  text.replace(text.find("8 12 0"), 6, "8 11 0");
  text.erase(text.find("3 1 7 5"));
  write("open.off", text);
  for (const char* name : {"crossing.off", "open.off"}) {
    const Outcome outcome = run("rotate " + path(name).string() + " --axis 0,0,1 --angle 5");
    EXPECT_EQ(outcome.err.find("CGAL"), std::string::npos) << outcome.err;
    EXPECT_PRED2(contains, outcome.err, "--repair");
  }
}

TEST_F(Inputs, that_make_no_sense_are_refused) {
  write("cube.mesh", cube);
  write("cut.inr", inr(6, "").substr(0, 100));
  write("empty.inr", inr(2, std::string(8, '\0')));
  const std::string mesh = path("cube.mesh").string();
  expect_refusal("'x<1'", 2, "--domain");
  expect_refusal("'x<' --domain 0,0,0,1,1,1", 2, "cannot be parsed");
  expect_refusal("'x<1,y<1' --domain 0,0,0,1,1,1", 2, "commas");
  expect_refusal("'x<3' --domain 0,0,0,1,1,1", 1, "define no interface");
  expect_refusal("'x<1' " + mesh + " --domain 0,0,0,1,1,1", 2, "is not an inequality");
  expect_refusal(mesh + " " + mesh, 2, "more than one INPUT");
  expect_refusal(mesh + " --triangles 100", 2, "--triangles");
  expect_refusal(mesh + " --edge 0.1", 2, "--edge");
  expect_refusal(mesh + " --domain 0,0,0,2,2,2", 1, "enlarge --domain");
  expect_refusal(path("cut.inr").string(), 1, "is it truncated?");
  expect_refusal(path("missing.inr").string(), 1, "cannot open");
  expect_refusal(path("empty.inr").string(), 1, "all voxels have the same label");
}

TEST_F(Inputs, that_are_misspelt_get_advice) {
  const std::string box = " --domain=-1,-1,-1,1,1,1";
  expect_refusal("'x^2+y^2+Z^2<1'" + box, 2, "did you mean 'z'?");
  expect_refusal("'sqr(x)<1'" + box, 2, "did you mean 'sqrt'?");
  expect_refusal("'x=1<2'" + box, 2, "'=='");
  expect_refusal("'1<2'" + box, 2, "is constant");
  expect_refusal("'-.5<x<.5'" + box, 2, "in parentheses");
  expect_refusal("'x<0.5' --domian=-1,-1,-1,1,1,1", 2, "did you mean '--domain'?");
  for (const auto& [arguments, text] :
       {std::pair("advct x.off", "unknown command 'advct'; did you mean 'advect'?"),
        std::pair("fluid droplet --stesp 3", "unknown option '--stesp'; did you mean '--steps'?"),
        std::pair("fluid droplet --frobnicate red",
                  "unknown option '--frobnicate'; see dsc fluid --help"),
        std::pair("advect x.off --velocity 'x=-y,y=x,z=0'", "'=='"),
        std::pair("advect x.wkt --velocity z,0", "'z'"),
        std::pair("cut-locus --point 0,0 --surface 'u,v,w'", "'w'")}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_PRED2(contains, outcome.err, text);
  }
}

TEST_F(Inputs, have_no_options_without_effect) {
  for (const auto& [arguments, text] :
       {std::pair("vortex --plane x.wkt", "--plane"),
        std::pair("vortex --plane --resume x.dsc", "--plane"),
        std::pair("vortex --plane --improve-interface --tolerance .1", "--tolerance"),
        std::pair("offset x.pgm --distance 1 --segments 100", "--segments"),
        std::pair("cut-locus --surface ellipsoid --point 1,0,0 --periods 1,2", "--periods"),
        std::pair("cut-locus --surface x,y,z --point 1,0,0 --periods 1,2", "--periods"),
        std::pair("cut-locus --surface u,v,u^2 --point 0,0", "--periods")}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_PRED2(contains, outcome.err, text);
  }
  // A resumed run that improves its interface ignores the tolerance, too.
  const std::string vortex = "vortex --triangles 80 --dt 0.001 --steps 1 --output out ";
  ASSERT_EQ(run(vortex + "--improve-interface").exit_code, 0);
  const Outcome outcome = run("vortex --resume out/checkpoint.dsc --tolerance 0.1");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_PRED2(contains, outcome.err, "--tolerance");
}

// The mesh contains everything that inequalities describe, or the program reports the missing
// parts.
TEST_F(Inputs, of_inequalities_are_resolved) {
  const std::string box = " --domain=-1,-1,-1,1,1,1 --edge ";
  const std::string balls = "'(x-.5)^2+y^2+z^2<.1||(x+.5)^2+y^2+z^2<.1'";
  EXPECT_GT(volumes(balls + box + ".2").at(1), 0);
  expect_refusal("'abs(z)<.005&&x^2+y^2<.5'" + box + ".25", 1, "connected component");
  expect_refusal("'x^2+y^2+z^2<.5' '(x-.01)^2+y^2+z^2<.0001'" + box + ".2", 1,
                 "(x-.01)^2+y^2+z^2<.0001");
  expect_refusal("'x^2+y^2+z^2<.1' 'x^2+y^2+z^2<.5'" + box + ".2", 1, "later ones cover it");
  expect_refusal("'.2<x<.23&&y^2+z^2<.5' 'x<-.5'" + box + ".2", 1, "; choose ");
  // Sharp rims leave no small fragments. Components that touch at a point may be counted as one or
  // two.
  EXPECT_GT(volumes("'(x-.4)^2+y^2+z^2<.5&&(x+.4)^2+y^2+z^2<.5'" + box + ".1").at(1), 0);
  EXPECT_GT(volumes("'x^2+y^2<z^2<.25'" + box + ".1").at(1), 0);
  EXPECT_GT(volumes("'abs(x+.3*y)<.5&&abs(y-.3*x+.1*z)<.5&&abs(z)<.4'" + box + ".1").at(1), 0);
  EXPECT_EQ(volumes("'(-.5)<x<.5&&-.5<y<=.5&&.5>z>-.5'" + box + ".2"),
            volumes("'(-.5)<x&&x<.5&&-.5<y&&y<=.5&&.5>z&&z>-.5'" + box + ".2"));
}

} // namespace
