// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Segments a volume by segment_image(), and by thresholds, majority filters and Mesh_3 of CGAL.
// Prints the energies of both meshes. Usage: segmentation [IMAGE.inr PHASES]; by default, two balls
// with noise

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Image_segmentation/segment_image.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Image_3.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <random>
#include <stdexcept>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace {

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Image = DSC::Gray_image<3>;
using Corners = std::array<std::array<double, 3>, 4>; // in voxels

Image read(const char* path) {
  CGAL::Image_3 file;
  if (!file.read(path))
    throw std::runtime_error("cannot read the image");
  Image result;
  result.grid = {{file.xdim(), file.ydim(), file.zdim()},
                 {file.vx(), file.vy(), file.vz()},
                 {file.tx(), file.ty(), file.tz()}};
  result.channels.resize(1);
  for (std::size_t z = 0; z < file.zdim(); ++z)
    for (std::size_t y = 0; y < file.ydim(); ++y)
      for (std::size_t x = 0; x < file.xdim(); ++x)
        result.channels[0].push_back(file.value(x, y, z));
  return result;
}

Image balls() {
  Image result = {{{40, 30, 30}, {1, 1, 1}, {0, 0, 0}}, {{}}, {}};
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, .2);
  for (int z = 0; z < 30; ++z)
    for (int y = 0; y < 30; ++y)
      for (int x = 0; x < 40; ++x)
        result.channels[0].push_back(float((std::hypot(x - 13, std::hypot(y - 14, z - 15)) < 9 ||
                                            std::hypot(x - 30, std::hypot(y - 14, z - 15)) < 6) +
                                           noise(random)));
  return result;
}

/// The costs of labeled cells and the area between labels, in units of the noise and in voxels.
class Energy
{
public:
  Energy(const DSC::Image_moments<3>& moments, std::size_t phases)
      : m_moments(moments), m_sums(phases, std::vector<double>(moments.number_of_fields(), 0.)) {}

  void add_cell(const Corners& corners, int label) {
    m_moments.add(corners, m_sums[std::size_t(label)].data());
  }
  void add_facet(double area) { m_area += area; }

  double area() const { return m_area; }
  /// Returns the sum of the squared deviations from the means of the phases.
  double deviations() const {
    double result = 0;
    for (const auto& sums : m_sums)
      if (sums[0] > 0)
        result += sums[1] - sums[2] * sums[2] / sums[0];
    return result;
  }

private:
  const DSC::Image_moments<3>& m_moments;
  std::vector<std::vector<double>> m_sums;
  double m_area = 0;
};

