// Improvement of tetrahedral meshes of other programs.
#include "program.h"
#include "test.h"
#include "vtu_grid.h"

#include <CGAL/Mesh_files/internal/grids/Vtu_reader.h>

#include <cstring>
#include <iomanip>

namespace {

using CGAL::Deformable_simplicial_complexes::internal::Vtu_reader;
using namespace program;

struct Mesh
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::size_t, 4>> tetrahedra;
  std::vector<int> labels;
};

// A grid of (nx, ny, nz) cubes of edge length 1, each of six tetrahedra around a diagonal. Cubes
// without a label are left out. If there is only one label, points are displaced in the x
// direction.
template <class Label> Mesh cubes(int nx, int ny, int nz, Label label, double bend = 0) {
  Mesh mesh;
  const auto index = [=](const std::array<int, 3>& p) {
    return static_cast<std::size_t>((p[2] * (ny + 1) + p[1]) * (nx + 1) + p[0]);
  };
  for (int z = 0; z <= nz; ++z)
    for (int y = 0; y <= ny; ++y)
      for (int x = 0; x <= nx; ++x) {
        const bool is_inside = 0 < x && x < nx && 0 < y && y < ny && 0 < z && z < nz;
        const bool may_move =
            is_inside && label(x, y, z) == label(x - 1, y - 1, z - 1); // interfaces are planar
        mesh.points.push_back(
            {x + (may_move ? x % 2 == 0 ? -bend : bend : 0), double(y), double(z)});
      }
  for (int z = 0; z < nz; ++z)
    for (int y = 0; y < ny; ++y)
      for (int x = 0; x < nx; ++x) {
        if (label(x, y, z) < 0)
          continue;
        std::array<std::size_t, 3> axes = {0, 1, 2};
        do {
          std::array<int, 3> corner = {x, y, z};
          std::array<std::size_t, 4> tetrahedron = {index(corner)};
          for (std::size_t i = 0; i < 3; ++i) {
            ++corner[axes[i]];
            tetrahedron[i + 1] = index(corner);
          }
          const bool is_odd_permutation = (axes[0] + 1) % 3 != axes[1];
          if (is_odd_permutation)
            std::swap(tetrahedron[2], tetrahedron[3]);
          mesh.tetrahedra.push_back(tetrahedron);
          mesh.labels.push_back(label(x, y, z));
        } while (std::next_permutation(axes.begin(), axes.end()));
      }
  return mesh;
}

// Returns the mesh without points that belong to no tetrahedron.
Mesh without_unused_points(const Mesh& mesh) {
  Mesh result = mesh;
  std::map<std::size_t, std::size_t> numbers;
  result.points.clear();
  for (auto& tetrahedron : result.tetrahedra)
    for (std::size_t& v : tetrahedron) {
      const auto [known, is_new] = numbers.emplace(v, result.points.size());
      if (is_new)
        result.points.push_back(mesh.points[v]);
      v = known->second;
    }
  return result;
}

// Two layers of labels 5 and 2 in a box of 4 x 4 x 4. The cells have a tenth of the thickness of
// regular cells.
Mesh layers() {
  return cubes(
      4, 4, 4, [](int, int, int z) { return z < 2 ? 5 : 2; }, 0.45);
}

std::string numbers(const std::array<double, 3>& p) {
  std::ostringstream text;
  text << std::setprecision(std::numeric_limits<double>::max_digits10) << p[0] << ' ' << p[1] << ' '
       << p[2];
  return text.str();
}

std::string medit(const Mesh& mesh) {
  std::ostringstream text;
  text << "MeshVersionFormatted 2\nDimension\n3\nVertices\n" << mesh.points.size() << '\n';
  for (const auto& p : mesh.points)
    text << numbers(p) << " 0\n";
  text << "Tetrahedra\n" << mesh.tetrahedra.size() << '\n';
  for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i) {
    for (const std::size_t v : mesh.tetrahedra[i])
      text << v + 1 << ' ';
    text << mesh.labels[i] << '\n';
  }
  text << "End\n";
  return text.str();
}

