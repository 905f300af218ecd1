// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluids/fluid_files.h"

#include "input/files.h"
#include "input/surface.h"
#include "programs/errors.h"

#include <cstdint>
#include <filesystem>
#include <utility>
#include <vector>

namespace dsc {

std::string place_of(const std::string& file, const std::string& folder) {
  const std::filesystem::path path(file);
  return path.is_absolute() || folder.empty() ? file
                                              : (std::filesystem::path(folder) / path).string();
}

void require_files(const Fluid_scene& scene, const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& filling : shapes_of(scene))
    if (const auto* shape = std::get_if<File_shape>(filling.second))
      files.push_back(shape->file);
  for (const Scene_solid& solid : scene.solids)
    if (solid.kind == Scene_solid::Kind::mesh)
      files.push_back(solid.file);
  if (files.empty() && !folder.empty())
    throw Usage_error("--data has no effect because the scene names no files; leave it out");
  for (const std::string& file : files)
    if (const std::string place = place_of(file, folder); !exists(place))
      throw Input_error("the file '" + place +
                        "' of the scene does not exist; give its folder by --data");
}

void read_meshes(const std::string& folder, Fluid_scene& scene) {
  for (Scene_solid& solid : scene.solids) {
    if (solid.kind != Scene_solid::Kind::mesh)
      continue;
    Scene_solid::Mesh mesh;
    const Surface surface = read_part(place_of(solid.file, folder), solid.part);
    for (const Surface_point& p : surface.points)
      mesh.add_vertex({p.x(), p.y(), p.z()});
    for (const auto& t : surface.triangles)
      mesh.add_face(CGAL::SM_Vertex_index(std::uint32_t(t[0])),
                    CGAL::SM_Vertex_index(std::uint32_t(t[1])),
                    CGAL::SM_Vertex_index(std::uint32_t(t[2])));
    solid.set_mesh(std::move(mesh));
  }
}

} // namespace dsc
