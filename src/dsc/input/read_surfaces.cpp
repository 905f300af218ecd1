// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/surface.h"
#include "input/translations.h"
#include "output/label_titles.h"
#include "programs/errors.h"

#include <CGAL/Mesh_files/Surface_parts.h>
#include <CGAL/Mesh_files/labeled_surface_3.h>

namespace dsc {
namespace {

/// Returns the surfaces of a file and sets the names of its parts.
/// \param has_parts whether names divide the surface
std::vector<Surface> parts_of_file(const std::string& path, bool has_parts, int first_label,
                                   std::vector<std::string>& names) {
  DSC::Surface_parts parts;
  Surface whole = read_surface(path, has_parts ? &parts : nullptr);
  whole.label = first_label;
  if (!has_parts)
    parts = {{""}, {}};
  std::vector<Surface> result = DSC::separate_parts(whole, parts);
  if (result.size() < parts.names.size()) {
    for (std::string& name : parts.names)
      name = "'" + name + "'";
    print_note(path, "the parts " + listed(parts.names) +
                         " do not bound solids by themselves and are read as one surface");
    parts.names = {""};
  }
  names = std::move(parts.names);
  return result;
}

} // namespace

Surfaces read_surfaces(const Run_start& start) {
  Surfaces result;
  DSC::internal::Label_name_list labels;
  for (const std::string& path : start.inputs) {
    const std::string file = with_user_names(path);
    std::vector<std::string> names;
    std::vector<Surface> parts =
        parts_of_file(path, start.labels != "none", int(result.all.size()) + 1, names);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      labels.add(parts[i].label, names[i]);
      const std::string name = label_name(parts[i].label, labels.names);
      const std::string part = name.empty() ? "part without name" : "part '" + name + "'";
      result.titles.push_back(printed_line(parts.size() == 1 ? file : file + ", " + part));
      result.all.push_back(std::move(parts[i]));
    }
  }
  result.names = std::move(labels.names);
  return result;
}

Surface read_part(const std::string& path, const std::string& name) {
  if (name.empty())
    return read_surface(path);
  std::vector<std::string> names;
  std::vector<Surface> parts = parts_of_file(path, true, 1, names);
  const auto found = std::find(names.begin(), names.end(), name);
  const bool has_names =
      std::any_of(names.begin(), names.end(), [](const auto& n) { return !n.empty(); });
  if (found == names.end())
    throw Input_error(path + ": no part has the name '" + name + "'; " +
                      (has_names
                           ? "its parts are " + listed(names)
                           : std::string("leave out the name, which gives the whole surface")));
  Surface& part = parts[std::size_t(found - names.begin())];
  part.label = 1;
  return std::move(part);
}

Surface read_surface(const std::string& path, DSC::Surface_parts* parts) {
  Unused_content unused;
  Surface result = CGAL::IO::read_labeled_surface<Surface_point>(path, 1, &unused, parts);
  print_unused(path, unused);
  static constexpr double largest = 1e90; // of which volumes have a cube that is a number
  for (const Surface_point& p : result.points)
    if ((std::max)({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())}) > largest)
      throw Input_error(path +
                        " has coordinates greater than 1e90, so that its volume is no number; "
                        "scale it");
  return result;
}

} // namespace dsc
