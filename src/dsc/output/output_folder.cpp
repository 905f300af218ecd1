// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/output_folder.h"

#include "input/files.h"
#include "programs/errors.h"

#include <CGAL/Mesh_files/internal/text/Xml_element.h>
#include <CGAL/Mesh_files/internal/text/files.h>
#include <CGAL/Mesh_files/internal/text/number_of_word.h>

namespace dsc {
namespace fs = std::filesystem;
namespace {

/// Returns the existing files of a collection of an earlier run, up to `time`.
std::vector<Moment> moments_until(double time, const std::string& collection) {
  std::vector<Moment> moments;
  for (Moment& moment : moments_of_collection(collection))
    if (moment.first <= time && exists(moment.second))
      moments.push_back(std::move(moment));
  return moments;
}

std::string numbered(const char* format, unsigned step) {
  char name[40];
  std::snprintf(name, sizeof name, format, step);
  return name;
}

namespace internal = DSC::internal;
using internal::Xml_element;

/// Replaces the references of XML to characters.
std::string unescaped(std::string text) {
  static constexpr const char* references[][2] = {
      {"&quot;", "\""}, {"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}};
  for (const auto& [reference, character] : references)
    for (std::size_t i = 0; (i = text.find(reference, i)) != text.npos; ++i)
      text.replace(i, std::string_view(reference).size(), character);
  return text;
}

} // namespace

Output_folder::Output_folder(const std::string& path, int subdivisions)
    : m_path(path), m_subdivisions(subdivisions), m_volume(file("volume.pvd")),
      m_interface(file("interface.pvd")) {}

void Output_folder::claim(const std::string& resume) {
  m_claim.emplace(m_path);
  if (exists(checkpoint()) && !is_same_file(checkpoint(), resume))
    throw Input_error("the folder '" + m_path +
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

void Output_folder::save(const Tracked_complex& complex, const Run_position& position,
                         const std::string& metadata) {
  if (complex.agreed(position.time > m_checkpoint_time) == 0)
    return;
  require(complex);
  complex.write_checkpoint(checkpoint(), metadata);
  m_checkpoint_time = position.time;
}

void Output_folder::write(const Tracked_complex& complex, const Run_position& position) {
  if (complex.agreed(position.time > m_last_time) == 0)
    return;
  require(complex);
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

void Output_folder::require(const Tracked_complex& complex) const {
  complex.run_once([&] { m_claim->require(); });
}

std::string Output_folder::checkpoint() const { return file("checkpoint.dsc"); }

std::string Output_folder::file(const std::string& name) const {
  return (fs::path(m_path) / name).string();
}

std::string save_run(std::optional<Output_folder>& folder, const std::string& stem,
                     const Tracked_complex& complex, const Run_position& position,
                     const std::string& metadata) {
  if (folder)
    try {
      folder->require(complex); // it can have been removed after the checkpoint was written
      folder->save(complex, position, metadata);
      folder->require(complex); // another process can be removing it
      return folder->checkpoint();
    } catch (const std::runtime_error&) { // the other place may do
    }
  std::string result;
  complex.run_once([&] { result = new_file(stem, ".dsc"); });
  try {
    complex.write_checkpoint(result, metadata);
  } catch (...) {
    complex.run_once([&] { remove_file(result); });
    throw;
  }
  return result;
}

std::string message_after_saving(const std::exception& error, unsigned step,
                                 const std::function<std::string()>& save,
                                 const std::function<void()>& write_report) {
  std::string message = error_message(error);
  try {
    if (const std::string checkpoint = save(); !checkpoint.empty())
      message += "; the state after step " + std::to_string(step) + " is in " + checkpoint;
    write_report();
  } catch (const std::exception& second) {
    if (const std::string text = error_message(second); message.find(text) == std::string::npos)
      message += "; " + text;
  }
  return message;
}

std::vector<Moment> moments_of_collection(const std::string& collection) {
  std::vector<Moment> moments;
  if (!exists(collection))
    return moments;
  const std::string bytes = internal::file_contents(collection);
  for_each_child(Xml_element{"", "", bytes}, "VTKFile", collection, [&](const Xml_element& file) {
    for_each_child(file, "Collection", collection, [&](const Xml_element& list) {
      for_each_child(list, "DataSet", collection, [&](const Xml_element& entry) {
        const auto time = internal::number_of_word<double>(entry.attribute("timestep"));
        const std::string name = unescaped(entry.attribute("file"));
        if (!time || !std::isfinite(*time) || name.empty())
          throw Input_error("an entry of '" + collection +
                            "' has no file or no finite time; correct it");
        moments.emplace_back(*time, (fs::path(collection).parent_path() / name).string());
      });
    });
  });
  return moments;
}

} // namespace dsc
