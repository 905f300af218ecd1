// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_VERTEX_OPTIMIZATION_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_VERTEX_OPTIMIZATION_3_H

#include <CGAL/Deformable_simplicial_complex_3/vertex_smoothing_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {

namespace Deformable_simplicial_complexes {
namespace internal {

// The worst quality of a star as a function of the position of its vertex, to be maximised
// (Freitag, Jones and Plassmann 1995): a minimum of smooth functions, whose steepest ascent is the
// shortest convex combination of the gradients of those that are active.
template <class Complex> class Star_optimizer_3
{
public:
  using Point = typename Complex::Approximate_point_3;
  using Vector = typename Complex::Approximate_vector_3;
  using Vertex_handle = typename Complex::Vertex_handle;
  using Star = std::vector<typename Complex::Cell_handle>;

  Star_optimizer_3(const Complex& complex, Vertex_handle v, const Star& star)
      : m_complex(complex), m_position(complex.position(v)) {
    for (auto c : star) {
      Function f;
      f.vertex = c->index(v);
      for (int i = 0; i < 4; ++i)
        f.points[i] = complex.position(c->vertex(i));
      m_functions.push_back(f);
      m_length = (std::max)(
          m_length, std::sqrt((f.points[(f.vertex + 1) % 4] - m_position).squared_length()));
    }
  }

  // A better position, or the present one.
  Point run() {
    static constexpr int maximum_number_of_steps = 8;
    for (int i = 0; i < maximum_number_of_steps && step(); ++i) {
    }
    return m_position;
  }

private:
  struct Function
  {
    std::array<Point, 4> points;
    int vertex;
    double value;
    Vector gradient;
  };

  double value(Function& f, const Point& p) const {
    f.points[f.vertex] = p;
    return m_complex.quality_measure()(f.points[0], f.points[1], f.points[2], f.points[3]);
  }

  double worst(const Point& p, double bound) {
    double result = std::numeric_limits<double>::infinity();
    for (Function& f : m_functions) {
      result = (std::min)(result, value(f, p));
      if (!(result > bound))
        break;
    }
    return result;
  }

  // Differences serve any measure.
  void differentiate(Function& f) const {
    const double h = 1e-6 * m_length;
    const auto slope = [&](const Vector& axis) {
      return (value(f, m_position + h * axis) - f.value) / h;
    };
    f.gradient = Vector(slope(Vector(1, 0, 0)), slope(Vector(0, 1, 0)), slope(Vector(0, 0, 1)));
  }

  // The point of the convex hull of the active gradients that is nearest to the origin (Gilbert).
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

  // One step of steepest ascent with a line search. Returns whether it was worth it.
  bool step() {
    double before = std::numeric_limits<double>::infinity();
    for (Function& f : m_functions) {
      f.value = value(f, m_position);
      before = (std::min)(before, f.value);
    }
    // Those that are much better than the worst will not become the worst in one step. The worst
    // may be zero or less by rounding.
    const double relevant = before + std::abs(before), active = before + .05 * std::abs(before);
    for (Function& f : m_functions)
      if (f.value <= relevant)
        differentiate(f);
    const Vector d = steepest_ascent(active);
    const double rate = d.squared_length();
    if (!(std::sqrt(rate) * m_length > 1e-3))
      return false;
    // As far as another function becomes the worst, by linear prediction.
    double way = .5 * m_length / std::sqrt(rate);
    for (const Function& f : m_functions) {
      if (!(f.value <= relevant))
        continue;
      const double slope = f.gradient * d;
      if (slope < rate && f.value > before)
        way = (std::min)(way, (std::max)(1e-3 * way, (f.value - before) / (rate - slope)));
    }
    for (int halvings = 0; halvings < 6; ++halvings, way /= 2) {
      const Point p = m_position + way * d;
      const double after = worst(p, before);
      if (after > before) {
        m_position = p;
        return after > before + .02 * std::abs(before);
      }
    }
    return false;
  }

  const Complex& m_complex;
  Point m_position;
  std::vector<Function> m_functions;
  double m_length = 0;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Proposes to move a vertex to where the worst quality of its star is locally highest
(optimisation-based smoothing, section 3.2.1 of the paper; Freitag, Jones and Plassmann 1995). An
order of magnitude more expensive than `propose_smart_laplacian()`.

\param complex is not changed.
\param v a vertex neither on the interface nor on the boundary of the domain.
\param star the star of v.
\param target the proposed position.
\return whether there is one; commit with `complex.set_point(v, star, target)`.

Linear in the star.
*/
template <class Complex>
bool propose_optimal_position(const Complex& complex, typename Complex::Vertex_handle v,
                              const std::vector<typename Complex::Cell_handle>& star,
                              typename Complex::Point_3& target) {
  if (v->is_interface() || complex.is_boundary(v))
    return false;
  const auto from = complex.position(v);
  const auto to =
      Deformable_simplicial_complexes::internal::Star_optimizer_3<Complex>(complex, v, star).run();
  if (to == from)
    return false;
  target = complex.geom_traits().construct_exact_point_3_object()(to);
  return complex.is_positive_star(v, star, target);
}

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_VERTEX_OPTIMIZATION_3_H
