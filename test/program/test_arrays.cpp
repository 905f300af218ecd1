// Arrays of input files, which follow the motions of the program to its output.
#include "program.h"
#include "test.h"
#include "vtu_grid.h"

#include <CGAL/Mesh_files/internal/grids/Vtu_reader.h>

#include <cmath>

namespace {

using CGAL::Deformable_simplicial_complexes::internal::Vtu_reader;
using namespace program;

// What a file contains, by the name of each array.
struct Grid
{
  std::map<std::string, std::vector<double>> points, cells;
  std::vector<double> coordinates;
  std::vector<std::size_t> corners; // four for each cell

  explicit Grid(const fs::path& path) {
    const Vtu_reader file(path.string());
    coordinates = file.array("Points", "", file.number_of_points(), 3);
    for (const double v : file.array("Cells", "connectivity", 4 * file.number_of_cells()))
      corners.push_back(std::size_t(v));
    for (const auto& a : file.announced_arrays("PointData"))
      points[a.name] = file.array("PointData", a.name, file.number_of_points(), a.components);
    for (const auto& a : file.announced_arrays("CellData"))
      cells[a.name] = file.array("CellData", a.name, file.number_of_cells(), a.components);
  }

  double volume(std::size_t cell) const {
    double e[3][3];
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k)
        e[j][k] =
            coordinates[3 * corners[4 * cell + j + 1] + k] - coordinates[3 * corners[4 * cell] + k];
    return std::abs(e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
                    e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
                    e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0])) /
           6;
  }

  double integral(const std::string& name) const {
    double sum = 0;
    for (std::size_t i = 0; i < cells.at(name).size(); ++i)
      sum += volume(i) * cells.at(name)[i];
    return sum;
  }
};

// Three layers of a material each, of 4 x 4 cubes, each of which has six tetrahedra.
class Arrays : public program::Program_test
{
protected:
  void SetUp() override {
    Program_test::SetUp();
    if (IsSkipped())
      return;
    for (int z = 0; z <= 3; ++z)
      for (int y = 0; y <= 4; ++y)
        for (int x = 0; x <= 4; ++x)
          m_points.push_back({x / 4., y / 4., z / 4.});
    std::array<int, 3> cube;
    for (cube[2] = 0; cube[2] < 3; ++cube[2])
      for (cube[1] = 0; cube[1] < 4; ++cube[1])
        for (cube[0] = 0; cube[0] < 4; ++cube[0]) {
          std::array<std::size_t, 3> axes = {0, 1, 2};
          do {
            std::array<int, 3> p = cube;
            m_cells.push_back({index(p)});
            for (std::size_t i = 0; i < 3; ++i) {
              ++p[axes[i]];
              m_cells.back()[i + 1] = index(p);
            }
            m_labels.push_back(cube[2] + 1);
          } while (std::next_permutation(axes.begin(), axes.end()));
        }
    write("layers.vtu", grid());
  }