// Adds the cells of a mesh to a grid, and returns the file, as other programs write it.
// `attributes` are attributes of the root element.
std::string vtu(const Mesh& mesh, const std::string& name_of_labels,
                const std::string& attributes = "", vtu_grid::Grid grid = vtu_grid::Grid()) {
  std::vector<double> coordinates;
  std::vector<std::size_t> connectivity, offsets;
  for (const auto& p : mesh.points)
    coordinates.insert(coordinates.end(), p.begin(), p.end());
  for (const auto& t : mesh.tetrahedra) {
    connectivity.insert(connectivity.end(), t.begin(), t.end());
    offsets.push_back(connectivity.size());
  }
  return grid.array("CellData", "Int32", name_of_labels, mesh.labels)
      .array("Points", "Float64", "Points", coordinates)
      .array("Cells", "Int64", "connectivity", connectivity)
      .array("Cells", "Int64", "offsets", offsets)
      .array("Cells", "UInt8", "types", std::vector<int>(mesh.tetrahedra.size(), 10))
      .text("NumberOfPoints=\"" + std::to_string(mesh.points.size()) + "\" NumberOfCells=\"" +
                std::to_string(mesh.tetrahedra.size()) + "\"",
            attributes);
}

// Returns the simplices of a section with their references, by the coordinates of their vertices
// as text.
std::multiset<std::pair<std::set<std::string>, int>>
simplices(const std::string& mesh, const std::string& section, std::size_t corners) {
  std::istringstream in(mesh);
  std::vector<std::string> points;
  std::multiset<std::pair<std::set<std::string>, int>> result;
  for (std::string line; std::getline(in, line);) {
    std::size_t n = 0;
    if (line == "Vertices") {
      in >> n;
      std::array<std::string, 4> words;
      for (; n > 0 && in >> words[0] >> words[1] >> words[2] >> words[3]; --n)
        points.push_back(words[0] + ' ' + words[1] + ' ' + words[2]);
    } else if (line == section) {
      in >> n;
      for (; n > 0; --n) {
        std::set<std::string> vertices;
        int reference = 0;
        for (std::size_t i = 0, v = 0; i < corners && in >> v; ++i)
          vertices.insert(points.at(v - 1));
        if (corners > 1)
          in >> reference;
        result.insert({vertices, reference});
      }
    }
  }
  return result;
}

std::set<std::set<std::string>> interface_triangles(const std::string& mesh) {
  std::set<std::set<std::string>> triangles;
  for (const auto& [vertices, reference] : simplices(mesh, "Triangles", 3))
    triangles.insert(vertices);
  return triangles;
}

class Improve : public program::Program_test
{
protected:
  void SetUp() override {
    Program_test::SetUp();
    if (IsSkipped() || HasFatalFailure())
      return;
    write("layers.mesh", medit(layers()));
    write("layers.vtu", vtu(layers(), "label"));
  }

  // Expects an error of one line, and that no mesh is written or changed.
  void expect_refusal(const std::string& input, const std::string& text) const {
    SCOPED_TRACE(input);
    write(input, text);
    write("old.mesh", "precious");
    expect_error("improve " + input + " -o old.mesh --report report.json", 1);
    EXPECT_EQ(contents(path("old.mesh")), "precious");
    EXPECT_TRUE(contents(path(input)) == text);
    EXPECT_FALSE(fs::exists(path("report.json")));
    EXPECT_PRED2(contains, contents(path("stderr.txt")), input);
    expect_error("improve " + input + " -o " + input, 1);
    EXPECT_TRUE(contents(path(input)) == text);
  }

  // Expects that the input is not replaced by a file with less content. `arguments` begin with the
  // name of the input.
  void expect_loss_is_refused(const std::string& arguments, const std::string& what) const {
    const std::string input = arguments.substr(0, arguments.find(' '));
    const std::string before = contents(path(input));
    expect_error("improve " + arguments + " -o " + input, 1);
    EXPECT_TRUE(contents(path(input)) == before);
    EXPECT_PRED2(contains, contents(path("stderr.txt")), what);
  }
};

TEST_F(Improve, refuses_wrong_usage) {
  const std::string before = contents(path("layers.mesh"));
  for (const std::string arguments :
       {"", "layers.mesh", "-o out.mesh", "layers.off -o out.mesh", "layers.mesh -o out.off",
        "layers.mesh -o out", "layers.mesh layers.vtu -o out.mesh",
        "layers.mesh -o out.mesh --threshold 0", "layers.mesh -o out.mesh --threshold=-0.1",
        "layers.mesh -o out.mesh --threshold 1.1", "layers.mesh -o out.mesh --threshold nan",
        "layers.mesh -o out.mesh --threshold 0.3x", "layers.mesh -o out.mesh --threshold ''",
        "layers.mesh -o out.mesh --aggressive=maybe", "layers.mesh -o out.mesh --steps 3",
        "layers.mesh -o out.mesh --report layers.mesh", "layers.mesh -o out.mesh --report out.mesh",
        "layers.mesh -o out.mesh --report ./out.mesh"})
    expect_error("improve " + arguments, 2);
  EXPECT_TRUE(contents(path("layers.mesh")) == before);
  EXPECT_FALSE(fs::exists(path("out.mesh")));
}

