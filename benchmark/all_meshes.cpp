// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Builds a complex from a surface and rotates it slightly, or prints the reason why this fails.
// Prints a row of a table for each file, without the table head.

#include "inputs.h"
#include "measures.h"

#include <CGAL/Complex_construction/Tetrahedralization_3.h>
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/interface_flows_3.h>
#include <CGAL/Mesh_files/File_error.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>
#include <CGAL/Triangle_soup_repair/Invalid_surface_error.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc_benchmark {
namespace {

using CGAL::Deformable_simplicial_complexes::Error;
using CGAL::Deformable_simplicial_complexes::File_error;
using CGAL::Deformable_simplicial_complexes::Invalid_surface_error;
using CGAL::Deformable_simplicial_complexes::Tetrahedralization_error;
namespace parameters = CGAL::parameters;

const char* name(Invalid_surface_error::Reason reason) {
  using Reason = Invalid_surface_error::Reason;
  switch (reason) {
  case Reason::empty:
    return "empty";
  case Reason::not_finite:
    return "not_finite";
  case Reason::bad_index:
    return "bad_index";
  case Reason::degenerate_facet:
    return "degenerate_facet";
  case Reason::open:
    return "open";
  case Reason::non_manifold_edge:
    return "non_manifold_edge";
  case Reason::self_intersection:
    return "self_intersection";
  case Reason::crossing_surfaces:
    return "crossing_surfaces";
  case Reason::too_fine:
    return "too_fine";
  case Reason::outside_enclosing_box:
    return "outside_enclosing_box";
  case Reason::contradicting_sides:
    return "contradicting_sides";
  }
  return "unknown";
}

// Returns the message of an exception in a form that fits into a table.
std::string refusal(const std::string& reason, std::string text) {
  for (char& c : text)
    c = c == '|' || c == '\n' ? ' ' : c;
  return "refused: " + reason + ": " + text;
}

class Row
{
public:
  explicit Row(const std::string& path)
      : m_path(path), m_file(std::filesystem::path(path).filename().string()) {}

  // Returns whether the surface rotates or is rejected with a reason.
  bool fill() {
    try {
      rotate();
      return m_outcome == "rotates";
    } catch (const Invalid_surface_error& error) {
      m_outcome = refusal(name(error.reason()), error.what());
    } catch (const Tetrahedralization_error& error) {
      m_outcome = refusal("tetrahedralization", error.what());
    } catch (const File_error& error) {
      m_outcome = refusal("file", m_file + std::string(error.what()).substr(m_path.size()));
    } catch (const Error& error) {
      m_outcome = refusal("other", error.what());
    } catch (const std::exception& error) {
      m_outcome = "**failed**: not an error of the package";
      std::cerr << m_file << ": " << error.what() << '\n';
      return false;
    }
    return true;
  }

  void print() const {
    std::cout << "| " << m_file << " | " << m_triangles << " | " << m_outcome << " | "
              << m_tetrahedra << " | " << m_seconds << " | " << m_incomplete_steps << " |"
              << std::endl;
  }

private:
  void rotate() {
    static constexpr int number_of_steps = 10;
    Surface surface = read_input(m_path, 0);
    m_triangles = std::to_string(surface.triangles.size());
    const double start = processor_seconds();
    Complex complex = DSC::make_deformable_simplicial_complex_3<Complex>(
        std::vector<Surface>{std::move(surface)}, CGAL::Tetgen_tetrahedralizer_3(),
        parameters::normalize(true));
    m_tetrahedra = std::to_string(complex.number_of_cells());

    // The box is centered at the origin.
    const DSC::Rigid_rotation_3 rotation(Point(0, 0, 0), Vector(0, 0, 1), 2 * degree);
    int incomplete_steps = 0, invalid_steps = 0;
    double seconds = processor_seconds() - start;
    for (int step = 0; step < number_of_steps; ++step) {
      const double start_of_step = processor_seconds();
      incomplete_steps += !DSC::advect_interface(complex, rotation, step, 1.).complete;
      seconds += processor_seconds() - start_of_step;
      invalid_steps += !check(complex);
    }
    m_seconds = std::to_string(seconds);
    m_incomplete_steps = std::to_string(incomplete_steps);
    m_outcome = invalid_steps == 0 ? "rotates" : "**invalid**";
  }

  std::string m_path, m_file, m_outcome;
  std::string m_triangles = "–", m_tetrahedra = "–", m_seconds = "–", m_incomplete_steps = "–";
};

} // namespace
} // namespace dsc_benchmark

int main(int argc, char** argv) {
  bool is_good = true;
  for (int i = 1; i < argc; ++i) {
    dsc_benchmark::Row row(argv[i]);
    is_good = row.fill() && is_good;
    row.print();
  }
  return is_good ? EXIT_SUCCESS : EXIT_FAILURE;
}
