// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FILM_H
#define DSC_FILM_H

#include "frame_order.h"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace dsc {

/// A scalar or a vector on each point or each simplex of a frame.
struct Film_field
{
  std::string name;
  bool on_points = true;      ///< otherwise on simplices
  std::size_t components = 1; ///< 1, or the dimension for vectors
  std::vector<double> values; ///< point by point, or simplex by simplex
};

/// The mesh at one time: either all cells of a complex, or the facets of its interface.
struct Film_frame
{
  std::int64_t step = 0;
  double time = 0;
  std::vector<std::array<double, 3>> points; ///< the last coordinate is 0 in the plane
  /// Numbers that identify points in all frames. If empty, points must be listed in the order of
  /// their creation.
  std::vector<std::uint64_t> ids;
  /// Indices of points. Cells are positively oriented. Facets are counterclockwise seen from the
  /// side of their first label.
  std::vector<std::array<std::uint32_t, 4>> simplices;
  /// Label of each cell, or the two labels beside each facet.
  std::vector<std::array<int, 2>> labels;
  std::vector<Film_field> fields;
};

/// A run as one HTML file that shows it in a browser without a network. Frames are stored as
/// differences to the previous frame.
class Film
{
public:
  enum class Content { cells, facets };

  /// \param dimension 2 or 3
  Film(std::string title, int dimension, Content content)
      : m_title(std::move(title)), m_dimension(dimension), m_content(content) {}

  /// Adds a frame. n log n in its size.
  /// \throws std::invalid_argument if sizes do not fit, an index is out of range, or a coordinate
  ///         or a value is not finite or too large; the film is then unchanged
  void add(const Film_frame& frame);

  std::size_t number_of_frames() const { return m_frames.size(); }

  /// Adds a value to a chart, for the frame that was added last.
  void add_to_series(const std::string& name, double value);

  /// Adds an event, such as a merge of components. It is shown at the first frame of this time or
  /// later, or at the last frame.
  void add_event(double time, std::string text) { m_events.push_back({time, std::move(text)}); }

  /// Hides a label until the user shows it.
  void hide(int label) { m_hidden.push_back(label); }

  /// Sets the name of a label, which is shown after its number.
  void set_name(int label, std::string name) { m_names[label] = std::move(name); }

  /// Returns the file.
  /// \throws std::invalid_argument if there is no frame
  std::string html() const;

private:
  // Form of a field, and the range of its values in all frames: of scalars, or of the lengths of
  // vectors, which begins with 0.
  struct Field
  {
    bool on_points;
    std::size_t components;
    double least = std::numeric_limits<double>::infinity();
    double greatest = -std::numeric_limits<double>::infinity();

    void add(double value);
  };
  using Quantized = std::array<std::int64_t, 3>;

  // A frame. Points and simplices that the previous frame contains come first.
  struct Mesh
  {
    std::vector<std::array<double, 3>> points;
    std::vector<Quantized> quantized;
    std::vector<std::uint64_t> ids;
    std::vector<std::array<Index, 4>> simplices;
    std::vector<std::array<int, 2>> labels;
  };
  struct Encoded_frame
  {
    std::int64_t step;
    double time;
    std::size_t points, simplices;
    std::optional<std::string> kept_points, kept_simplices; // none in the first frame
    std::string positions, new_simplices;
    std::vector<std::array<int, 2>> new_labels;
    std::vector<Film_field> fields;
  };
  struct Event
  {
    double time;
    std::string text;
  };

  std::size_t corners() const {
    return std::size_t(m_content == Content::cells ? m_dimension + 1 : m_dimension);
  }
  std::size_t labels_of_simplex() const { return m_content == Content::cells ? 1 : 2; }
  void check(const Film_frame& frame) const;
  void set_box(const Film_frame& frame);
  Quantized quantized(const std::array<double, 3>& point) const;
  std::array<Index, 6> simplex_key(const std::array<Index, 4>& corners,
                                   const std::array<int, 2>& labels) const;
  std::string encoded_positions(const Mesh& mesh, const std::vector<Index>& kept) const;
  std::string encoded_simplices(const Mesh& mesh, std::size_t first) const;
  std::vector<Index> former_points(const Film_frame& frame) const;
  std::vector<Index> former_simplices(const Film_frame& frame,
                                      const std::vector<Index>& former) const;
  void add_volumes(const Film_frame& frame);
  std::vector<int> labels() const;
  nlohmann::ordered_json frames_to_json(const std::vector<int>& labels,
                                        nlohmann::ordered_json& blobs) const;
  nlohmann::ordered_json fields_to_json() const;
  nlohmann::ordered_json series_to_json() const;
  nlohmann::ordered_json events_to_json() const;

  std::string m_title;
  int m_dimension;
  Content m_content;
  std::array<double, 3> m_origin = {}; // of quantized positions
  double m_unit = 1;                   // length of a unit of quantized positions
  Mesh m_last;                         // the last frame
  std::vector<Encoded_frame> m_frames;
  std::map<std::string, Field> m_fields;                              // by name
  std::map<std::string, std::vector<std::optional<double>>> m_series; // by name
  std::vector<Event> m_events;
  std::vector<int> m_hidden;
  std::map<int, std::string> m_names; // of labels
};

} // namespace dsc

#endif // DSC_FILM_H
