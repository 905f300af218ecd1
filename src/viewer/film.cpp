// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "film.h"
#include "page.h"

#include <CGAL/Mesh_files/internal/pictures/colors.h>

#include <nlohmann/json.hpp>

#include <charconv>
#include <set>
#include <stdexcept>

namespace dsc {
namespace {

using Numbers = std::vector<std::int64_t>;
using Json = nlohmann::ordered_json;

constexpr int position_bits = 20;       // the extent of the first frame is 2^20 - 1 units
constexpr double largest_value = 1e150; // of a field, so that squares are finite
constexpr int field_steps = 4095;       // values of fields are stored with 12 bits

std::string packed_kept(const std::vector<Index>& kept) {
  Numbers numbers;
  std::int64_t expected = 0;
  for (const Index i : kept) {
    numbers.push_back(i - expected);
    expected = std::int64_t(i) + 1;
  }
  return packed(numbers);
}

void append_differences(const std::vector<std::int64_t>& values, Numbers& numbers) {
  std::int64_t last = 0;
  for (const std::int64_t value : values) {
    numbers.push_back(value - last);
    last = value;
  }
}

// Labels are stored by their indices in `all_labels`, which are sorted.
std::string packed_labels(const std::vector<std::array<int, 2>>& labels, std::size_t width,
                          const std::vector<int>& all_labels) {
  Numbers numbers;
  for (std::size_t side = 0; side < width; ++side) {
    std::vector<std::int64_t> indices;
    for (const auto& pair : labels)
      indices.push_back(std::lower_bound(all_labels.begin(), all_labels.end(), pair[side]) -
                        all_labels.begin());
    append_differences(indices, numbers);
  }
  return packed(numbers);
}

std::string packed_field(const Film_field& field, double low, double high) {
  const double extent = high - low;
  Numbers numbers;
  for (std::size_t component = 0; component < field.components; ++component) {
    std::vector<std::int64_t> steps;
    for (std::size_t i = component; i < field.values.size(); i += field.components)
      steps.push_back(extent > 0 ? std::llround((field.values[i] - low) / extent * field_steps)
                                 : 0);
    append_differences(steps, numbers);
  }
  return packed(numbers);
}

double determinant(const std::array<double, 3>& a, const std::array<double, 3>& b,
                   const std::array<double, 3>& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// Returns the value of a scalar, or the length of a vector, in a row of a field.
double magnitude(const Film_field& field, std::size_t row) {
  const double* values = &field.values[row * field.components];
  return field.components == 1
             ? values[0]
             : std::sqrt(std::inner_product(values, values + field.components, values, 0.));
}

// Returns the color of a label. The color of label 0, usually the outside, differs from the page.
std::string color_of(int label) {
  namespace internal = CGAL::Deformable_simplicial_complexes::internal;
  return label == 0 ? "#a0a4a8" : internal::hexadecimal(internal::color_of_label(label));
}

// Returns the color of a series: the one of the label in its name, if there is one.
std::string color_of_series(const std::string& name, std::size_t index) {
  int label = 10 + int(index);
  const std::size_t at = name.find("label ");
  if (at != name.npos)
    std::from_chars(name.data() + at + 6, name.data() + name.size(), label);
  return color_of(label);
}

} // namespace

void Film::check(const Film_frame& frame) const {
  const auto require = [](bool condition, const char* message) {
    if (!condition)
      throw std::invalid_argument(message);
  };
  require(frame.ids.empty() || frame.ids.size() == frame.points.size(),
          "the number of ids differs from the number of points of the frame");
  require(frame.labels.size() == frame.simplices.size(),
          "the number of labels differs from the number of simplices of the frame");
  require(std::isfinite(frame.time), "the time of the frame is not finite");
  for (const auto& p : frame.points)
    require(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]),
            "a coordinate of the frame is not finite");
  for (const auto& simplex : frame.simplices)
    for (std::size_t i = 0; i < corners(); ++i)
      require(simplex[i] < frame.points.size(), "a simplex of the frame has an unknown point");
  for (const Film_field& field : frame.fields) {
    const std::size_t rows = field.on_points ? frame.points.size() : frame.simplices.size();
    require(field.components == 1 || field.components == std::size_t(m_dimension),
            "a field of the frame is neither scalar nor a vector");
    require(field.values.size() == rows * field.components,
            "the number of values of a field differs from the number of its points or simplices");
    for (const double x : field.values) {
      require(std::isfinite(x), "a value of a field of the frame is not finite");
      require(std::abs(x) <= largest_value, "a value of a field of the frame is too large");
    }
    const auto known = m_fields.find(field.name);
    require(known == m_fields.end() || (known->second.on_points == field.on_points &&
                                        known->second.components == field.components),
            "a field of the frame has another form than in earlier frames");
  }
}

