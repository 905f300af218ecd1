// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_PYTHON_CALLBACKS_H
#define DSC_PYTHON_CALLBACKS_H

#include "Space.h"

#include <CGAL/Deformable_simplicial_complexes/internal/traversal/cell_corners.h>

#include <pybind11/stl.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>

namespace dsc_python {

/// A function of Python whose copies share one reference, since the lock of the interpreter is not
/// held where options are copied.
class Shared_function
{
public:
  explicit Shared_function(py::function function)
      : m_function(std::make_shared<py::function>(std::move(function))) {}

  template <class... Arguments> py::object call(Arguments&&... arguments) const {
    return (*m_function)(std::forward<Arguments>(arguments)...);
  }

private:
  std::shared_ptr<py::function> m_function;
};

/// Velocity field that a Python function gives: `function(points, t)` returns the velocities at
/// the points, both as arrays of shape (n, d). Model of `VelocityFieldOfPoints`.
template <class Complex> class Velocity_function
{
public:
  using Point = typename Complex::Point;
  using Vector = typename Complex::Vector;

  Velocity_function(py::function function, const Space<Complex>& space)
      : m_function(std::move(function)), m_space(space) {}

  void operator()(const std::vector<Point>& points, double t,
                  std::vector<Vector>& velocities) const {
    const py::gil_scoped_acquire lock;
    const py::array array(m_function.call(m_space.array(points), t));
    if (!is_of_real_numbers(array))
      throw py::type_error("the velocities must be an array of real numbers");
    const Array<double> result(array);
    const auto rows = rows_of<double, Complex::dimension>(result, "the velocities");
    if (rows.size() != points.size())
      throw py::value_error("the velocity function returned " + std::to_string(rows.size()) +
                            " velocities for " + std::to_string(points.size()) + " points");
    velocities.clear();
    for (const auto& row : rows)
      velocities.push_back(
          m_space.from_user(CGAL::Deformable_simplicial_complexes::vector_of<Complex>(row)));
  }

private:
  Shared_function m_function;
  Space<Complex> m_space;
};

/// Function of labels that a Python function gives: `function(points)` returns the labels at the
/// points, integers of shape (n,), for points of shape (n, d).
template <class Complex> class Label_function : private Shared_function
{
public:
  using Point = typename Complex::Point;

  using Shared_function::Shared_function;

  std::vector<int> operator()(const std::vector<Point>& points) const {
    const py::gil_scoped_acquire lock;
    const auto array = array_of_vectors(points, Complex::dimension);
    const std::vector<int> labels = labels_of(py::array(call(array)), "the labels");
    if (labels.size() != points.size())
      throw py::value_error("the label function returned " + std::to_string(labels.size()) +
                            " labels for " + std::to_string(points.size()) + " points");
    return labels;
  }
};

/// A Python function of one or several labels that returns a number. It is called once for each
/// combination of labels. Copies share the numbers.
template <class... Labels> class Function_of_labels
{
public:
  Function_of_labels(py::function function, std::string name, double factor = 1)
      : m_function(std::move(function)), m_name(std::move(name)), m_factor(factor),
        m_numbers(std::make_shared<std::map<std::tuple<Labels...>, double>>()) {}

  double operator()(Labels... labels) const {
    const py::gil_scoped_acquire lock;
    const std::tuple<Labels...> key(labels...);
    if (const auto found = m_numbers->find(key); found != m_numbers->end())
      return found->second;
    const py::object value = m_function.call(labels...);
    double number = 0;
    try {
      number = m_factor * value.cast<double>();
    } catch (const py::cast_error&) {
      throw py::type_error("the function " + m_name + " must return a number");
    }
    m_numbers->emplace(key, number);
    return number;
  }

private:
  Shared_function m_function;
  std::string m_name;
  double m_factor;
  std::shared_ptr<std::map<std::tuple<Labels...>, double>> m_numbers;
};

/// Region that a Python function gives: `function(points)` returns whether the points are in the
/// region, booleans of shape (n,), for points of shape (n, d).
template <class Point> class Region_function : private Shared_function
{
public:
  using Shared_function::Shared_function;

  bool operator()(const Point& p) const {
    const py::gil_scoped_acquire lock;
    const auto points = array_of_vectors(std::array<Point, 1>{p}, p.dimension());
    const py::array inside(call(points));
    if (inside.dtype().kind() != 'b')
      throw py::type_error("the function of a region must return booleans");
    if (inside.ndim() != 1 || inside.size() != 1)
      throw py::value_error("the function of a region must return one boolean for each point");
    return labels_of(inside, "the region").front() != 0;
  }
};

/// Function of points of a side that a Python function gives: `function(point, t)` returns a value,
/// or None where the side is a wall. In the plane, points and vectors have two coordinates.
template <int d> class Side_function
{
public:
  explicit Side_function(py::function function) : m_function(std::move(function)) {}

  /// Returns the number at a point and a time.
  std::optional<double> number(const std::array<double, 3>& p, double t) const {
    const py::gil_scoped_acquire lock;
    const py::object value = call(p, t);
    return value.is_none() ? std::nullopt : std::optional<double>(double(py::float_(value)));
  }

  /// Returns the vector at a point and a time.
  std::optional<std::array<double, 3>> vector(const std::array<double, 3>& p, double t) const {
    const py::gil_scoped_acquire lock;
    const py::object value = call(p, t);
    if (value.is_none())
      return std::nullopt;
    const auto coordinates = value.cast<std::array<double, d>>();
    std::array<double, 3> result = {};
    std::copy(coordinates.begin(), coordinates.end(), result.begin());
    return result;
  }

private:
  py::object call(const std::array<double, 3>& p, double t) const {
    return m_function.call(array_of<double>(std::size_t(d), [&](std::size_t i) { return p[i]; }),
                           t);
  }

  Shared_function m_function;
};

/// A number, or a Python function `function(t)` that returns a number.
class Number_function
{
public:
  /// \throws py::cast_error if it is neither a number nor a function
  explicit Number_function(const py::object& given) {
    if (py::isinstance<py::function>(given))
      m_function.emplace(given.cast<py::function>());
    else
      m_constant = given.cast<double>();
  }

