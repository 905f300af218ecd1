// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Rotates a surface by 360 degrees, offsets it outwards and back or inwards, shrinks it by mean
// curvature, displaces a small part of it, or displaces nothing. Measures the costs and the changes
// of the surface. Prints a row of a table, without the table head.

#include "inputs.h"
#include "measures.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Interface_flows/Mean_curvature_flow.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/interface_flows_3.h>
#include <CGAL/Interface_remeshing/improve_interface.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc_benchmark {
namespace {

using Json = nlohmann::ordered_json;
namespace parameters = CGAL::parameters;

/// The interface before a motion. Time stamps identify remaining vertices, because none is used
/// twice.
class Initial_interface
{
public:
  explicit Initial_interface(const Complex& complex) : m_triangles(triangles(complex)) {
    for (const Complex::Vertex_handle v : complex.interface_vertices())
      m_vertices.emplace_back(v->time_stamp(), complex.position(v));
  }

  std::size_t number_of_vertices() const { return m_vertices.size(); }

  /// Returns the distance of each remaining interface vertex from its initial position.
  std::vector<double> distances(const Complex& complex) const {
    std::vector<double> result;
    auto initial = m_vertices.begin();
    for (const Complex::Vertex_handle v : complex.interface_vertices()) {
      while (initial != m_vertices.end() && initial->first < v->time_stamp())
        ++initial;
      if (initial != m_vertices.end() && initial->first == v->time_stamp())
        result.push_back(std::sqrt((complex.position(v) - initial->second).squared_length()));
    }
    return result;
  }

  /// Returns the fraction of the triangles whose vertices remain and are on the interface.
  double unchanged_triangles(const Complex& complex) const {
    const std::vector<Triangle> now = triangles(complex);
    const auto is_left = [&](const Triangle& t) {
      return std::binary_search(now.begin(), now.end(), t);
    };
    return double(std::count_if(m_triangles.begin(), m_triangles.end(), is_left)) /
           double(m_triangles.size());
  }

private:
  using Triangle = std::array<std::size_t, 3>;

