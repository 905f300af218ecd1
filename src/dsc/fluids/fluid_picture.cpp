// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluids/fluid_picture.h"

#include "fluids/fluid_fields.h"
#include "output/picture.h"

#include <CGAL/Mesh_files/SVG_2.h>

namespace dsc {
namespace {

double length_of(const std::array<double, 3>& v) { return std::hypot(v[0], v[1], v[2]); }

/// The colors of the cells of a fluid, by label or by the value of a quantity in liquids.
template <class Complex> class Cell_colors
{
public:
  using Cell_handle = typename Complex::Cell_handle;

  /// \param quantity one of quantities_of_pictures(); empty for the label
  Cell_colors(const Fluid<Complex>& fluid, const std::string& quantity)
      : m_fields(fluid), m_quantity(quantity) {
    if (quantity.empty())
      return;
    for (const Cell_handle c : fluid.complex().cells())
      if (m_fields.is_liquid(c)) {
        m_least = (std::min)(m_least, value(c));
        m_largest = (std::max)(m_largest, value(c));
      }
  }

  /// Returns the color of a cell. Cells without a value are white.
  Picture_color operator()(Cell_handle c) const {
    if (m_quantity.empty())
      return color_of_label(c->subdomain_index());
    if (!m_fields.is_liquid(c))
      return {1, 1, 1};
    const double range = m_largest - m_least;
    return color_of_number(range > 0 ? (value(c) - m_least) / range : 0);
  }

  std::string text_of_range() const {
    if (m_quantity.empty() || !(m_least <= m_largest))
      return {};
    char text[80];
    std::snprintf(text, sizeof text, ", %s from %.4g to %.4g", m_quantity.c_str(), m_least,
                  m_largest);
    return text;
  }

private:
  /// Returns the value in a cell: the mean pressure or field, or the length of the mean velocity or
  /// of the vorticity. In the plane, the vorticity has a sign.
  double value(Cell_handle c) const {
    if (m_quantity == "field") {
      double result = 0;
      for (const auto v : m_fields.vertices_of(c))
        result += m_fields.fluid().field(v) / Complex::corners;
      return result;
    }
    if (m_quantity == "pressure")
      return m_fields.mean_pressure(m_fields.vertices_of(c), c);
    if (m_quantity == "velocity")
      return length_of(m_fields.mean_velocity(m_fields.vertices_of(c), c));
    const auto vorticity = m_fields.fluid().vorticity(c);
    if constexpr (Complex::dimension == 2)
      return vorticity;
    else
      return length_of(coordinates_of(vorticity));
  }

  Fluid_fields<Complex> m_fields;
  std::string m_quantity;
  double m_least = std::numeric_limits<double>::infinity(), m_largest = -m_least;
};

/// The intersection of cells and facets with a plane.
class Section
{
public:
  using Complex = Tracked_complex_3::Complex;
  using Vertex_handle = Complex::Vertex_handle;

  Section(const Complex& complex, const Cut& cut) : m_complex(complex), m_cut(cut) {}

  /// Returns the corners of the intersection with a simplex, in order around it: two for a
  /// triangle, three or four for a tetrahedron. Vertices in the plane count as above it, so that
  /// adjacent simplices have no common intersection. Returns no corner if all vertices are on one
  /// side.
  template <class Vertices> std::vector<Picture_point> operator()(const Vertices& vertices) const {
    std::vector<Vertex_handle> above, below;
    for (const Vertex_handle v : vertices)
      (height(v) >= 0 ? above : below).push_back(v);
    std::vector<Picture_point> result;
    for (std::size_t i = 0; i < above.size(); ++i) {
      for (const Vertex_handle v : below)
        result.push_back(crossing(above[i], v));
      if (i == 1 && below.size() == 2)
        std::swap(result[2], result[3]);
    }
    return result;
  }

private:
  double height(Vertex_handle v) const {
    return m_complex.user_position(v)[int(m_cut.axis)] - m_cut.value;
  }

  /// Returns the point of an edge in the plane.
  Picture_point crossing(Vertex_handle above, Vertex_handle below) const {
    const auto p = coordinates_of(m_complex.user_position(above)),
               q = coordinates_of(m_complex.user_position(below));
    const double a = height(above), b = height(below), weight = a / (a - b);
    Picture_point result = {};
    for (std::size_t axis = 0, k = 0; axis < 3; ++axis)
      if (axis != m_cut.axis)
        result[k++] = p[axis] + weight * (q[axis] - p[axis]);
    return result;
  }

  const Complex& m_complex;
  Cut m_cut;
};

void draw_cells(const std::string& path, const Tracked_complex_2::Complex& complex,
                const Cell_colors<Tracked_complex_2::Complex>& color_of) {
  CGAL::IO::write_SVG(path, complex, CGAL::IO::SVG_options(),
                      [&](auto c) { return DSC::internal::hexadecimal(color_of(c)); });
}

void draw_cut(const std::string& path, const Tracked_complex_3::Complex& complex, const Cut& cut,
              const Cell_colors<Tracked_complex_3::Complex>& color_of) {
  const Section section(complex, cut);
  Picture picture;
  for (const auto c : complex.cells()) {
    const auto corners = section(Fluid_fields<Tracked_complex_3::Complex>::vertices_of(c));
    if (!corners.empty())
      picture.polygons.push_back({corners, color_of(c)});
  }
  for (const auto& f : complex.interface_facets()) {
    const auto ends = section(complex.facet_vertices(f));
    if (!ends.empty())
      picture.lines.push_back({{ends[0], ends[1]}});
  }
  write_picture(path, picture);
}

} // namespace

const std::vector<std::string>& quantities_of_pictures() {
  static const std::vector<std::string> result = {"field", "pressure", "velocity", "vorticity"};
  return result;
}

template <int dimension>
std::string draw_fluid(const Fluid_picture& picture, const Tracked_complex_of<dimension>& complex,
                       const Fluid<typename Tracked_complex_of<dimension>::Complex>& fluid) {
  using Complex = typename Tracked_complex_of<dimension>::Complex;
  if (!picture.cut && picture.quantity.empty()) {
    complex.write(picture.path);
    return {};
  }
  const Cell_colors<Complex> colors(fluid, picture.quantity);
  if constexpr (dimension == 2)
    draw_cells(picture.path, complex.complex, colors);
  else
    draw_cut(picture.path, complex.complex, *picture.cut, colors);
  return colors.text_of_range();
}

template std::string draw_fluid<2>(const Fluid_picture&, const Tracked_complex_2&,
                                   const Fluid<Tracked_complex_2::Complex>&);
template std::string draw_fluid<3>(const Fluid_picture&, const Tracked_complex_3&,
                                   const Fluid<Tracked_complex_3::Complex>&);

} // namespace dsc
