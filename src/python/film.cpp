// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "arrays.h"
#include "module.h"

#include <film.h>

#include <pybind11/stl.h>

namespace dsc_python {
namespace {

using dsc::Film;

/// Adds a frame of cells, labels (m,), or of facets, labels (m, 2): behind and in front.
void add(Film& film, std::int64_t step, double time, const Array<double>& points,
         const Array<std::uint32_t>& simplices, const Array<std::int32_t>& labels,
         const Array<std::uint64_t>& ids,
         const std::map<std::string, std::pair<bool, Array<double>>>& fields) {
  dsc::Film_frame frame;
  frame.step = step;
  frame.time = time;
  const std::size_t n = std::size_t(points.shape(0)), d = std::size_t(points.shape(1)),
                    m = std::size_t(simplices.shape(0)), corners = std::size_t(simplices.shape(1));
  frame.points.resize(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < d; ++j)
      frame.points[i][j] = points.data()[i * d + j];
  frame.ids.assign(ids.data(), ids.data() + ids.size());
  frame.simplices.resize(m);
  frame.labels.resize(m);
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < corners; ++j)
      frame.simplices[i][j] = simplices.data()[i * corners + j];
    frame.labels[i] = labels.ndim() == 1
                          ? std::array<int, 2>{labels.data()[i], 0}
                          : std::array<int, 2>{labels.data()[2 * i + 1], labels.data()[2 * i]};
  }
  for (const auto& [name, field] : fields) {
    const Array<double>& values = field.second;
    frame.fields.push_back({name,
                            field.first,
                            values.ndim() == 1 ? 1 : std::size_t(values.shape(1)),
                            {values.data(), values.data() + values.size()}});
  }
  film.add(frame);
}

} // namespace

void bind_film(py::module_& module) {
  py::class_<Film>(module, "Film")
      .def(py::init([](std::string title, int dimension, bool has_cells) {
        return Film(std::move(title), dimension,
                    has_cells ? Film::Content::cells : Film::Content::facets);
      }))
      .def("add", &add)
      .def("add_event", &Film::add_event)
      .def("add_to_series", &Film::add_to_series)
      .def("hide", &Film::hide)
      .def("set_name", &Film::set_name)
      .def("number_of_frames", &Film::number_of_frames)
      .def("html", &Film::html);
}

} // namespace dsc_python