TEST_F(Improve, refuses_bad_input) {
  expect_error("improve missing.mesh -o out.mesh", 1);
  expect_error("improve missing.vtu -o out.mesh", 1);
  expect_error("improve layers.mesh -o missing/out.mesh", 1);
  expect_error("improve layers.mesh -o out.mesh --report missing/report.json", 1);
  fs::create_directory(path("folder.vtu"));
  expect_error("improve layers.mesh -o folder.vtu", 1);
  expect_error("improve folder.vtu -o out.mesh", 1);
  EXPECT_FALSE(fs::exists(path("out.mesh")));

  const std::string mesh = contents(path("layers.mesh")), grid = contents(path("layers.vtu"));
  expect_refusal("empty.mesh", "");
  expect_refusal("truncated.mesh", mesh.substr(0, mesh.size() / 2));
  expect_refusal("empty.vtu", "");
  expect_refusal("truncated.vtu", grid.substr(0, grid.size() / 2));
  expect_refusal("no_grid.vtu", mesh);
  Mesh bad = layers();
  bad.points[bad.tetrahedra[7][1]] = bad.points[bad.tetrahedra[7][0]];
  expect_refusal("flat.mesh", medit(bad));
  expect_refusal("flat.vtu", vtu(bad, "label"));
  bad = layers();
  bad.points[3][1] = std::numeric_limits<double>::quiet_NaN();
  expect_refusal("nan.mesh", medit(bad));
  expect_refusal("nan.vtu", vtu(bad, "label"));
  bad = layers();
  bad.tetrahedra.push_back(bad.tetrahedra.front());
  bad.labels.push_back(5);
  expect_refusal("twice.mesh", medit(bad));
}

// What a MEDIT file contains, computed from its text.
struct Measures
{
  std::map<int, double> volumes; // by label
  double boundary = 0;           // area of the facets with one tetrahedron
  std::size_t tetrahedra = 0, points = 0, different_points = 0;
};

using Vector = std::array<double, 3>;