  double operator()(double t) const {
    if (!m_function)
      return m_constant;
    const py::gil_scoped_acquire lock;
    return double(py::float_(m_function->call(t)));
  }

private:
  double m_constant = 0;
  std::optional<Shared_function> m_function;
};

/// Values of a field at points that a Python function gives: `function(points)` returns numbers of
/// shape (n,), for points of shape (n, d). A time can follow the points. The value is none where
/// the function returns NaN.
template <class Point> class Field_function : private Shared_function
{
public:
  using Shared_function::Shared_function;

  template <class... Time> std::optional<double> operator()(const Point& p, Time... t) const {
    const py::gil_scoped_acquire lock;
    const auto points = array_of_vectors(std::array<Point, 1>{p}, p.dimension());
    const py::array array(call(points, t...));
    if (!is_of_real_numbers(array) || array.ndim() != 1 || array.size() != 1)
      throw py::type_error("the function of a field must return one number for each point");
    const double value = *Array<double>(array).data();
    return std::isnan(value) ? std::nullopt : std::optional<double>(value);
  }
};

/// Topology control that a Python function gives: `function(label, new_label, point)` returns
/// whether space at the point may pass from one label to the other.
template <class Complex> class Topology_function
{
public:
  Topology_function(py::function function, const Space<Complex>& space)
      : m_function(std::move(function)), m_space(space) {}

  bool operator()(const Complex& complex, typename Complex::Cell_handle cell, int label) const {
    const auto center =
        m_space.to_user(CGAL::Deformable_simplicial_complexes::internal::barycenter(complex, cell));
    const py::gil_scoped_acquire lock;
    const py::array_t<double> point = array_of<double>(
        std::size_t(Complex::dimension), [&](std::size_t i) { return center[int(i)]; });
    return bool(py::bool_(m_function.call(cell->subdomain_index(), label, point)));
  }

private:
  Shared_function m_function;
  Space<Complex> m_space;
};

} // namespace dsc_python

#endif // DSC_PYTHON_CALLBACKS_H