  static std::vector<Triangle> triangles(const Complex& complex) {
    std::vector<Triangle> result;
    for (const Complex::Facet& f : complex.interface_facets()) {
      const auto v = complex.facet_vertices(f);
      result.push_back({v[0]->time_stamp(), v[1]->time_stamp(), v[2]->time_stamp()});
      std::sort(result.back().begin(), result.back().end());
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  std::vector<std::pair<std::size_t, Point>> m_vertices; // by time stamp
  std::vector<Triangle> m_triangles;                     // sorted
};

/// The costs of the parts of a step.
Json parts(const DSC::Deformation_report<Complex>::Seconds& seconds) {
  return {{"extension", seconds.extension},
          {"motion", seconds.motion},
          {"relabeling", seconds.relabeling},
          {"obstacles", seconds.obstacles},
          {"improvement", seconds.improvement},
          {"small angles", seconds.small_angles},
          {"rest", seconds.rest}};
}

/// The results of all steps of a run, and their sums.
class Steps
{
public:
  /// Called before the first motion; sweeps are measured on the initial complex.
  explicit Steps(const Complex& complex) : m_initial(complex), m_cells(m_initial.cells()) {}

  /// Takes one step and measures only the motion. The caller may add values to the result.
  template <class Flow> Json& take(Complex& complex, const Flow& flow, double dt = 1) {
    const double sweep = sweep_seconds(m_initial, m_cells);
    const double start = processor_seconds();
    const auto report = DSC::advect_interface(complex, flow, dt * double(m_steps.size()), dt);
    const double seconds = processor_seconds() - start;
    m_steps.push_back({{"seconds", seconds},
                       {"sweep_milliseconds", 1000 * sweep},
                       {"sweeps", seconds / sweep},
                       {"incomplete", report.complete ? 0 : 1},
                       {"unfinished_vertices", report.unfinished.size()},
                       {"passes", report.passes},
                       {"split", report.split},
                       {"collapsed", report.collapsed},
                       {"flipped", report.flipped},
                       {"smoothed", report.smoothed},
                       {"relabeled", report.relabeled},
                       {"tetrahedra", complex.number_of_cells()},
                       {"parts", parts(report.seconds)}});
    return m_steps.back();
  }

  double sum(const char* key) const {
    double result = 0;
    for (const Json& step : m_steps)
      result += step[key].get<double>();
    return result;
  }
  std::size_t count(const char* key) const { return std::size_t(sum(key)); }
  double mean(const char* key) const { return sum(key) / double(m_steps.size()); }
  double maximum(const char* key) const {
    double result = 0;
    for (const Json& step : m_steps)
      result = (std::max)(result, step[key].get<double>());
    return result;
  }

  const Json& json() const { return m_steps; }

private:
  Complex m_initial;
  std::vector<Complex::Cell_handle> m_cells;
  Json m_steps = Json::array();
};

/// Halves the edge lengths; TetGen takes long for large surfaces.
void refine(Complex& complex) {
  static constexpr double longest = 4. / 3; // target length: half of the present length
  const double edge = complex.mean_interface_edge() / 2;
  DSC::improve_interface(complex, parameters::sizing_field([edge](const Point&) {
                                    return edge;
                                  }).interface_split_length(longest));
  DSC::improve_mesh(complex);
}

/// Two degrees in each step, about the z axis through the center of the box.
Json rotate(Complex& complex, Steps& steps, int number_of_steps) {
  const CGAL::Bbox_3 box = bounding_box(complex);
  const Initial_interface initial(complex);
  const DSC::Rigid_rotation_3 rotation(centre(box), Vector(0, 0, 1), 2 * degree);
  for (int i = 0; i < number_of_steps; ++i)
    steps.take(complex, rotation);

  const std::vector<double> distances = initial.distances(complex);
  const double largest =
      distances.empty() ? 0 : *std::max_element(distances.begin(), distances.end());
  return {{"valid", check(complex)},
          {"incomplete_steps", steps.count("incomplete")},
          {"largest_distance", largest / (box.xmax() - box.xmin())},
          {"vanished_vertices", initial.number_of_vertices() - distances.size()},
          {"unchanged_triangles", initial.unchanged_triangles(complex)}};
}

/// Returns the volume of all solids, in the units of the input.
double volume(const Complex& complex) {
  double sum = 0;
  for (const int label : complex.labels())
    sum += label == 0 ? 0 : complex.volume(label);
  return sum * std::pow(complex.normalization().scale, 3);
}

/// Outwards and back, a quarter of a mean edge in each step.
Json offset(Complex& complex, Steps& steps, int number_of_steps) {
  const double distance = .25 * complex.mean_interface_edge();
  Json volumes = Json::array({volume(complex)});
  Json components = Json::array({complex.number_of_components(1)});
  for (double speed : {distance, -distance}) {
    for (int i = 0; i < number_of_steps; ++i) {
      Json& step = steps.take(complex, DSC::Normal_offset{speed});
      step["invalid"] = check(complex) ? 0 : 1;
      step["angles_outside_6_171"] = dihedral_angles(complex).fraction_outside_6_171();
      step["volume"] = volume(complex);
    }
    volumes.push_back(volume(complex));
    components.push_back(complex.number_of_components(1));
  }
  return {{"valid", steps.count("invalid") == 0},
          {"incomplete_steps", steps.count("incomplete")},
          {"unfinished_vertices", steps.count("unfinished_vertices")},
          {"unfinished_vertices_maximum", std::size_t(steps.maximum("unfinished_vertices"))},
          {"angles_outside_6_171", steps.maximum("angles_outside_6_171")},
          {"volumes", volumes},
          {"components", components}};
}

/// A velocity that vanishes outside a ball around a point.
struct Local_push
{
  Point center;
  double radius;
  Vector velocity;

  Vector operator()(const Point& p, double) const {
    const double part = (p - center).squared_length() / (radius * radius);
    return part < 1 ? (1 - part) * (1 - part) * velocity : Vector(0, 0, 0);
  }
};

/// Moves a part of the interface outwards by a quarter of its mean edge in each step, and back.
Json push(Complex& complex, Steps& steps, int number_of_steps, double part) {
  const std::vector<Complex::Vertex_handle> vertices = complex.interface_vertices();
  const auto is_lower = [&](Complex::Vertex_handle v, Complex::Vertex_handle w) {
    return complex.position(v).z() < complex.position(w).z();
  };
  const Point top = complex.position(*std::max_element(vertices.begin(), vertices.end(), is_lower));
  std::vector<double> squared_distances;
  for (const Complex::Vertex_handle v : vertices)
    squared_distances.push_back((complex.position(v) - top).squared_length());
  std::sort(squared_distances.begin(), squared_distances.end());
  const double radius = std::sqrt(squared_distances[std::size_t(part * double(vertices.size()))]);
  const double distance = part > 0 ? .25 * complex.mean_interface_edge() : 0;
  bool is_valid = true;
  for (double way : {distance, -distance})
    for (int i = 0; i < number_of_steps; ++i) {
      steps.take(complex, Local_push{top, radius, Vector(0, 0, way)});
      is_valid = is_valid && check(complex);
    }
  return {{"valid", is_valid}, {"incomplete_steps", steps.count("incomplete")}};
}

/// Some steps of a flow.
template <class Flow>
Json flow(Complex& complex, Steps& steps, int number_of_steps, const Flow& flow, double dt = 1) {
  bool is_valid = true;
  for (int i = 0; i < number_of_steps; ++i) {
    steps.take(complex, flow, dt);
    is_valid = is_valid && check(complex);
  }
  return {{"valid", is_valid}, {"incomplete_steps", steps.count("incomplete")}};
}

/// Runs a mode for this number of steps, or for its default number if the number is 0.
Json move(const std::string& mode, Complex& complex, Steps& steps, int number_of_steps) {
  static constexpr double small_part = .004; // fraction of the interface vertices
  const auto number = [&](int usual) { return number_of_steps > 0 ? number_of_steps : usual; };
  if (mode == "rotation") // a full rotation
    return rotate(complex, steps, number(180));
  if (mode == "offset") // five mean edges
    return offset(complex, steps, number(20));
  const double edge = complex.mean_interface_edge();
  if (mode == "inwards")
    return flow(complex, steps, number(20), DSC::Normal_offset{-edge / 4});
  if (mode == "curvature")
    return flow(complex, steps, number(20), DSC::Mean_curvature_flow(), edge * edge);
  if (mode == "slow_curvature")
    return flow(complex, steps, number(20), DSC::Mean_curvature_flow(), edge * edge / 6);
  return push(complex, steps, number(5), mode == "push" ? small_part : 0);
}

int run(const std::string& mode, const std::string& input, std::size_t triangles,
        int number_of_refinements, int number_of_steps, const std::string& json_path) {
  Complex complex = DSC::make_deformable_simplicial_complex_3<Complex>(
      {read_input(input, triangles)}, CGAL::Tetgen_tetrahedralizer_3(),
      parameters::normalize(true));
  for (int i = 0; i < number_of_refinements; ++i)
    refine(complex);
  complex.sort_storage();
  Json result = {{"mode", mode},
                 {"input", std::filesystem::path(input).stem().string()},
                 {"triangles", complex.interface_facets().size()}};
  result["tetrahedra"] = complex.number_of_cells();

  Steps steps(complex);
  const Json motion = move(mode, complex, steps, number_of_steps);
  result["sweep_milliseconds"] = steps.mean("sweep_milliseconds");
  result.update(motion);
  result["sweeps_mean"] = steps.mean("sweeps");
  result["sweeps_maximum"] = steps.maximum("sweeps");

  std::cout.precision(4);
  for (const auto& [key, value] : result.items())
    if (key != "mode") {
      std::cout << "| ";
      if (value.is_array())
        std::cout << value[0].get<double>() << " → " << value[1].get<double>() << " → "
                  << value[2].get<double>();
      else if (value.is_number_float())
        std::cout << value.get<double>();
      else
        std::cout << (value.is_string() ? value.get<std::string>() : value.dump());
      std::cout << ' ';
    }
  std::cout << '|' << std::endl;
  if (!json_path.empty()) {
    result["steps"] = steps.json();
    std::ofstream(json_path) << result.dump(2) << '\n';
  }
  return result["valid"] ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace
} // namespace dsc_benchmark

int main(int argc, char** argv) {
  CLI::App app("Rotates a surface by a whole turn, offsets it out and back, or inwards, shrinks it "
               "by its mean curvature, pushes a small part of it or moves nothing, and measures "
               "it.");
  std::string mode, input, json_path;
  std::size_t triangles = 0;
  int number_of_refinements = 0, number_of_steps = 0;
  app.add_option("mode", mode)
      ->required()
      ->check(CLI::IsMember(
          {"rotation", "offset", "inwards", "curvature", "slow_curvature", "push", "rest"}));
  app.add_option("mesh", input, "a file, sphere, or two_spheres")->required();
  app.add_option("--triangles", triangles, "to which a finer surface is decimated");
  app.add_option("--refine", number_of_refinements,
                 "how often edges become half as long before the motion")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--steps", number_of_steps, "how many, instead of as many as the table has")
      ->check(CLI::PositiveNumber);
  app.add_option("--json", json_path, "a file for the numbers of all steps");
  CLI11_PARSE(app, argc, argv);
  try {
    return dsc_benchmark::run(mode, input, triangles, number_of_refinements, number_of_steps,
                              json_path);
  } catch (const std::exception& error) {
    std::cerr << "motion_benchmark: " << input << ": " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