/// Replaces labels by the most frequent one of the 27 voxels around.
std::vector<std::uint8_t> majority(const std::vector<std::uint8_t>& labels,
                                   const std::array<std::size_t, 3>& size) {
  std::vector<std::uint8_t> result(labels);
  const auto last = [&](int axis) { return std::ptrdiff_t(size[axis]) - 1; };
  for (std::ptrdiff_t z = 0; z <= last(2); ++z)
    for (std::ptrdiff_t y = 0; y <= last(1); ++y)
      for (std::ptrdiff_t x = 0; x <= last(0); ++x) {
        std::array<int, 256> counts = {};
        const auto at = [&](std::ptrdiff_t i, std::ptrdiff_t j, std::ptrdiff_t k) {
          return std::size_t((k * std::ptrdiff_t(size[1]) + j) * std::ptrdiff_t(size[0]) + i);
        };
        for (std::ptrdiff_t k = (std::max)(z - 1, std::ptrdiff_t(0));
             k <= (std::min)(z + 1, last(2)); ++k)
          for (std::ptrdiff_t j = (std::max)(y - 1, std::ptrdiff_t(0));
               j <= (std::min)(y + 1, last(1)); ++j)
            for (std::ptrdiff_t i = (std::max)(x - 1, std::ptrdiff_t(0));
                 i <= (std::min)(x + 1, last(0)); ++i)
              ++counts[labels[at(i, j, k)]];
        result[at(x, y, z)] =
            std::uint8_t(std::max_element(counts.begin(), counts.end()) - counts.begin());
      }
  return result;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void print(const char* method, const Energy& energy, double smoothing, std::size_t cells,
           double seconds) {
  std::printf("| %s | %.0f | %.0f | %.0f | %zu | %.2f |\n", method, energy.deviations(),
              energy.area(), energy.deviations() + smoothing * energy.area(), cells, seconds);
}

/// Meshes voxels with labels that are nearest to the values.
void mesh_thresholds(const Image& image, const DSC::Image_phases& phases, double smoothing,
                     const DSC::Image_moments<3>& moments, double edge) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Domain = CGAL::Labeled_mesh_domain_3<Kernel>;
  using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
  using Mesh = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
  using Criteria = CGAL::Mesh_criteria_3<Triangulation>;
  namespace params = CGAL::parameters;
  static constexpr int filters = 6;
  const auto start = std::chrono::steady_clock::now();
  const auto& size = image.grid.size;
  std::vector<std::uint8_t> labels;
  for (const float value : image.channels[0])
    labels.push_back(std::uint8_t(DSC::internal::nearest_of(phases.intensities, {double(value)})));
  for (int i = 0; i < filters; ++i)
    labels = majority(labels, size);
  // Label 0 would be outside the domain.
  _image* voxels = _createImage(size[0], size[1], size[2], 1, 1, 1, 1, 1, WK_FIXED, SGN_UNSIGNED);
  for (std::size_t i = 0; i < labels.size(); ++i)
    static_cast<std::uint8_t*>(voxels->data)[i] = std::uint8_t(labels[i] + 1);
  const CGAL::Image_3 labeled(voxels);
  const Domain domain = Domain::create_labeled_image_mesh_domain(labeled);
  const Criteria criteria(params::facet_angle = 25, params::facet_size = edge,
                          params::facet_distance = .5, params::cell_radius_edge_ratio = 3,
                          params::cell_size = 4 * edge);
  const Mesh mesh = CGAL::make_mesh_3<Mesh>(domain, criteria);
  const double seconds = seconds_since(start);
  Energy energy(moments, phases.intensities.size());
  // Voxels of Mesh_3 are centered at integers.
  for (auto c = mesh.cells_in_complex_begin(); c != mesh.cells_in_complex_end(); ++c) {
    Corners corners;
    for (std::size_t i = 0; i < 4; ++i)
      for (int axis = 0; axis < 3; ++axis)
        corners[i][std::size_t(axis)] = c->vertex(int(i))->point()[axis] + .5;
    energy.add_cell(corners, int(mesh.subdomain_index(c)) - 1);
  }
  for (auto f = mesh.facets_in_complex_begin(); f != mesh.facets_in_complex_end(); ++f)
    if (const auto g = mesh.triangulation().mirror_facet(*f);
        mesh.is_in_complex(f->first) && mesh.is_in_complex(g.first))
      energy.add_facet(std::sqrt(mesh.triangulation().triangle(*f).squared_area()));
  print("thresholds, 6 majority filters, Mesh_3", energy, smoothing,
        mesh.number_of_cells_in_complex(), seconds);
}

} // namespace

int main(int argc, char** argv) {
  try {
    Image image = argc > 2 ? read(argv[1]) : balls();
    DSC::Segmentation_options<3> options;
    options.phases = argc > 2 ? unsigned(std::atoi(argv[2])) : 2;
    const auto start = std::chrono::steady_clock::now();
    const auto [complex, report] = DSC::segment_image<Complex>(image, options);
    const double seconds = seconds_since(start);
    const DSC::Image_phases phases = DSC::estimate_phases(image, options.phases);
    Image scaled = image;
    for (float& value : scaled.channels[0])
      value = float(double(value) / phases.noise[0]);
    const DSC::Image_moments<3> moments(scaled);
    std::printf("| method | deviations | area | energy | cells | seconds |\n"
                "| --- | ---: | ---: | ---: | ---: | ---: |\n");
    Energy energy(moments, phases.intensities.size());
    for (const auto c : complex.cells()) {
      Corners corners;
      for (int i = 0; i < 4; ++i)
        corners[std::size_t(i)] = moments.place(complex.user_position(c->vertex(i)));
      energy.add_cell(corners, complex.label(c));
    }
    for (const auto& facet : complex.interface_facets())
      energy.add_facet(complex.measure(facet));
    print("segment_image()", energy, report.smoothing, complex.number_of_cells(), seconds);
    mesh_thresholds(image, phases, report.smoothing, moments, options.shortest_edge);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "segmentation: %s\n", error.what());
    return 1;
  }
}
