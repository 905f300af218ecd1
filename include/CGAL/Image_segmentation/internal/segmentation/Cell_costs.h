// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_IMAGE_SEGMENTATION_INTERNAL_SEGMENTATION_CELL_COSTS_H
#define CGAL_IMAGE_SEGMENTATION_INTERNAL_SEGMENTATION_CELL_COSTS_H

#include <CGAL/Image_segmentation/Image_moments.h>
#include <CGAL/Image_segmentation/estimate_phases.h>
#include <CGAL/Mesh_support/For_each_index.h>

#include <map>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// Intensities of phases, and the costs of cells: the integral over a cell of the squared deviation
// of the image from the intensity of a phase. The moments of a cell are computed again if it has
// moved.
template <class Complex> class Cell_costs
{
public:
  static constexpr int d = Complex::dimension;
  using Cell_handle = typename Complex::Cell_handle;
  using Intensities = std::vector<std::vector<double>>; // for each phase, of each channel

  Cell_costs(const Complex& complex, const Gray_image<d>& image, Intensities intensities)
      : m_complex(complex), m_moments(image), m_fields(m_moments.number_of_fields()) {
    set_intensities(std::move(intensities));
  }

  const Image_moments<d>& moments() const { return m_moments; }
  const Intensities& intensities() const { return m_intensities; }
  std::size_t channels() const { return m_fields - 2; }

  // Returns the length of a unit of the complex in sides of pixels.
  double pixels_in_unit() const {
    return m_complex.normalization().scale / m_moments.image().side();
  }

  // Computes the moments of all cells that have changed.
  void update(const For_each_index& for_each_index) {
    reserve();
    const auto cells = m_complex.finite_cells_if([](Cell_handle) { return true; }, for_each_index);
    for_each_index(cells.size(), [&](std::size_t i) { update(cells[i]); });
  }

  // Returns the moments of a cell: the number of pixels, the integral of the squares, and the
  // integral of each channel. The pointer is valid until the mesh changes.
  const double* fields(Cell_handle c) {
    if (c->id() >= m_corners.size())
      reserve();
    update(c);
    return m_values.data() + c->id() * m_fields;
  }

  // Returns the cost of a cell with the label of a phase.
  double operator()(Cell_handle c, int label) {
    const double* moments = fields(c);
    const std::vector<double>& intensity = m_intensities[std::size_t(label)];
    double result = moments[1] + m_squares[std::size_t(label)] * moments[0];
    for (std::size_t k = 0; k < intensity.size(); ++k)
      result -= 2 * intensity[k] * moments[k + 2];
    return result;
  }

  // Returns the squared deviation of a pixel from a phase.
  double of_pixel(std::size_t pixel, int label) const {
    const std::vector<double>& intensity = m_intensities[std::size_t(label)];
    double result = 0;
    for (std::size_t k = 0; k < intensity.size(); ++k) {
      const double difference = double(m_moments.image().channels[k][pixel]) - intensity[k];
      result += difference * difference;
    }
    return result;
  }

  // Returns the squared distance of the intensities of two phases.
  double squared_contrast(int a, int b) const {
    return squared_distance_of(m_intensities[std::size_t(a)], m_intensities[std::size_t(b)]);
  }

  // Returns the smallest squared distance of two phases; 1 if all intensities are equal.
  double least_squared_contrast() const {
    double result = std::numeric_limits<double>::infinity();
    for (std::size_t a = 0; a < m_intensities.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        if (const double squared = squared_contrast(int(a), int(b)); squared > 0)
          result = (std::min)(result, squared);
    return std::isfinite(result) ? result : 1;
  }

  // Sets each intensity to the mean of the image in the phase. Phases without pixels keep theirs.
  void measure_intensities() {
    std::map<int, std::vector<double>> sums;
    for (const Cell_handle c : m_complex.cells()) {
      const double* moments = fields(c);
      auto& sum = sums.try_emplace(m_complex.label(c), m_fields, 0.).first->second;
      for (std::size_t f = 0; f < m_fields; ++f)
        sum[f] += moments[f];
    }
    Intensities result = m_intensities;
    for (const auto& [label, sum] : sums)
      if (sum[0] > 0)
        for (std::size_t k = 0; k < channels(); ++k)
          result[std::size_t(label)][k] = sum[k + 2] / sum[0];
    set_intensities(std::move(result));
  }

  // Returns the mean cost of a pixel in each phase: the weighted median over its cells, because
  // cells across boundaries cost more. The results are at least the cost of the noise.
  std::vector<double> usual_costs() {
    std::vector<std::vector<std::pair<double, double>>> costs(m_intensities.size());
    for (const Cell_handle c : m_complex.cells())
      if (const double pixels = fields(c)[0]; pixels > 0)
        costs[std::size_t(c->subdomain_index())].emplace_back(
            (*this)(c, c->subdomain_index()) / pixels, pixels);
    std::vector<double> result(m_intensities.size(), double(channels()));
    for (std::size_t label = 0; label < costs.size(); ++label) {
      std::sort(costs[label].begin(), costs[label].end());
      double half = 0;
      for (const auto& [cost, pixels] : costs[label])
        half += pixels / 2;
      for (const auto& [cost, pixels] : costs[label]) {
        half -= pixels;
        if (half <= 0) {
          result[label] = (std::max)(result[label], cost);
          break;
        }
      }
    }
    return result;
  }

  // Returns the number of pixels with values in all cells.
  double pixels() {
    double result = 0;
    for (const Cell_handle c : m_complex.cells())
      result += fields(c)[0];
    return result;
  }

  // Returns the sum of the costs of all cells.
  double total() {
    double result = 0;
    for (const Cell_handle c : m_complex.cells())
      result += (*this)(c, c->subdomain_index());
    return result;
  }

private:
  using Corners = std::array<std::array<double, d>, d + 1>;

  void set_intensities(Intensities intensities) {
    m_intensities = std::move(intensities);
    m_squares.clear();
    for (const auto& intensity : m_intensities) {
      double sum = 0;
      for (const double x : intensity)
        sum += x * x;
      m_squares.push_back(sum);
    }
  }

  void reserve() {
    const Corners none = {}; // corners of no cell
    m_corners.resize(m_complex.cell_id_bound(), none);
    m_values.resize(m_corners.size() * m_fields);
  }

  void update(Cell_handle c) {
    Corners corners;
    for (int i = 0; i <= d; ++i)
      corners[i] = m_moments.place(m_complex.user_position(c->vertex(i)));
    if (corners == m_corners[c->id()])
      return;
    m_corners[c->id()] = corners;
    double* values = m_values.data() + c->id() * m_fields;
    std::fill(values, values + m_fields, 0.);
    m_moments.add(corners, values);
  }

  const Complex& m_complex;
  Image_moments<d> m_moments;
  std::size_t m_fields;
  Intensities m_intensities;
  std::vector<double> m_squares;  // of the intensities
  std::vector<Corners> m_corners; // by ids of cells, when the moments were computed
  std::vector<double> m_values;   // the moments
};

} // namespace internal

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_IMAGE_SEGMENTATION_INTERNAL_SEGMENTATION_CELL_COSTS_H
