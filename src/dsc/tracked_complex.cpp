// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "errors.h"
#include "labelled_tetrahedra.h"
#include "tracked_complex_implementation.h"

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3/exceptions.h>
#include <CGAL/IO/MEDIT_3.h>
#include <CGAL/IO/VTU_3.h>
#include <CGAL/IO/checkpoint_3.h>
#include <CGAL/IO/labelled_surface_3.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>
#include <CGAL/improve_mesh_3.h>
#include <CGAL/make_deformable_simplicial_complex_3.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace dsc {
namespace {

using Complex = CGAL::Deformable_simplicial_complex_3<>;
// At rest, angles count.
using Complex_at_rest =
    CGAL::Deformable_simplicial_complex_3<CGAL::Deformable_simplicial_complex_traits_3<>,
                                          CGAL::Default, CGAL::Biased_minimum_sine_3>;
using Point = Complex::Approximate_point_3;
using Vector = Complex::Approximate_vector_3;
using CGAL::Deformable_simplicial_complexes::Invalid_surface_error;
using CGAL::Deformable_simplicial_complexes::Invalid_tetrahedra_error;
namespace parameters = CGAL::Deformable_simplicial_complexes::parameters;

constexpr double degree = CGAL_PI / 180;

std::array<Point, 4> corners(const Complex& complex, Complex::Cell_handle c) {
  return {complex.position(c->vertex(0)), complex.position(c->vertex(1)),
          complex.position(c->vertex(2)), complex.position(c->vertex(3))};
}

/// The six dihedral angles in degrees, from the normals of the facets: finite for any corners.
std::array<double, 6> dihedral_angles(const std::array<Point, 4>& p) {
  const auto normal = [&](int i, int j, int k) {
    return CGAL::cross_product(p[j] - p[i], p[k] - p[i]);
  };
  const std::array<Vector, 4> n = {normal(1, 3, 2), normal(0, 2, 3), normal(0, 3, 1),
                                   normal(0, 1, 2)};
  std::array<double, 6> angles;
  auto angle = angles.begin();
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) {
      const double sine = std::sqrt(CGAL::cross_product(n[i], n[j]).squared_length());
      *angle++ = std::atan2(sine, -(n[i] * n[j])) / degree;
    }
  return angles;
}

void add_dihedral_angles(const Complex& complex, Statistics& statistics) {
  statistics.min_dihedral = 180;
  statistics.max_dihedral = 0;
  std::size_t outside = 0;
  for (const Complex::Cell_handle c : complex.triangulation().finite_cell_handles())
    for (const double angle : dihedral_angles(corners(complex, c))) {
      statistics.min_dihedral = std::min(statistics.min_dihedral, angle);
      statistics.max_dihedral = std::max(statistics.max_dihedral, angle);
      ++statistics
            .dihedral_histogram[std::min<std::size_t>(17, static_cast<std::size_t>(angle / 10))];
      outside += angle < 6 || angle > 171;
    }
  statistics.dihedrals_outside_6_171 =
      static_cast<double>(outside) / (6 * static_cast<double>(complex.number_of_cells()));
}

} // namespace

Tracked_complex::Tracked_complex(std::unique_ptr<Implementation> implementation)
    : m_implementation(std::move(implementation)) {}

Tracked_complex::Tracked_complex(Tracked_complex&&) = default;

Tracked_complex::~Tracked_complex() = default;

Tracked_complex Tracked_complex::from_surfaces(const std::vector<Surface>& surfaces,
                                               const std::vector<std::string>& names,
                                               const std::optional<std::array<double, 6>>& domain) {
  const auto build = [&](const auto& np) {
    return Tracked_complex(std::make_unique<Implementation>(
        Implementation{CGAL::make_deformable_simplicial_complex_3<Complex>(
            surfaces, CGAL::Tetgen_tetrahedralizer_3(), np)}));
  };
  try {
    const auto normalized = parameters::normalize(true);
    if (!domain)
      return build(normalized);
    const auto& [x0, y0, z0, x1, y1, z1] = *domain;
    return build(normalized.enclosing_box(CGAL::Bbox_3(x0, y0, z0, x1, y1, z1)));
  } catch (const Invalid_surface_error& error) {
    std::string message = names[error.surface()];
    if (error.other_surface() != error.surface())
      message += " and " + names[error.other_surface()];
    throw Input_error(message + ": " + error.what());
  }
}

Tracked_complex Tracked_complex::from_mesh(const std::string& path) {
  const Labelled_tetrahedra mesh = read_tetrahedra(path);
  try {
    return Tracked_complex(std::make_unique<Implementation>(
        Implementation{CGAL::make_deformable_simplicial_complex_3<Complex>(
            mesh.points, mesh.tetrahedra, mesh.labels, parameters::improve(false))}));
  } catch (const Invalid_tetrahedra_error& error) {
    throw Input_error(path + ": " + error.what() + place_of(error, mesh));
  }
}