Vector difference(const std::string& p, const std::string& q) {
  Vector a, b;
  std::istringstream(p) >> a[0] >> a[1] >> a[2];
  std::istringstream(q) >> b[0] >> b[1] >> b[2];
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Vector cross_product(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Measures measures(const std::string& mesh) {
  Measures result;
  std::istringstream in(mesh.substr(mesh.find("Vertices") + 8));
  in >> result.points;
  std::map<std::set<std::string>, int> facets;
  std::set<std::string> points;
  for (const auto& [vertices, label] : simplices(mesh, "Tetrahedra", 4)) {
    ++result.tetrahedra;
    const std::vector<std::string> v(vertices.begin(), vertices.end());
    points.insert(v.begin(), v.end());
    const Vector normal = cross_product(difference(v[1], v[0]), difference(v[2], v[0])),
                 edge = difference(v[3], v[0]);
    result.volumes[label] +=
        std::abs(normal[0] * edge[0] + normal[1] * edge[1] + normal[2] * edge[2]) / 6;
    for (const std::string& p : v) {
      auto facet = vertices;
      facet.erase(p);
      ++facets[facet];
    }
  }
  result.different_points = points.size();
  for (const auto& [facet, number] : facets) {
    const std::vector<std::string> v(facet.begin(), facet.end());
    const Vector normal = cross_product(difference(v[1], v[0]), difference(v[2], v[0]));
    if (number == 1)
      result.boundary += std::hypot(normal[0], normal[1], normal[2]) / 2;
  }
  return result;
}

int distance_from(int center, int x, int y, int z) {
  return (std::max)({std::abs(x - center), std::abs(y - center), std::abs(z - center)});
}

// Parts, rings, shells, a cavity in a part in a cavity, and parts that touch in edges and vertices.
TEST_F(Improve, takes_domains_of_any_shape) {
  const std::vector<std::pair<const char*, Mesh>> meshes = {
      {"parts", cubes(
                    5, 2, 2, [](int x, int, int) { return x == 2 ? -1 : x; }, .45)},
      {"ring",
       cubes(
           5, 5, 2, [](int x, int y, int) { return x == 2 && y == 2 ? -1 : 1 + (x > 2); }, .45)},
      {"shell",
       cubes(
           7, 7, 7, [](int x, int y, int z) { return distance_from(3, x, y, z) - 1; }, .45)},
      {"nested", cubes(
                     9, 9, 9,
                     [](int x, int y, int z) {
                       const int distance = distance_from(4, x, y, z);
                       return distance % 2 == 1 ? -1 : distance;
                     },
                     .45)},
      {"edges", cubes(4, 4, 2, [](int x, int y, int) { return (x + y) % 2 == 0 ? 3 : -1; })},
      {"vertices", cubes(
                       4, 4, 4,
                       [](int x, int y, int z) {
                         return (x / 2 + y / 2) % 2 + (y / 2 + z / 2) % 2 == 0 ? 0 : -1;
                       },
                       .45)}};
  for (const auto& [name, all] : meshes) {
    SCOPED_TRACE(name);
    const Mesh mesh = without_unused_points(all);
    write("a.mesh", medit(mesh));
    const Measures before = measures(contents(path("a.mesh")));
    expect_success("improve a.mesh -o b.mesh --report r.json");
    const Measures after = measures(contents(path("b.mesh")));
    ASSERT_EQ(after.volumes.size(), before.volumes.size());
    for (const auto& [label, volume] : before.volumes)
      EXPECT_NEAR(after.volumes.at(label), volume, 1e-9) << label;
    EXPECT_NEAR(after.boundary, before.boundary, 1e-9);
    EXPECT_EQ(after.points, after.different_points);
    EXPECT_EQ(report("r.json").at("before").at("tetrahedra"), before.tetrahedra);
    EXPECT_EQ(report("r.json").at("before").at("vertices"), before.different_points);
    EXPECT_GE(report("r.json").at("after").at("min_dihedral").get<double>(),
              report("r.json").at("before").at("min_dihedral").get<double>());
    write("a.vtu", vtu(mesh, "label"));
    expect_success("improve a.vtu -o c.mesh");
    EXPECT_EQ(contents(path("c.mesh")), contents(path("b.mesh")));
    expect_success("convert a.mesh d.vtu");
    EXPECT_EQ(info("d.vtu", "tetrahedra"), info("a.mesh", "tetrahedra"));
  }
}

TEST_F(Improve, says_where_tetrahedra_are_flat) {
  Mesh bad = layers();
  bad.points[bad.tetrahedra.back()[1]] = bad.points[bad.tetrahedra.back()[0]];
  expect_refusal("flat.mesh", medit(bad));
  EXPECT_PRED2(contains, contents(path("stderr.txt")), "at the point ");
}

TEST_F(Improve, reports_before_and_after) {
  expect_success("improve layers.mesh -o out.mesh --report report.json");
  const Json report = this->report("report.json");
  EXPECT_EQ(report.at("input"), "layers.mesh");
  EXPECT_EQ(report.at("parameters"), (Json{{"command", "improve"},
                                           {"output", "out.mesh"},
                                           {"aggressive", false},
                                           {"threshold", nullptr}}));
  EXPECT_GT(report.at("seconds").get<double>(), 0);
  EXPECT_EQ(report.size(), 5u);
  for (const char* moment : {"before", "after"}) {
    const Json& state = report.at(moment);
    std::set<std::string> keys;
    for (const auto& item : state.items())
      keys.insert(item.key());
    EXPECT_EQ(keys, (std::set<std::string>{
                        "vertices", "tetrahedra", "interface_triangles", "labels", "min_dihedral",
                        "max_dihedral", "dihedral_histogram", "dihedrals_outside_6_171",
                        "min_quality", "split", "collapsed", "flipped", "smoothed", "inserted"}));
    EXPECT_EQ(state.at("interface_triangles"), 32);
    ASSERT_EQ(state.at("labels").size(), 2u);
    for (int label : {2, 5}) {
      EXPECT_NEAR(label_of(state, label).at("volume").get<double>(), 32, 1e-9);
      EXPECT_NEAR(label_of(state, label).at("area").get<double>(), 16, 1e-9);
    }
  }
  const Json &before = report.at("before"), &after = report.at("after");
  EXPECT_EQ(before.at("vertices"), 125);
  EXPECT_EQ(before.at("tetrahedra"), 384);
  for (const char* count : {"split", "collapsed", "flipped", "smoothed", "inserted"})
    EXPECT_EQ(before.at(count), 0);
  EXPECT_GT(after.at("min_quality").get<double>(), before.at("min_quality").get<double>());
  EXPECT_EQ(info("out.mesh", "tetrahedra"), after.at("tetrahedra").get<double>());
}

// The quality in the report is the measure that is improved. It never falls.
TEST_F(Improve, reports_the_quality_that_it_improves) {
  write("flat.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices\n5\n"
                     "0 0 0 0\n1 0 0 0\n.5 .8 0 0\n.5 .3 .001 0\n.5 .3 1 0\n"
                     "Tetrahedra\n4\n1 2 3 4 1\n1 2 4 5 1\n2 3 4 5 1\n3 1 4 5 1\nEnd\n");
  expect_success("improve flat.mesh -o out.mesh --report report.json");
  const Json report = this->report("report.json");
  const double before = report.at("before").at("min_quality").get<double>(),
               after = report.at("after").at("min_quality").get<double>();
  EXPECT_LE(before, after);
  const auto sine = [&](const char* angle) {
    return std::sin(report.at("before").at(angle).get<double>() * std::acos(-1.) / 180);
  };
  const double of_regular = std::sqrt(8.) / 3;
  EXPECT_NEAR(before, (std::min)(sine("min_dihedral"), .7 * sine("max_dihedral")) / of_regular,
              1e-9);
}

TEST_F(Improve, leaves_the_interface_as_it_was) {
  expect_success("improve layers.mesh -o same.mesh --threshold 1e-9");
  expect_success("improve layers.mesh -o better.mesh");
  const std::string same = contents(path("same.mesh")), better = contents(path("better.mesh"));
  EXPECT_EQ(interface_triangles(same).size(), 32u);
  EXPECT_EQ(interface_triangles(better), interface_triangles(same));
  EXPECT_FALSE(same == better);
}

TEST_F(Improve, prints_one_line_or_nothing) {
  const Outcome loud = run("improve layers.mesh -o out.mesh");
  EXPECT_EQ(loud.exit_code, 0) << loud.err;
  EXPECT_EQ(std::count(loud.out.begin(), loud.out.end(), '\n'), 1) << loud.out;
  EXPECT_EQ(loud.out.rfind("dsc: 384 -> ", 0), 0u) << loud.out;
  EXPECT_EQ(run("improve layers.mesh -o out.mesh --quiet").out, "");
}

TEST_F(Improve, passes_parameters_on) {
  expect_success("improve layers.mesh -o out.vtu --aggressive --threshold 0.5 --report r.json");
  const Json parameters = report("r.json").at("parameters");
  EXPECT_EQ(parameters.at("aggressive"), true);
  EXPECT_EQ(parameters.at("threshold"), 0.5);
  EXPECT_EQ(parameters.at("output"), "out.vtu");
}

TEST_F(Improve, may_replace_its_input) {
  expect_success("improve layers.mesh -o out.mesh");
  expect_success("improve layers.mesh -o layers.mesh");
  EXPECT_TRUE(contents(path("layers.mesh")) == contents(path("out.mesh")));
}

TEST_F(Improve, formats_agree) {
  expect_success("improve layers.mesh -o from_mesh.mesh");
  expect_success("improve layers.mesh -o from_mesh.vtu");
  write("compressed_text.vtu", vtu(layers(), "label", "compressor=\"vtkZLibDataCompressor\""));
  for (const std::string input : {"layers.vtu", "compressed_text.vtu"}) {
    expect_success("improve " + input + " -o from_vtu.mesh");
    expect_success("improve " + input + " -o from_vtu.vtu");
    for (const std::string extension : {".mesh", ".vtu"})
      EXPECT_TRUE(contents(path("from_mesh" + extension)) == contents(path("from_vtu" + extension)))
          << input << extension;
  }
  for (const char* key : {"vertices", "tetrahedra", "interface triangles", "smallest quality"})
    EXPECT_EQ(info("from_mesh.vtu", key), info("from_mesh.mesh", key));
}

// Points without tetrahedra, any orientation, line ends of other systems
TEST_F(Improve, takes_meshes_as_other_programs_write_them) {
  expect_success("improve layers.mesh -o expected.mesh");
  Mesh foreign = layers();
  for (std::size_t i = 0; i < foreign.tetrahedra.size(); i += 3)
    std::swap(foreign.tetrahedra[i][2], foreign.tetrahedra[i][3]);
  foreign.points.insert(foreign.points.begin() + 5, 2, std::array<double, 3>{100, -50, 3});
  for (auto& tetrahedron : foreign.tetrahedra)
    for (std::size_t& v : tetrahedron)
      v += v < 5 ? 0 : 2;
  foreign.points.push_back({7, 7, 7});
  std::string text;
  for (const char c : medit(foreign))
    text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  write("foreign.mesh", text);
  write("foreign.vtu", vtu(foreign, "MaterialIDs"));
  for (const std::string input : {"foreign.mesh", "foreign.vtu"}) {
    const Outcome outcome = run("improve " + input + " -o out.mesh");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "dsc: " + input + ": not used: 3 points without a tetrahedron\n");
    EXPECT_TRUE(contents(path("out.mesh")) == contents(path("expected.mesh"))) << input;
    expect_loss_is_refused(input, "3 points without a tetrahedron");
  }
}

// Returns the numbers of an array on points or cells of a file; nothing if there is none.
std::vector<double> array_of(const Vtu_reader& file, const std::string& name) {
  for (const std::string section : {"PointData", "CellData"})
    for (const auto& array : file.announced_arrays(section))
      if (array.name == name)
        return file.array(section, name,
                          section == "CellData" ? file.number_of_cells() : file.number_of_points(),
                          array.components);
  return {};
}

std::vector<double> points_of(const Vtu_reader& file) {
  return file.array("Points", "", file.number_of_points(), 3);
}

// Returns the volumes of the tetrahedra of a grid.
std::vector<double> volumes(const Vtu_reader& file) {
  const std::vector<double> p = points_of(file), corners = file.array("Cells", "connectivity",
                                                                      4 * file.number_of_cells());
  std::vector<double> result;
  for (std::size_t i = 0; i < corners.size(); i += 4) {
    double e[3][3];
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k)
        e[j][k] = p[3 * std::size_t(corners[i + j + 1]) + k] - p[3 * std::size_t(corners[i]) + k];
    result.push_back((e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
                      e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
                      e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0])) /
                     6);
  }
  return result;
}

