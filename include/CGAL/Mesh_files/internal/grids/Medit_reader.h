// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_INTERNAL_GRIDS_MEDIT_READER_H
#define CGAL_MESH_FILES_INTERNAL_GRIDS_MEDIT_READER_H

#include <CGAL/Mesh_files/Mesh_entities.h>
#include <CGAL/Mesh_files/Unused_content.h>
#include <CGAL/Mesh_files/internal/grids/Merged_corners.h>
#include <CGAL/Mesh_files/internal/text/File_scanner.h>
#include <CGAL/Mesh_files/internal/text/files.h>
#include <CGAL/Mesh_files/internal/text/number_of_word.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <ostream>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The triangles of a MEDIT file: the triangles of a mesh, followed by the interface triangles that
// are not among them. Each pair of labels gets a reference of its own.
class Medit_triangles
{
public:
  using Triangle = Mesh_entities::Simplex<3>;

  // Collects the triangles. `labels` contains the two labels at each interface triangle.
  Medit_triangles(const std::vector<Triangle>& listed,
                  const std::vector<std::array<std::size_t, 3>>& interface_,
                  const std::vector<std::array<int, 2>>& labels)
      : m_triangles(listed) {
    std::vector<std::array<std::size_t, 3>> known;
    for (const Triangle& t : listed) {
      known.push_back(sorted(t.vertices));
      m_first_reference = (std::max)(m_first_reference, t.reference + 1LL);
    }
    std::sort(known.begin(), known.end());
    std::vector<std::size_t> added;
    for (std::size_t i = 0; i < interface_.size(); ++i)
      if (!std::binary_search(known.begin(), known.end(), sorted(interface_[i]))) {
        added.push_back(i);
        m_pairs.push_back(labels[i]);
      }
    std::sort(m_pairs.begin(), m_pairs.end());
    m_pairs.erase(std::unique(m_pairs.begin(), m_pairs.end()), m_pairs.end());
    for (const std::size_t i : added) {
      const auto pair = std::lower_bound(m_pairs.begin(), m_pairs.end(), labels[i]);
      m_triangles.push_back({interface_[i], reference(std::size_t(pair - m_pairs.begin()))});
    }
  }

  const std::vector<Triangle>& triangles() const { return m_triangles; }

  // Returns the pairs of labels of the added triangles, in the order of their references.
  const std::vector<std::array<int, 2>>& pairs() const { return m_pairs; }
  int reference(std::size_t pair) const {
    return static_cast<int>(m_first_reference + static_cast<long long>(pair));
  }

private:
  static std::array<std::size_t, 3> sorted(std::array<std::size_t, 3> vertices) {
    std::sort(vertices.begin(), vertices.end());
    return vertices;
  }

  std::vector<Triangle> m_triangles;
  std::vector<std::array<int, 2>> m_pairs;
  long long m_first_reference = 1;
};

template <std::size_t n>
void write_medit_simplices(std::ostream& out,
                           const std::vector<Mesh_entities::Simplex<n>>& simplices) {
  for (const auto& simplex : simplices) {
    for (const std::size_t v : simplex.vertices)
      out << v + 1 << ' ';
    out << simplex.reference << '\n';
  }
}

// Writes a section, or nothing if there are no elements.
template <std::size_t n>
void write_medit_section(std::ostream& out, const char* keyword,
                         const std::vector<Mesh_entities::Simplex<n>>& simplices) {
  if (simplices.empty())
    return;
  out << keyword << '\n' << simplices.size() << '\n';
  write_medit_simplices(out, simplices);
}

inline void write_medit_section(std::ostream& out, const char* keyword,
                                const std::vector<std::size_t>& indices) {
  if (indices.empty())
    return;
  out << keyword << '\n' << indices.size() << '\n';
  for (const std::size_t i : indices)
    out << i + 1 << '\n';
}

// A reader for tetrahedral meshes in the MEDIT text format.
class Medit_reader
{
public:
  // Creates a reader of a stream. `path` is used in messages only.
  Medit_reader(std::istream& in, const std::string& path) : m_scanner(in, path) {}

