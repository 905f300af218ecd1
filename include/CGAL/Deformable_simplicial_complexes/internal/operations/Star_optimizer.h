// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_OPERATIONS_STAR_OPTIMIZER_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_OPERATIONS_STAR_OPTIMIZER_H

#include <CGAL/Deformable_simplicial_complexes/internal/complex/apply_to_corners.h>
#include <CGAL/Mesh_support/coordinates.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The worst quality of a star as a function of the position of its vertex, which is maximized
// (Freitag, Jones and Plassmann 1995). It is a minimum of smooth functions. The direction of
// steepest ascent is the shortest convex combination of the gradients of the active functions.
template <class Complex, class Measure = typename Complex::Quality_measure> class Star_optimizer
{
public:
  using Point = typename Complex::Point;
  using Vector = typename Complex::Vector;

  // An empty star with its vertex at p.
  Star_optimizer(const Measure& measure, const Point& p) : m_measure(measure), m_position(p) {}

  // The star of v, with its finite cells.
  Star_optimizer(const Complex& complex, const Measure& measure, typename Complex::Vertex_handle v,
                 const std::vector<typename Complex::Cell_handle>& star)
      : Star_optimizer(measure, complex.position(v)) {
    for (auto c : star) {
      std::array<Point, Complex::corners> points;
      for (int i = 0; i < Complex::corners; ++i)
        points[i] = complex.position_near(m_position, c->vertex(i));
      if constexpr (std::is_same_v<Measure, typename Complex::Quality_measure>)
        add(points, c->index(v), c->quality());
      else
        add(points, c->index(v));
    }
  }

  // Forbids motion in a direction, given by a unit vector. Several directions must be orthogonal.
  void block(const Vector& direction) { m_blocked.push_back(direction); }

  // Adds a cell of the star. The corner `vertex` is the moving one.
  void add(const std::array<Point, Complex::corners>& points, int vertex) {
    add(points, vertex, 0);
    m_functions.back().value = value(m_functions.back(), m_position);
  }

  // Adds a cell of the star with known quality.
  void add(const std::array<Point, Complex::corners>& points, int vertex, double quality) {
    Function f;
    f.points = points;
    f.vertex = vertex;
    f.value = quality;
    m_functions.push_back(f);
    m_length = (std::max)(
        m_length,
        std::sqrt((points[(vertex + 1) % Complex::corners] - m_position).squared_length()));
  }

  // Returns a better position, or the current one if none is found.
  Point run() {
    static constexpr int maximum_number_of_steps = 8;
    for (int i = 0; i < maximum_number_of_steps && step(); ++i) {
    }
    return m_position;
  }

private:
  struct Function
  {
    std::array<Point, Complex::corners> points;
    int vertex;
    double value, next_value; // at the current position, and at the tried one
    Vector gradient;
  };

  using Corner_sequence = std::make_integer_sequence<int, Complex::corners>;

  template <class M, int... i>
  static auto gradient_by_first(const M& measure, const std::array<Point, Complex::corners>& points,
                                std::integer_sequence<int, i...>)
      -> decltype(measure.gradient(points[i]...)) {
    return measure.gradient(points[i]...);
  }

  double value(Function& f, const Point& p) const {
    f.points[f.vertex] = p;
    return apply_to_corners<Complex::corners>(m_measure,
                                              [&](int i) -> const Point& { return f.points[i]; });
  }

  // Returns whether all functions are above a bound at p. The function that failed last time is
  // tested first.
  bool are_above(double bound, const Point& p) {
    const auto is_above = [&](Function& f) { return (f.next_value = value(f, p)) > bound; };
    if (!is_above(m_functions[m_suspect]))
      return false;
    for (std::size_t i = 0; i < m_functions.size(); ++i)
      if (i != m_suspect && !is_above(m_functions[i])) {
        m_suspect = i;
        return false;
      }
    return true;
  }

  void differentiate(Function& f) const {
    f.points[f.vertex] = m_position;
    f.gradient = gradient_of(m_measure, f, 0);
    for (const Vector& direction : m_blocked)
      f.gradient = f.gradient - (f.gradient * direction) * direction;
  }

  // Returns the gradient for a measure that provides its gradient with respect to the first corner:
  // the moving corner is passed first.
  template <class M>
  auto gradient_of(const M& measure, const Function& f, int) const
      -> decltype(gradient_by_first(measure, f.points, Corner_sequence())) {
    std::array<Point, Complex::corners> points;
    for (int i = 0; i < Complex::corners; ++i)
      points[i] = f.points[Complex::Space::even_permutation[f.vertex][i]];
    return gradient_by_first(measure, points, Corner_sequence());
  }

  // Returns the gradient for any other measure, by differences.
  template <class M> Vector gradient_of(const M&, const Function& f, long) const {
    static constexpr double part = 1e-6; // of the longest edge
    const double h = part * m_length;
    Function g = f;
    std::array<double, Complex::dimension> slopes;
    for (int axis = 0; axis < Complex::dimension; ++axis) {
      std::array<double, Complex::dimension> step = {};
      step[axis] = h;
      slopes[axis] = (value(g, m_position + vector_of<Complex>(step)) - f.value) / h;
    }
    return vector_of<Complex>(slopes);
  }

  // Returns the point of the convex hull of the active gradients that is nearest to the origin
  // (Gilbert's algorithm).
  Vector steepest_ascent(double bound) const {
    static constexpr int maximum_number_of_iterations = 30;
    static constexpr double tolerance = 1e-2;
    const auto extreme = [&](const Vector& d) {
      const Function* least = nullptr;
      for (const Function& f : m_functions)
        if (f.value <= bound && (!least || f.gradient * d < least->gradient * d))
          least = &f;
      return least->gradient;
    };
    Vector d =
        std::min_element(m_functions.begin(), m_functions.end(),
                         [](const Function& a, const Function& b) { return a.value < b.value; })
            ->gradient;
    for (int i = 0; i < maximum_number_of_iterations; ++i) {
      const Vector g = extreme(d), side = d - g;
      if (d * side <= tolerance * d.squared_length())
        break;
      d = d - (std::min)(1., d * side / side.squared_length()) * side;
    }
    return d;
  }

  // Does one step of steepest ascent with a line search. Returns whether the improvement was
  // sufficient to continue.
  bool step() {
    static constexpr double close = .05;          // relative to the worst value: also active
    static constexpr double flat = 1e-3;          // slope times the longest edge; below, no step
    static constexpr double longest_step = .5;    // of the longest edge
    static constexpr double shortest_part = 1e-3; // of the longest step
    static constexpr double worth = .02;          // least relative gain of a step
    static constexpr int maximum_number_of_halvings = 6;
    double before = std::numeric_limits<double>::infinity();
    for (const Function& f : m_functions)
      before = (std::min)(before, f.value);
    if (!std::isfinite(before)) // the measure is not finite
      return false;
    // Functions far above the worst value cannot become the worst one in this step. The worst value
    // may be zero or negative because of rounding.
    const double relevant = before + std::abs(before), active = before + close * std::abs(before);
    for (Function& f : m_functions)
      if (f.value <= relevant)
        differentiate(f);
    const Vector d = steepest_ascent(active);
    const double rate = d.squared_length();
    if (!(std::sqrt(rate) * m_length > flat))
      return false;
    // Limits the step length to where another function becomes the worst one, by linear prediction.
    double step_length = longest_step * m_length / std::sqrt(rate);
    for (const Function& f : m_functions) {
      if (!(f.value <= relevant))
        continue;
      const double slope = f.gradient * d;
      if (slope < rate && f.value > before)
        step_length = (std::min)(step_length, (std::max)(shortest_part * step_length,
                                                         (f.value - before) / (rate - slope)));
    }
    for (int halvings = 0; halvings < maximum_number_of_halvings; ++halvings, step_length /= 2) {
      const Point p = m_position + step_length * d;
      if (are_above(before, p)) {
        m_position = p;
        double after = std::numeric_limits<double>::infinity();
        for (Function& f : m_functions) {
          f.value = f.next_value;
          after = (std::min)(after, f.value);
        }
        return after > before + worth * std::abs(before);
      }
    }
    return false;
  }

  static constexpr std::size_t usual_size = 32; // usual maximum number of cells of a star

  const Measure& m_measure;
  Point m_position;
  std::vector<Vector> m_blocked;
  boost::container::small_vector<Function, usual_size> m_functions;
  double m_length = 0;
  std::size_t m_suspect = 0;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_OPERATIONS_STAR_OPTIMIZER_H
