// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/output_folder.h"

#include "input/files.h"
#include "output/collection.h"
#include "programs/errors.h"

#include <cstdio>
#include <filesystem>
#include <utility>
#include <vector>

namespace dsc {
namespace fs = std::filesystem;
namespace {

/// Returns the existing files of a collection of an earlier run, up to `time`.
std::vector<Moment> moments_until(double time, const std::string& collection) {
  std::vector<Moment> moments;
  for (Moment& moment : moments_of_collection(collection)) {
    std::error_code error;
    if (moment.first <= time && fs::exists(moment.second, error))
      moments.push_back(std::move(moment));
  }
  return moments;
}

std::string numbered(const char* format, unsigned step) {
  char name[40];
  std::snprintf(name, sizeof name, format, step);
  return name;
}

} // namespace

Output_folder::Output_folder(const std::string& path, const std::string& resume, int subdivisions)
    : m_path(path), m_subdivisions(subdivisions), m_volume(file("volume.pvd")),
      m_interface(file("interface.pvd")) {
  create_folder(path);
  require_writable(checkpoint());
  std::error_code error;
  if (fs::exists(checkpoint(), error) && !fs::equivalent(checkpoint(), resume, error))
    throw Input_error("the folder '" + path +
                      "' contains the results of another run; choose another "
                      "folder, or continue that run with --resume " +
                      checkpoint());
}

void Output_folder::keep_until(double time) {
  for (CGAL::IO::PVD_series* series : {&m_volume, &m_interface}) {
    const std::vector<Moment> moments = moments_until(time, series->path());
    if (!moments.empty()) {
      series->append(moments);
      m_last_time = moments.back().first;
    }
  }
}

void Output_folder::write(const Tracked_complex& complex, const Run_position& position,
                          const std::string& metadata) {
  if (complex.agreed(position.time > m_last_time) > 0) {
    const std::string extension = complex.grid_extension();
    const std::string volume = file(numbered("volume_%06u", position.step) + extension);
    const std::string interface = file(numbered("interface_%06u", position.step) + extension);
    complex.write_volume_vtu(volume);
    complex.write_interface_vtu(interface);
    complex.write_picture(file(numbered("picture_%06u", position.step)));
    if (m_subdivisions > 0)
      complex.write_subdivided(file(numbered("smooth_%06u.ply", position.step)), m_subdivisions);
    complex.run_once([&] {
      m_volume.append(position.time, volume);
      m_interface.append(position.time, interface);
    });
    m_last_time = position.time;
  }
  if (complex.agreed(!holds(position)) > 0) {
    complex.write_checkpoint(checkpoint(), metadata);
    m_checkpoint_time = position.time;
  }
}

std::string Output_folder::checkpoint() const { return file("checkpoint.dsc"); }

std::string Output_folder::file(const std::string& name) const {
  return (fs::path(m_path) / name).string();
}

} // namespace dsc