  // Reads the mesh. Throws `File_error` if the text is not as described for `IO::read_MEDIT()`.
  void read() {
    const Progress_phase phase("reading tetrahedra");
    if (!m_scanner.next() || m_scanner.word() != "MeshVersionFormatted")
      m_scanner.fail("the file does not begin with MeshVersionFormatted; is it a MEDIT text file?");
    m_scanner.number<int>();
    for (bool is_in_file = m_scanner.next(); is_in_file && m_scanner.word() != "End";) {
      if (!m_scanner.is_keyword())
        m_scanner.fail(in_quotes(m_scanner.word()) +
                       " is not expected; is the number of elements above it correct?");
      is_in_file = read_section(std::string(m_scanner.word()));
    }
    check();
  }

  // Returns the points, with three coordinates each.
  const std::vector<std::array<double, 3>>& points() const { return m_points; }
  std::vector<std::array<std::size_t, 4>>& tetrahedra() { return m_tetrahedra; }
  std::vector<int>& labels() { return m_labels; }
  Mesh_entities& entities() { return m_entities; }
  const Unused_content& unused() const { return m_unused; }

private:
  // The largest index of a kind of element that is referred to. The element must exist at the end
  // of the file.
  struct Largest_index
  {
    std::size_t index = 0, line = 0;
  };

  // Reads a section and moves to the keyword of the next one. Returns false if there is none.
  bool read_section(const std::string& keyword) {
    Mesh_entities& e = m_entities;
    if (keyword == "Dimension") {
      if (m_scanner.number<int>() != 3)
        m_scanner.fail("the dimension must be 3; choose a mesh of tetrahedra");
      return m_scanner.next();
    }
    if (keyword == "Vertices")
      return read_elements([&] { read_vertex(); });
    if (keyword == "Tetrahedra")
      return read_elements([&] {
        m_tetrahedra.push_back(read_indices<4>());
        m_labels.push_back(read_reference("the label of a tetrahedron"));
      });
    if (keyword == "Triangles")
      return read_elements([&] { e.triangles.push_back(read_simplex<3>()); });
    if (keyword == "Edges")
      return read_elements([&] { e.edges.push_back(read_simplex<2>()); });
    for (const auto& [name, list, largest] :
         {List{"Corners", &e.corners, &m_vertex},
          List{"RequiredVertices", &e.required_vertices, &m_vertex},
          List{"Ridges", &e.ridges, &m_edge}, List{"RequiredEdges", &e.required_edges, &m_edge},
          List{"RequiredTriangles", &e.required_triangles, &m_triangle}})
      if (keyword == name)
        return read_elements(
            [&, to = list, bound = largest] { to->push_back(read_index(*bound)); });
    return skip_section(keyword);
  }

  struct List
  {
    const char* name;
    std::vector<std::size_t>* list;
    Largest_index* largest;
  };

  template <class Read> bool read_elements(const Read& read) {
    static constexpr std::size_t between_checks = 1 << 10;
    for (std::size_t n = m_scanner.number<std::size_t>(); n > 0; --n) {
      read();
      if (n % between_checks == 0)
        Progress_scope::check();
    }
    return m_scanner.next();
  }

  // Skips a section that is not used. Throws `File_error` if the section contains other cells of
  // dimension 3, because the result would have gaps without them.
  bool skip_section(const std::string& keyword) {
    std::size_t number = 1;
    bool is_in_file = m_scanner.next();
    if (is_in_file && !m_scanner.is_keyword()) {
      number = number_of_word<std::size_t>(m_scanner.word()).value_or(1);
      const bool fills_space =
          starts_with(keyword, "Hexa") || starts_with(keyword, "Pri") ||
          starts_with(keyword, "Penta") || starts_with(keyword, "Pyramid") ||
          starts_with(keyword, "Wedges") ||
          (starts_with(keyword, "TetrahedraP") && keyword.find("Ordering") == keyword.npos);
      if (fills_space && number > 0)
        m_scanner.fail("there are " + std::to_string(number) + " elements of " +
                       in_quotes(keyword) + "; divide them into tetrahedra or remove them");
      while ((is_in_file = m_scanner.next()) && !m_scanner.is_keyword())
        continue;
    }
    m_unused.add("elements of " + keyword, number);
    return is_in_file;
  }