  // Returns the layers with arrays.
  std::string grid() const {
    std::vector<double> heat, density;
    std::vector<int> side, mask, id, number;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
      heat.push_back(2 * m_points[i][0] + m_points[i][2]);
      side.push_back(m_points[i][1] < 0.5 ? 5 : 9);
      number.push_back(int(i + 1));
    }
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
      density.push_back(1 + 0.25 * double(i % 7));
      mask.push_back(int(i % 2));
      id.push_back(int((i * 5) % m_cells.size())); // a permutation
    }
    std::vector<double> coordinates;
    std::vector<std::size_t> connectivity, offsets;
    for (const auto& p : m_points)
      coordinates.insert(coordinates.end(), p.begin(), p.end());
    for (const auto& c : m_cells) {
      connectivity.insert(connectivity.end(), c.begin(), c.end());
      offsets.push_back(connectivity.size());
    }
    return vtu_grid::Grid()
        .array("PointData", "Float32", "heat", heat)
        .array("PointData", "Int32", "side", side)
        .array("PointData", "Int64", "node", number)
        .array("CellData", "Int32", "material", m_labels)
        .array("CellData", "Float64", "density", density)
        .array("CellData", "UInt8", "mask", mask)
        .array("CellData", "Int64", "id", id)
        .array("Points", "Float64", "Points", coordinates)
        .array("Cells", "Int64", "connectivity", connectivity)
        .array("Cells", "Int64", "offsets", offsets)
        .array("Cells", "UInt8", "types", std::vector<int>(m_cells.size(), 10))
        .text("NumberOfPoints=\"" + std::to_string(m_points.size()) + "\" NumberOfCells=\"" +
              std::to_string(m_cells.size()) + "\"");
  }

  // Runs a motion of the layers. Returns the cells of a step.
  Grid moved(const std::string& motion, const char* step) const {
    const Outcome outcome = run(motion + " --labels material --quiet --output out");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return Grid(path(std::string("out/volume_00000") + step + ".vtu"));
  }

  void expect_arrays(const Grid& grid) const {
    EXPECT_EQ(grid.cells.at("material"), grid.cells.at("label"));
    EXPECT_EQ(grid.cells.count("id"), 0u);
    EXPECT_EQ(grid.points.count("node"), 0u);
    for (const double mask : grid.cells.at("mask"))
      EXPECT_TRUE(mask == 0 || mask == 1);
    for (const double side : grid.points.at("side"))
      EXPECT_TRUE(side == 5 || side == 9);
    for (const double heat : grid.points.at("heat"))
      EXPECT_TRUE(0 <= heat && heat <= 2.75) << heat;
  }

  std::vector<std::array<double, 3>> m_points;
  std::vector<std::array<std::size_t, 4>> m_cells;
  std::vector<int> m_labels;

private:
  static std::size_t index(const std::array<int, 3>& p) {
    return std::size_t(p[2] * 25 + p[1] * 5 + p[0]);
  }
};

TEST_F(Arrays, follow_motions) {
  double sum = 0;
  for (std::size_t i = 0; i < m_cells.size(); ++i)
    sum += (1 + 0.25 * double(i % 7)) / 384;
  for (const std::string motion :
       {"offset layers.vtu --distance 0.02 --steps 2", "mean-curvature layers.vtu --steps 2",
        "offset layers.vtu --distance 0.02 --steps 2 --move-faces",
        "offset layers.vtu --distance 0.02 --steps 2 --improve-interface",
        "rotate layers.vtu --axis 1,2,3 --angle 30 --steps 2",
        "advect layers.vtu --velocity y,0,0 --dt 0.1 --steps 2 --domain grow",
        "advect layers.vtu --velocity '0,0,x*(1-x)*y*(1-y)' --dt 0.5 --steps 2 --domain mesh"}) {
    SCOPED_TRACE(motion);
    fs::remove_all(path("out"));
    const Grid end = moved(motion, "2"), start(path("out/volume_000000.vtu"));
    for (const Grid& grid : {start, end}) {
      expect_arrays(grid);
      EXPECT_NEAR(grid.integral("density"), sum, 1e-9 * sum);
    }
    // The values at the start are those of the file.
    for (std::size_t i = 0; i < start.cells.at("label").size(); ++i)
      if (start.cells.at("label")[i] == 0)
        EXPECT_EQ(start.cells.at("mask")[i] + start.cells.at("density")[i], 0);
      else
        for (std::size_t k = 4 * i; k < 4 * i + 4; ++k) {
          const double* const p = &start.coordinates[3 * start.corners[k]];
          EXPECT_NEAR(start.points.at("heat")[start.corners[k]], 2 * p[0] + p[2], 1e-6);
        }
  }
}

TEST_F(Arrays, on_points_are_on_the_interface) {
  moved("offset layers.vtu --distance 0.02 --steps 1", "1");
  const Vtu_reader file(path("out/interface_000000.vtu").string());
  const std::vector<double> p = file.array("Points", "", file.number_of_points(), 3),
                            heat = file.array("PointData", "heat", file.number_of_points());
  ASSERT_FALSE(heat.empty());
  for (std::size_t i = 0; i < heat.size(); ++i)
    EXPECT_NEAR(heat[i], 2 * p[3 * i] + p[3 * i + 2], 1e-6);
}

