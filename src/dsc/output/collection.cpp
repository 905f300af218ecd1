// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/collection.h"

#include "programs/errors.h"

#include <CGAL/Mesh_files/internal/text/Xml_element.h>
#include <CGAL/Mesh_files/internal/text/files.h>
#include <CGAL/Mesh_files/internal/text/number_of_word.h>

#include <cmath>
#include <filesystem>
#include <string_view>

namespace dsc {
namespace {

namespace internal = CGAL::Deformable_simplicial_complexes::internal;
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

std::vector<Moment> moments_of_collection(const std::string& collection) {
  namespace fs = std::filesystem;
  std::vector<Moment> moments;
  std::error_code error;
  if (!fs::exists(collection, error))
    return moments;
  const std::string bytes = internal::file_contents(collection);
  const auto visit = [&](const Xml_element& entry) {
    const auto time = internal::number_of_word<double>(entry.attribute("timestep"));
    const std::string name = unescaped(entry.attribute("file"));
    if (!time || !std::isfinite(*time) || name.empty())
      throw Input_error("an entry of '" + collection +
                        "' has no file or no finite time; correct it");
    moments.emplace_back(*time, (fs::path(collection).parent_path() / name).string());
  };
  internal::for_each_xml_element(bytes, "VTKFile", collection, [&](const Xml_element& file) {
    internal::for_each_xml_element(file.content, "Collection", collection, [&](const auto& list) {
      internal::for_each_xml_element(list.content, "DataSet", collection, visit);
    });
  });
  return moments;
}

} // namespace dsc