// The layers with arrays: x at points; a density and the fraction of each layer at cells.
std::string grid_with_fields(vtu_grid::Grid grid = vtu_grid::Grid()) {
  const Mesh mesh = layers();
  std::vector<double> x, density;
  std::vector<int> parts;
  for (const auto& p : mesh.points)
    x.push_back(2 * p[0] + 1);
  for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i) {
    density.push_back(1 + 0.25 * double(i % 7));
    parts.push_back(mesh.points[mesh.tetrahedra[i][0]][1] < 2 ? 70 : 30);
  }
  grid.array("PointData", "Float64", "heat", x)
      .array("CellData", "Float64", "density", density)
      .array("CellData", "Int32", "part", parts);
  return vtu(mesh, "material", "", grid);
}

TEST_F(Improve, does_not_guess_labels) {
  const std::string text = vtu(layers(), "material");
  expect_refusal("material.vtu", text);
  const std::string message = contents(path("stderr.txt"));
  EXPECT_PRED2(contains, message, "'material' (Int32, integers from 2 to 5)");
  EXPECT_PRED2(contains, message, "--labels NAME");
  expect_error("offset material.vtu --distance 0.1 --steps 1", 1);
  expect_error("info material.vtu", 1);
  expect_error("improve material.vtu -o out.mesh --labels materials", 1);
  expect_error("improve layers.mesh -o out.mesh --labels material", 2);

  expect_success("improve layers.vtu -o expected.mesh");
  expect_success("improve material.vtu -o out.mesh --labels material");
  EXPECT_TRUE(contents(path("out.mesh")) == contents(path("expected.mesh")));
  expect_success("offset material.vtu --distance 0.01 --steps 1 --quiet --labels material");
  EXPECT_EQ(run("improve material.vtu -o one.mesh --labels none").err,
            "dsc: material.vtu: not used: 1 cell array (material)\n");
  EXPECT_EQ(info("one.mesh", "interface triangles"), 0);
  // The array keeps its name, so that the file can be improved again and used as before.
  expect_success("improve material.vtu -o material.vtu --labels material");
  const Vtu_reader improved(path("material.vtu").string());
  EXPECT_FALSE(array_of(improved, "material").empty());
  EXPECT_EQ(array_of(improved, "material"), array_of(improved, "label"));
}