Tracked_complex Tracked_complex::from_checkpoint(const std::string& path, std::string& metadata) {
  CGAL::IO::Checkpoint_3 checkpoint = CGAL::IO::read_checkpoint(path);
  auto implementation = std::make_unique<Implementation>();
  try {
    implementation->complex.restore(checkpoint.state);
  } catch (const Invalid_tetrahedra_error& error) {
    throw Input_error(path + ": " + error.what());
  }
  metadata = std::move(checkpoint.metadata);
  return Tracked_complex(std::move(implementation));
}

Improvement_outcome Tracked_complex::improve(const Improve_options& options) {
  const auto aggressive = parameters::aggressive(options.aggressive);
  const auto start = Clock::now();
  Complex_at_rest complex;
  complex.restore(m_implementation->complex.state());
  const auto report =
      options.threshold
          ? CGAL::improve_mesh(complex, aggressive.quality_threshold(*options.threshold))
          : CGAL::improve_mesh(complex, aggressive);
  auto state = complex.state();
  // What was tried in vain was measured otherwise.
  std::fill(state.failures.begin(), state.failures.end(), std::uint8_t(0));
  m_implementation->complex.restore(state);
  return {seconds_since(start), report};
}

Tracked_complex::State Tracked_complex::state() const { return m_implementation->complex.state(); }

void Tracked_complex::restore(const State& state) {
  m_implementation->complex.clear(); // as memory may be short
  m_implementation->complex.restore(state);
}

Statistics Tracked_complex::statistics() const {
  const Complex& complex = m_implementation->complex;
  const double scale = complex.normalization().scale;
  Statistics statistics = {};
  statistics.vertices = complex.number_of_vertices();
  statistics.tetrahedra = complex.number_of_cells();
  statistics.interface_triangles = complex.interface_facets().size();
  for (const auto& [label, area, euler_characteristic] : complex.label_interfaces())
    statistics.labels.push_back(
        {label, complex.number_of_cells(label), complex.volume(label) * scale * scale * scale,
         area * scale * scale, complex.number_of_components(label), euler_characteristic});
  add_dihedral_angles(complex, statistics);
  statistics.min_quality = 1;
  for (const Complex::Cell_handle c : complex.triangulation().finite_cell_handles())
    statistics.min_quality = std::min(statistics.min_quality, complex.quality(c));
  return statistics;
}

double Tracked_complex::sweep_seconds() const {
  const Complex& complex = m_implementation->complex;
  const std::vector<Complex::Cell_handle> cells = complex.cells();
  std::array<double, 9> seconds;
  [[maybe_unused]] volatile double sum; // so that no pass can be optimized away
  for (double& s : seconds) {
    double total = 0;
    const auto start = Clock::now();
    for (const Complex::Cell_handle c : cells) {
      const auto& point = [c](int i) -> const Complex::Point_3& { return c->vertex(i)->point(); };
      const std::array<Point, 4> p = corners(complex, c);
      total += CGAL::orientation(point(0), point(1), point(2), point(3)) +
               complex.quality_measure()(p[0], p[1], p[2], p[3]);
    }
    s = seconds_since(start);
    sum = total;
  }
  std::nth_element(seconds.begin(), seconds.begin() + seconds.size() / 2, seconds.end());
  // A clock may be too coarse for a few tetrahedra, but nothing is ever divided by zero.
  return std::max(seconds[seconds.size() / 2], 1e-9);
}

std::vector<Surface_point> Tracked_complex::interface_points() const {
  const Complex& complex = m_implementation->complex;
  std::vector<Surface_point> points;
  for (const Complex::Vertex_handle v : complex.interface_vertices()) {
    const Point p = complex.user_position(v);
    points.emplace_back(p.x(), p.y(), p.z());
  }
  return points;
}

void Tracked_complex::write_interface(const std::string& path) const {
  CGAL::IO::write_interface(path, m_implementation->complex);
}

void Tracked_complex::write_interface_vtu(const std::string& path) const {
  CGAL::IO::write_interface_VTU(path, m_implementation->complex);
}

void Tracked_complex::write_volume_vtu(const std::string& path) const {
  CGAL::IO::write_VTU(path, m_implementation->complex);
}

void Tracked_complex::write_mesh(const std::string& path) const {
  CGAL::IO::write_MEDIT(path, m_implementation->complex);
}

void Tracked_complex::write_checkpoint(const std::string& path, const std::string& metadata) const {
  CGAL::IO::write_checkpoint(path, m_implementation->complex.state(), metadata);
}

} // namespace dsc