  static bool starts_with(std::string_view text, std::string_view start) {
    return text.substr(0, start.size()) == start;
  }

  void read_vertex() {
    std::array<double, 3> point;
    for (double& x : point) {
      x = m_scanner.number<double>();
      if (!std::isfinite(x))
        m_scanner.fail("a coordinate is not a finite number; correct it");
    }
    m_points.push_back(point);
    m_entities.vertex_references.push_back(read_reference("the reference of a vertex"));
  }

  template <std::size_t n> std::array<std::size_t, n> read_indices() {
    std::array<std::size_t, n> result;
    for (std::size_t& index : result)
      index = read_index(m_vertex);
    return result;
  }

  template <std::size_t n> Mesh_entities::Simplex<n> read_simplex() {
    const auto vertices = read_indices<n>();
    return {vertices, read_reference("a reference")};
  }

  int read_reference(const char* name) {
    const auto value = m_scanner.number<double>();
    using Limits = std::numeric_limits<int>;
    if (!(Limits::min() <= value && value <= Limits::max()) || value != std::trunc(value))
      m_scanner.fail(in_quotes(m_scanner.word()) + " is not a 32-bit integer and cannot be " +
                     name + "; choose one from " + std::to_string(Limits::min()) + " to " +
                     std::to_string(Limits::max()));
    return static_cast<int>(value);
  }

  // Returns a zero-based index. The element that it refers to may come later in the file.
  std::size_t read_index(Largest_index& largest) {
    const std::size_t index = m_scanner.number<std::size_t>();
    if (index == 0)
      m_scanner.fail("indices start from 1; correct the 0");
    if (index > largest.index)
      largest = {index, m_scanner.line_number()};
    return index - 1;
  }

  void check() {
    if (m_tetrahedra.empty())
      m_scanner.fail("there are no tetrahedra; choose a mesh with tetrahedra");
    require(m_vertex, m_points.size(), "vertex");
    require(m_edge, m_entities.edges.size(), "edge");
    require(m_triangle, m_entities.triangles.size(), "triangle");
    merge_points();
    auto& references = m_entities.vertex_references;
    if (std::all_of(references.begin(), references.end(), [](int r) { return r == 0; }))
      references.clear();
  }

  // Merges equal points, and removes the references of vertices if they differ there.
  void merge_points() {
    const Merged_corners merged(m_points, m_tetrahedra);
    if (!merged.has_repeated_points())
      return;
    Mesh_entities& e = m_entities;
    m_points = merged.selected(m_points);
    if (merged.agree(e.vertex_references)) {
      e.vertex_references = merged.selected(e.vertex_references);
    } else {
      m_unused.add("vertex references, which differ at equal points", e.vertex_references.size());
      e.vertex_references.clear();
    }
    for (auto& triangle : e.triangles)
      merged.renumber(triangle.vertices);
    for (auto& edge : e.edges)
      merged.renumber(edge.vertices);
    for (auto* vertices : {&e.corners, &e.required_vertices}) {
      merged.renumber(*vertices);
      std::sort(vertices->begin(), vertices->end());
      vertices->erase(std::unique(vertices->begin(), vertices->end()), vertices->end());
    }
  }

  void require(const Largest_index& largest, std::size_t size, const char* name) const {
    if (largest.index > size)
      m_scanner.fail(std::string("there is no ") + name + ' ' + std::to_string(largest.index) +
                         "; correct the index",
                     largest.line);
  }

  File_scanner m_scanner;
  std::vector<std::array<double, 3>> m_points;
  std::vector<std::array<std::size_t, 4>> m_tetrahedra;
  std::vector<int> m_labels;
  Mesh_entities m_entities;
  Unused_content m_unused;
  Largest_index m_vertex, m_edge, m_triangle;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_GRIDS_MEDIT_READER_H