TEST_F(Improve, carries_arrays) {
  write("fields.vtu", grid_with_fields());
  expect_success("improve fields.vtu -o fields.vtu --labels material --report r.json");
  const auto angle = [&](const char* moment) {
    return report("r.json").at(moment).at("min_dihedral").get<double>();
  };
  EXPECT_GT(angle("after"), angle("before"));
  const Vtu_reader file(path("fields.vtu").string());
  const std::vector<double> points = points_of(file), heat = array_of(file, "heat");
  ASSERT_EQ(points.size(), 3 * heat.size());
  for (std::size_t i = 0; i < heat.size(); ++i) // linear functions are preserved
    EXPECT_NEAR(heat[i], 2 * points[3 * i] + 1, 1e-9);

  const auto integral = [](const std::vector<double>& volume, const std::vector<double>& density) {
    double sum = 0;
    for (std::size_t i = 0; i < volume.size(); ++i)
      sum += volume[i] * density.at(i);
    return sum;
  };
  // Returns the volumes of the input as written by the program, which changes nothing here.
  write("before.vtu", grid_with_fields());
  expect_success("improve before.vtu -o before.vtu --labels material --threshold 1e-9");
  const Vtu_reader same(path("before.vtu").string());
  EXPECT_NEAR(integral(volumes(file), array_of(file, "density")),
              integral(volumes(same), array_of(same, "density")), 1e-9);
  const std::vector<double> parts = array_of(file, "part"), volume = volumes(file);
  double first = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    EXPECT_TRUE(parts[i] == 70 || parts[i] == 30) << parts[i];
    first += parts[i] == 70 ? volume[i] : 0;
  }
  EXPECT_NEAR(first, 32, 1e-9); // integers keep their positions
  EXPECT_EQ(array_of(file, "material"), array_of(file, "label"));
}