void Film::set_box(const Film_frame& frame) {
  if (frame.points.empty())
    return;
  std::array<double, 3> low = frame.points.front(), high = low;
  for (const auto& p : frame.points)
    for (int i = 0; i < 3; ++i) {
      low[i] = (std::min)(low[i], p[i]);
      high[i] = (std::max)(high[i], p[i]);
    }
  m_origin = low;
  const double extent = (std::max)({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  m_unit = extent > 0 ? extent / (std::ldexp(1., position_bits) - 1) : 1;
}

void Film::Field::add(double value) {
  least = components > 1 ? 0 : (std::min)(least, value);
  greatest = (std::max)(greatest, value);
}

Film::Quantized Film::quantized(const std::array<double, 3>& point) const {
  Quantized result;
  static constexpr double most = 4503599627370496.; // 2^52, which the page can represent
  for (int i = 0; i < 3; ++i) {
    const double units = (point[i] - m_origin[i]) / m_unit;
    if (!(std::abs(units) < most))
      throw std::invalid_argument("a point is too far from the points of the first frame");
    result[i] = std::llround(units);
  }
  return result;
}

// Returns a key that is equal for equal simplices with equal labels. Facets differ from facets of
// the opposite orientation.
std::array<Index, 6> Film::simplex_key(const std::array<Index, 4>& simplex,
                                       const std::array<int, 2>& labels) const {
  std::array<Index, 6> result = {none, none, none, none, Index(labels[0]), Index(labels[1])};
  const auto end = std::copy_n(simplex.begin(), corners(), result.begin());
  if (m_content == Content::cells)
    std::sort(result.begin(), result.begin() + 4); // `none` is greater than all indices
  else if (m_dimension == 3)
    std::rotate(result.begin(), std::min_element(result.begin(), end), end);
  return result;
}

std::string Film::encoded_positions(const Mesh& mesh, const std::vector<Index>& kept) const {
  Numbers numbers;
  for (int axis = 0; axis < m_dimension; ++axis)
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
      const std::int64_t predicted = i < kept.size() ? m_last.quantized[kept[i]][axis]
                                     : i > 0         ? mesh.quantized[i - 1][axis]
                                                     : 0;
      numbers.push_back(mesh.quantized[i][axis] - predicted);
    }
  return packed(numbers);
}

std::string Film::encoded_simplices(const Mesh& mesh, std::size_t first) const {
  Numbers numbers;
  for (std::size_t corner = 0; corner < corners(); ++corner) {
    Numbers indices;
    for (std::size_t i = first; i < mesh.simplices.size(); ++i)
      indices.push_back(mesh.simplices[i][corner]);
    append_differences(indices, numbers);
  }
  return packed(numbers);
}

// Returns the index of each point in the last frame, or `none`.
std::vector<Index> Film::former_points(const Film_frame& frame) const {
  return frame.ids.empty() ? matches_in_order(m_last.points, frame.points)
                           : matches(m_last.ids, frame.ids);
}

// Returns the index of each simplex in the last frame, or `none`. `former` contains the indices of
// the points in the last frame.
std::vector<Index> Film::former_simplices(const Film_frame& frame,
                                          const std::vector<Index>& former) const {
  std::vector<std::array<Index, 6>> before, keys;
  for (std::size_t i = 0; i < m_last.simplices.size(); ++i)
    before.push_back(simplex_key(m_last.simplices[i], m_last.labels[i]));
  for (std::size_t i = 0; i < frame.simplices.size(); ++i) {
    std::array<Index, 4> simplex = frame.simplices[i];
    for (std::size_t j = 0; j < corners(); ++j)
      simplex[j] = former[simplex[j]];
    keys.push_back(simplex_key(simplex, frame.labels[i]));
  }
  return matches(before, keys);
}

void Film::add(const Film_frame& frame) {
  check(frame);
  if (m_last.points.empty())
    set_box(frame);
  Mesh mesh;
  const std::vector<Index> former = former_points(frame);
  const Order points(former), simplices(former_simplices(frame, former));
  mesh.points = chosen_rows(frame.points, points.indices);
  mesh.ids = frame.ids.empty() ? frame.ids : chosen_rows(frame.ids, points.indices);
  for (const auto& p : mesh.points)
    mesh.quantized.push_back(quantized(p));
  std::vector<Index> place(points.indices.size());
  for (std::size_t i = 0; i < place.size(); ++i)
    place[points.indices[i]] = Index(i);
  mesh.simplices = chosen_rows(frame.simplices, simplices.indices);
  for (auto& simplex : mesh.simplices)
    for (std::size_t j = 0; j < corners(); ++j)
      simplex[j] = place[simplex[j]];
  mesh.labels = chosen_rows(frame.labels, simplices.indices);

  Encoded_frame encoded{
      frame.step, frame.time, mesh.points.size(), mesh.simplices.size(), {}, {}, {}, {}, {}, {}};
  if (!m_frames.empty()) {
    encoded.kept_points = packed_kept(points.kept);
    encoded.kept_simplices = packed_kept(simplices.kept);
  }
  encoded.positions = encoded_positions(mesh, points.kept);
  encoded.new_simplices = encoded_simplices(mesh, simplices.kept.size());
  encoded.new_labels.assign(mesh.labels.begin() + std::ptrdiff_t(simplices.kept.size()),
                            mesh.labels.end());
  for (const Film_field& field : frame.fields) {
    Field& known =
        m_fields.try_emplace(field.name, Field{field.on_points, field.components}).first->second;
    for (std::size_t row = 0; row < field.values.size() / field.components; ++row)
      known.add(magnitude(field, row));
    encoded.fields.push_back(
        {field.name, field.on_points, field.components,
         chosen_rows(field.values, (field.on_points ? points : simplices).indices,
                     field.components)});
  }
  m_frames.push_back(std::move(encoded));
  m_last = std::move(mesh);
  add_volumes(frame);
}

void Film::add_volumes(const Film_frame& frame) {
  if (m_content != Content::cells)
    return;
  std::map<int, double> volumes;
  for (std::size_t i = 0; i < frame.simplices.size(); ++i) {
    std::array<std::array<double, 3>, 3> edges = {{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}};
    for (int j = 0; j < m_dimension; ++j)
      for (int axis = 0; axis < 3; ++axis)
        edges[j][axis] = frame.points[frame.simplices[i][j + 1]][axis] -
                         frame.points[frame.simplices[i][0]][axis];
    volumes[frame.labels[i][0]] +=
        determinant(edges[0], edges[1], edges[2]) / (m_dimension == 3 ? 6 : 2);
  }
  for (const auto& [label, volume] : volumes)
    add_to_series(
        (m_dimension == 3 ? "volume of label " : "area of label ") + std::to_string(label), volume);
}

void Film::add_to_series(const std::string& name, double value) {
  auto& values = m_series[name];
  values.resize(m_frames.size());
  values.back() = value;
}

std::vector<int> Film::labels() const {
  std::set<int> result;
  for (const Encoded_frame& frame : m_frames)
    for (const auto& pair : frame.new_labels)
      result.insert(pair.begin(), pair.begin() + labels_of_simplex());
  return {result.begin(), result.end()};
}

// Appends the packed numbers of all frames to `blobs`. Frames refer to them by their indices.
Json Film::frames_to_json(const std::vector<int>& labels, Json& blobs) const {
  const auto add_blob = [&](std::string text) {
    blobs.push_back(std::move(text));
    return blobs.size() - 1;
  };
  Json result = Json::array();
  for (const Encoded_frame& frame : m_frames) {
    Json entry = {{"step", frame.step},
                  {"time", frame.time},
                  {"vertices", frame.points},
                  {"simplices", frame.simplices}};
    if (frame.kept_points) {
      entry["kept_vertices"] = add_blob(*frame.kept_points);
      entry["kept_simplices"] = add_blob(*frame.kept_simplices);
    }
    entry["positions"] = add_blob(frame.positions);
    entry["new_simplices"] = add_blob(frame.new_simplices);
    entry["labels"] = add_blob(packed_labels(frame.new_labels, labels_of_simplex(), labels));
    Json fields = Json::object();
    for (const Film_field& field : frame.fields) {
      const Field& range = m_fields.at(field.name);
      // Components of a vector are between plus and minus the greatest length.
      const double low = range.components > 1 ? -range.greatest : range.least;
      fields[field.name] = add_blob(packed_field(field, low, range.greatest));
    }
    entry["fields"] = std::move(fields);
    result.push_back(std::move(entry));
  }
  return result;
}

Json Film::fields_to_json() const {
  Json result = Json::array();
  for (const auto& [name, field] : m_fields)
    result.push_back({{"name", name},
                      {"of", field.on_points ? "vertices" : "cells"},
                      {"components", field.components},
                      {"minimum", field.least},
                      {"maximum", field.greatest},
                      {"steps", field_steps}});
  return result;
}

Json Film::series_to_json() const {
  Json result = Json::array();
  for (const auto& [name, values] : m_series) {
    Json numbers = Json::array();
    for (std::size_t i = 0; i < m_frames.size(); ++i)
      numbers.push_back(i < values.size() && values[i] ? Json(*values[i]) : Json());
    result.push_back({{"name", name},
                      {"color", color_of_series(name, result.size())},
                      {"values", std::move(numbers)}});
  }
  return result;
}

Json Film::events_to_json() const {
  Json result = Json::array();
  for (const Event& event : m_events) {
    const auto frame =
        std::find_if(m_frames.begin(), m_frames.end() - 1,
                     [&](const Encoded_frame& frame) { return frame.time >= event.time; });
    result.push_back(
        {{"frame", frame - m_frames.begin()}, {"time", event.time}, {"text", event.text}});
  }
  return result;
}

std::string Film::html() const {
  if (m_frames.empty())
    throw std::invalid_argument("the film has no frame");
  const std::vector<int> labels = this->labels();
  std::vector<std::string> colors(labels.size());
  std::transform(labels.begin(), labels.end(), colors.begin(), color_of);
  Json blobs = Json::array();
  Json film = {{"version", 1},
               {"title", m_title},
               {"dimension", m_dimension},
               {"origin", std::vector<double>(m_origin.begin(), m_origin.begin() + m_dimension)},
               {"unit", m_unit},
               {"labels", labels},
               {"colors", colors},
               {"hidden", m_hidden},
               {"cells", m_content == Content::cells},
               {"fields", fields_to_json()},
               {"series", series_to_json()},
               {"events", events_to_json()}};
  if (!m_names.empty())
    film["names"] = m_names;
  film["frames"] = frames_to_json(labels, blobs);
  film["blobs"] = std::move(blobs);
  return page_with(film.dump(-1, ' ', false, Json::error_handler_t::replace));
}

} // namespace dsc
