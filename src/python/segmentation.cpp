// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Complex_object.h"
#include "Space.h"
#include "module.h"
#include "options.h"

#include <CGAL/Image_segmentation/compiled_2.h>
#include <CGAL/Image_segmentation/compiled_3.h>

namespace dsc_python {
namespace {

namespace DSC = CGAL::Deformable_simplicial_complexes;

/// Returns an image.
/// \param channels values of each channel, the first axis fastest
/// \param mask 0 for pixels that do not count; empty for none
template <int d>
DSC::Gray_image<d> image_of(const std::vector<Array<float>>& channels,
                            const Array<std::uint8_t>& mask, const std::array<std::size_t, d>& size,
                            const std::array<double, d>& spacing,
                            const std::array<double, d>& origin) {
  DSC::Gray_image<d> result;
  result.grid = {size, spacing, origin};
  for (const auto& channel : channels)
    result.channels.emplace_back(channel.data(), channel.data() + channel.size());
  result.mask.assign(mask.data(), mask.data() + mask.size());
  return result;
}

template <int d> DSC::Segmentation_options<d> options_of(const py::dict& options) {
  DSC::Segmentation_options<d> result;
  Options rest(options);
  rest.read("phases", result.phases);
  rest.read("intensities", result.intensities);
  rest.read("noise", result.noise);
  rest.read("smoothing", result.smoothing);
  rest.read("longest_edge", result.longest_edge);
  rest.read("shortest_edge", result.shortest_edge);
  rest.read("keep_topology", result.keeps_topology);
  rest.read("connected", result.connected);
  rest.read("threads", result.number_of_threads);
  rest.require_all_read();
  return result;
}

py::dict report_to_dict(const DSC::Segmentation_report& report) {
  py::list phases, boundaries;
  for (const auto& phase : report.phases) {
    py::dict entry;
    entry["label"] = phase.label;
    entry["intensities"] = phase.intensities;
    entry["pixels"] = phase.measure;
    entry["components"] = phase.components;
    phases.append(entry);
  }
  for (const auto& boundary : report.boundaries) {
    py::dict entry;
    entry["labels"] = py::make_tuple(boundary.a, boundary.b);
    entry["measure"] = boundary.measure;
    entry["uncertainty"] = boundary.uncertainty;
    boundaries.append(entry);
  }
  py::dict result;
  result["phases"] = phases;
  result["boundaries"] = boundaries;
  result["noise"] = report.noise;
  result["smoothing"] = report.smoothing;
  result["energies"] = report.energies;
  result["residual"] = report.residual;
  result["converged"] = report.has_converged;
  return result;
}

/// \param start complex to begin with; None for a new one
template <class Complex>
py::tuple segment(const std::vector<Array<float>>& channels, const Array<std::uint8_t>& mask,
                  const std::array<std::size_t, Complex::dimension>& size,
                  const std::array<double, Complex::dimension>& spacing,
                  const std::array<double, Complex::dimension>& origin, const py::object& start,
                  const py::dict& options, const py::object& progress) {
  static constexpr int d = Complex::dimension;
  const auto image = image_of<d>(channels, mask, size, spacing, origin);
  const auto segmentation = options_of<d>(options);
  DSC::Segmentation_report report;
  std::unique_ptr<Complex_object<Complex>> result;
  std::optional<Complex> complex;
  if (!start.is_none())
    complex.emplace(start.cast<Complex_object<Complex>&>().read());
  {
    const Long_function function(progress);
    if (complex)
      report = DSC::segment_image(*complex, image, segmentation);
    else
      std::tie(complex, report) = DSC::segment_image<Complex>(image, segmentation);
    result = std::make_unique<Complex_object<Complex>>(std::move(*complex));
  }
  return py::make_tuple(py::cast(std::move(result)), report_to_dict(report));
}

} // namespace

void bind_segmentation(py::module_& module) {
  module.def("segment_2", &segment<CGAL::Deformable_simplicial_complex_2<>>);
  module.def("segment_3", &segment<CGAL::Deformable_simplicial_complex_3<>>);
}

} // namespace dsc_python