TEST_F(Improve, replaces_no_input_by_less) {
  std::vector<int> ids;
  for (std::size_t i = 0; i < layers().tetrahedra.size(); ++i)
    ids.push_back(int(i));
  write("ids.vtu", grid_with_fields(vtu_grid::Grid().array("CellData", "Int32", "id", ids)));
  expect_loss_is_refused("ids.vtu --labels material", "('id')");
  const Outcome outcome = run("improve ids.vtu -o out.vtu --labels material");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "dsc: ids.vtu: not used: 1 array of cell numbers, which change ('id')\n");
  EXPECT_FALSE(array_of(Vtu_reader(path("out.vtu").string()), "heat").empty());
  // MEDIT files cannot contain arrays.
  write("fields.vtu", grid_with_fields());
  EXPECT_PRED2(contains, run("improve fields.vtu -o out.mesh --labels material").err,
               "point array (heat)");
  write("layers.sol", "MeshVersionFormatted 2\n");
  expect_loss_is_refused("layers.mesh", "layers.sol");
}

// Facets and edges of tetrahedra inside, on the interface and on the boundary.
std::string mesh_with_entities(const Mesh& mesh) {
  std::ostringstream triangles, edges, vertices;
  int number_of_triangles = 0, number_of_edges = 0, number_of_vertices = 0;
  for (std::size_t i = 5; i < mesh.tetrahedra.size(); i += 23) {
    const auto& t = mesh.tetrahedra[i];
    ++number_of_triangles;
    triangles << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << ' ' << i << '\n';
    if (i % 2 == 0) {
      ++number_of_edges;
      edges << t[1] + 1 << ' ' << t[3] + 1 << ' ' << -int(i) << '\n';
    } else if (i % 3 == 0) {
      ++number_of_vertices;
      vertices << t[2] + 1 << '\n';
    }
  }
  std::string text = medit(mesh);
  text.erase(text.find("End\n"));
  return text + "Triangles\n" + std::to_string(number_of_triangles) + '\n' + triangles.str() +
         "Edges\n" + std::to_string(number_of_edges) + '\n' + edges.str() + "RequiredVertices\n" +
         std::to_string(number_of_vertices) + '\n' + vertices.str() +
         "Corners\n2\n1\n32\nRidges\n1\n1\nRequiredEdges\n1\n2\nRequiredTriangles\n2\n1\n3\nEnd\n";
}

TEST_F(Improve, keeps_entities) {
  const std::string text = mesh_with_entities(layers());
  write("entities.mesh", text);
  for (const std::string options : {"", " --aggressive"}) {
    SCOPED_TRACE(options);
    write("a.mesh", text);
    expect_success("improve a.mesh -o a.mesh" + options + " --report r.json");
    const std::string file = contents(path("a.mesh"));
    EXPECT_GT(report("r.json").at("after").at("flipped").get<int>(), 0);
    const auto expected = simplices(text, "Triangles", 3), now = simplices(file, "Triangles", 3);
    EXPECT_GT(expected.size(), 10u);
    EXPECT_TRUE(std::includes(now.begin(), now.end(), expected.begin(), expected.end()));
    EXPECT_EQ(simplices(file, "Edges", 2), simplices(text, "Edges", 2));
    for (const char* section : {"Corners", "RequiredVertices"})
      EXPECT_EQ(simplices(file, section, 1), simplices(text, section, 1)) << section;
    EXPECT_EQ(file.substr(file.find("Ridges\n")), text.substr(text.find("Ridges\n")));
    EXPECT_EQ(info("a.mesh", "label 5"), info("entities.mesh", "label 5"));
    const auto angle = [&](const char* moment) {
      return report("r.json").at(moment).at("min_dihedral").get<double>();
    };
    EXPECT_GE(angle("after"), angle("before"));
  }
  EXPECT_PRED2(contains, run("improve entities.mesh -o out.vtu").err, "2 corners");
  EXPECT_PRED2(contains, run("offset entities.mesh --distance 0.01 --steps 1").err, "17 triangles");
}