TEST_F(Arrays, that_cannot_follow_are_told) {
  EXPECT_EQ(run("offset layers.vtu --labels material --distance 0.01 --steps 1").err,
            "dsc: layers.vtu: not used: 1 array of cell numbers, which change ('id'), 1 array of "
            "point numbers, which change ('node')\n");
}

TEST_F(Arrays, are_kept_in_checkpoints) {
  const std::string motion = "mean-curvature layers.vtu --dt 0.001 --steps ";
  moved(motion + "2", "2");
  const std::string whole = contents(path("out/volume_000002.vtu")),
                    checkpoint = contents(path("out/checkpoint.dsc"));
  fs::remove_all(path("out"));
  moved(motion + "1", "1");
  expect_success("mean-curvature --resume out/checkpoint.dsc --steps 1 --quiet --output out");
  EXPECT_TRUE(contents(path("out/volume_000002.vtu")) == whole);
  EXPECT_TRUE(contents(path("out/checkpoint.dsc")) == checkpoint);
  expect_success("convert out/checkpoint.dsc converted.vtu");
  EXPECT_TRUE(contents(path("converted.vtu")) == whole);
}

TEST_F(Arrays, survive_conversion) {
  run("convert layers.vtu converted.vtu --labels material");
  const Grid grid(path("converted.vtu"));
  expect_arrays(grid);
  for (std::size_t i = 0; i < grid.points.at("heat").size(); ++i)
    EXPECT_NEAR(grid.points.at("heat")[i],
                2 * grid.coordinates[3 * i] + grid.coordinates[3 * i + 2], 1e-6);
}

// Each cell has points of its own.
TEST_F(Arrays, of_repeated_points_are_merged) {
  const std::size_t cells = m_cells.size();
  std::vector<std::array<double, 3>> points;
  for (auto& cell : m_cells)
    for (std::size_t& v : cell) {
      points.push_back(m_points[v]);
      v = points.size() - 1;
    }
  m_points = points;
  write("repeated.vtu", grid());
  std::string medit =
      "MeshVersionFormatted 2\nDimension 3\nVertices\n" + std::to_string(points.size()) + '\n';
  for (std::size_t i = 0; i < points.size(); ++i)
    medit += std::to_string(points[i][0]) + ' ' + std::to_string(points[i][1]) + ' ' +
             std::to_string(points[i][2]) + ' ' + std::to_string(i % 3) + '\n';
  medit += "Tetrahedra\n" + std::to_string(cells) + '\n';
  for (std::size_t i = 0; i < cells; ++i)
    medit += std::to_string(4 * i + 1) + ' ' + std::to_string(4 * i + 2) + ' ' +
             std::to_string(4 * i + 3) + ' ' + std::to_string(4 * i + 4) + ' ' +
             std::to_string(m_labels[i]) + '\n';
  write("repeated.mesh", medit + "End\n");
  for (const std::string file : {"repeated.vtu --labels material", "repeated.mesh"}) {
    EXPECT_EQ(info(file, "vertices"), 100);
    EXPECT_EQ(info(file, "tetrahedra"), double(cells));
  }
  const std::size_t corners = 4 * cells;
  EXPECT_EQ(run("improve repeated.mesh -o merged.mesh").err,
            "dsc: repeated.mesh: not used: " + std::to_string(corners) +
                " vertex references, which differ at equal points\n");
  const Outcome outcome = run("improve repeated.vtu --labels material -o merged.vtu");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.err.find("1 point array with several values at a point ('node')"),
            std::string::npos)
      << outcome.err;
  const Grid grid(path("merged.vtu"));
  for (std::size_t i = 0; i < grid.points.at("heat").size(); ++i)
    EXPECT_NEAR(grid.points.at("heat")[i],
                2 * grid.coordinates[3 * i] + grid.coordinates[3 * i + 2], 1e-6);
}

} // namespace