// Entities and values at an edge that belongs to two cubes which do not touch elsewhere.
TEST_F(Improve, keeps_the_content_where_a_domain_touches_itself) {
  const Mesh mesh =
      without_unused_points(cubes(2, 2, 1, [](int x, int y, int) { return x == y ? 1 : -1; }));
  const auto number = [&](double x, double y, double z) {
    const auto found = std::find(mesh.points.begin(), mesh.points.end(), Vector{x, y, z});
    return ' ' + std::to_string(found - mesh.points.begin() + 1);
  };
  const std::string edge = number(1, 1, 0) + number(1, 1, 1), before = number(0, 0, 0),
                    after = number(2, 2, 1);
  std::string text = medit(mesh);
  text.erase(text.find("End\n"));
  text += "Edges\n1\n" + edge + " 7\nTriangles\n2\n" + before + edge + " 8\n" + edge + after +
          " 9\nCorners\n1\n" + number(1, 1, 0) + "\nEnd\n";
  write("edge.mesh", text);
  for (const std::string command :
       {"improve edge.mesh -o out.mesh", "convert edge.mesh out.mesh"}) {
    SCOPED_TRACE(command);
    expect_success(command);
    const std::string out = contents(path("out.mesh"));
    EXPECT_EQ(simplices(out, "Edges", 2), simplices(text, "Edges", 2));
    EXPECT_EQ(simplices(out, "Triangles", 3), simplices(text, "Triangles", 3));
    EXPECT_EQ(simplices(out, "Corners", 1), simplices(text, "Corners", 1));
  }
  std::vector<double> heat;
  for (const auto& p : mesh.points)
    heat.push_back(p[0] + 10 * p[1] + 100 * p[2]);
  write("heat.vtu",
        vtu(mesh, "label", "", vtu_grid::Grid().array("PointData", "Float64", "heat", heat)));
  expect_success("improve heat.vtu -o heat.vtu");
  expect_success("convert heat.vtu converted.vtu");
  for (const char* name : {"heat.vtu", "converted.vtu"}) {
    SCOPED_TRACE(name);
    const Vtu_reader file(path(name).string());
    const auto values = array_of(file, "heat");
    const std::vector<double> points = points_of(file);
    ASSERT_EQ(values.size(), 14u);
    ASSERT_EQ(points.size(), 42u);
    for (std::size_t i = 0; i < values.size(); ++i)
      EXPECT_EQ(values[i], points[3 * i] + 10 * points[3 * i + 1] + 100 * points[3 * i + 2]);
  }
}

// An inner surface between cells of one label, like a crack or a membrane.
TEST_F(Improve, keeps_inner_surfaces) {
  Mesh mesh = layers();
  std::fill(mesh.labels.begin(), mesh.labels.end(), 1);
  std::string one = medit(mesh);
  one.erase(one.find("End\n"));
  // Returns the triangles between the layers, in the order of the program.
  expect_success("improve layers.mesh -o same.mesh --threshold 1e-9");
  const auto surface = simplices(contents(path("same.mesh")), "Triangles", 3);
  std::ostringstream triangles;
  for (const auto& [corners, reference] : surface) {
    for (const std::string& corner : corners)
      for (std::size_t i = 0; i < mesh.points.size(); ++i)
        if (numbers(mesh.points[i]) == corner)
          triangles << i + 1 << ' ';
    triangles << reference << '\n';
  }
  write("one.mesh",
        one + "Triangles\n" + std::to_string(surface.size()) + '\n' + triangles.str() + "End\n");
  expect_success("improve one.mesh -o one.mesh");
  EXPECT_EQ(simplices(contents(path("one.mesh")), "Triangles", 3), surface);
  // As good as with two labels: nothing else is constrained.
  expect_success("improve layers.mesh -o two.mesh");
  EXPECT_EQ(info("one.mesh", "tetrahedra"), info("two.mesh", "tetrahedra"));
}

TEST_F(Improve, refuses_other_cells) {
  std::string text = medit(layers());
  text.erase(text.find("End\n"));
  expect_refusal("hexahedra.mesh", text + "Hexahedra\n1\n1 2 7 6 26 27 32 31 5\nEnd\n");
  expect_refusal("label.mesh", text + "Tetrahedra\n1\n1 2 3 4 3000000000\nEnd\n");
  EXPECT_PRED2(contains, contents(path("stderr.txt")), "'3000000000'");
}

} // namespace
