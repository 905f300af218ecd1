// Labels that decrease an energy of cells, and bisection of selected cells.
#include "planar_regions.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Image_segmentation/internal/segmentation/relabel_by_energy.h>
#include <CGAL/Interface_remeshing/Cell_snapshot.h>
#include <CGAL/Interface_remeshing/refine_cells.h>

namespace test_energies_of_cells {

using planar_regions::Complex;

// Returns the square [0, n]^2 of n^2 unit squares, each of two triangles.
template <class Label_at> Complex squares(std::size_t n, const Label_at& label_at) {
  return planar_regions::grid(
      n, n, [](std::size_t i, std::size_t j) { return Complex::Point_2(double(i), double(j)); },
      label_at);
}

// An energy of the label 1 relative to that of 0, by the middle of a triangle.
template <class Gain> auto energy_of(const Complex& complex, const Gain& gain) {
  return [&complex, gain](Complex::Cell_handle c, int label) {
    const auto p = complex.corner(c, 0), q = complex.corner(c, 1), r = complex.corner(c, 2);
    return label == 1 ? -gain((p.x() + q.x() + r.x()) / 3, (p.y() + q.y() + r.y()) / 3) *
                            complex.measure(c)
                      : 0.;
  };
}

// Returns the energy of a complex by its definition.
template <class Energy> double total(const Complex& complex, const Energy& energy, double tension) {
  double result = 0;
  for (auto c : complex.cells())
    result += energy(c, c->subdomain_index());
  for (const auto& f : complex.interface_facets())
    result += tension * complex.measure(f);
  return result;
}

// No label of a single cell decreases the energy any more, and the square of the image is found.
TEST(Relabel_by_energy, ends_in_a_local_minimum) {
  Complex complex = squares(8, [](std::size_t, std::size_t) { return 0; });
  const auto energy = energy_of(
      complex, [](double x, double y) { return x > 2 && x < 6 && y > 2 && y < 6 ? 10. : -10.; });
  DSC::Relabeling_options<Complex> options;
  EXPECT_EQ(DSC::relabel_by_energy(complex, energy, options), 0u); // no neighbor has another label
  options.labels = {0, 1};
  EXPECT_EQ(DSC::relabel_by_energy(complex, energy, options), 32u);
  EXPECT_DOUBLE_EQ(complex.area(1), 16);
  EXPECT_TRUE(complex.is_valid());
  const double least = total(complex, energy, 1);
  for (auto c : complex.cells()) {
    const int label = c->subdomain_index();
    complex.relabel(c, 1 - label);
    EXPECT_GT(total(complex, energy, 1), least);
    complex.relabel(c, label);
  }
}

TEST(Relabel_by_energy, weighs_the_interface) {
  for (const double tension : {1., 10.}) {
    Complex complex = squares(8, [](std::size_t, std::size_t) { return 0; });
    const auto energy = energy_of(
        complex, [](double x, double y) { return std::hypot(x - 4, y - 4) < .7 ? 9. : -9.; });
    DSC::Relabeling_options<Complex> options;
    options.labels = {0, 1};
    options.interface_energy.set_tension(tension);
    DSC::relabel_by_energy(complex, energy, options);
    EXPECT_EQ(complex.area(1) > 0, tension < 5);
  }
}

// A bridge between two regions is not removed if the topology must stay.
TEST(Relabel_by_energy, asks_before_the_topology_changes) {
  for (const bool allows : {false, true}) {
    Complex complex = squares(7, [](std::size_t i, std::size_t j) {
      return j > 1 && j < 5 && (i < 3 || i > 3 || j == 3) ? 1 : 0;
    });
    const auto energy = energy_of(complex, [](double x, double y) {
      return x > 3 && x < 4 ? -9. : y > 2 && y < 5 ? 9. : -9.;
    });
    unsigned questions = 0;
    DSC::Relabeling_options<Complex> options;
    options.topology_control = [&](const Complex&, Complex::Cell_handle, int) {
      ++questions;
      return allows;
    };
    ASSERT_EQ(complex.number_of_components(1), 1u);
    DSC::relabel_by_energy(complex, energy, options);
    EXPECT_GT(questions, 0u);
    EXPECT_EQ(complex.number_of_components(1), allows ? 2u : 1u);
  }
}

// Cell by cell, a square of 2 x 2 cannot vanish; as a whole, it can.
TEST(Relabel_by_energy, changes_whole_components) {
  const auto label_at = [](std::size_t i, std::size_t j) {
    return i >= 2 && i < 4 && j >= 2 && j < 4 ? 1 : 0;
  };
  const auto gain = [](double, double) { return 1.9; }; // less than the perimeter over the area
  Complex complex = squares(6, label_at);
  const auto outside = [&](double x, double y) {
    return label_at(std::size_t(x), std::size_t(y)) == 1 ? gain(x, y) : -9;
  };
  DSC::Relabeling_options<Complex> options;
  EXPECT_EQ(DSC::relabel_by_energy(complex, energy_of(complex, outside), options), 0u);
  EXPECT_EQ(DSC::relabel_components_by_energy(complex, energy_of(complex, outside), options), 1u);
  EXPECT_EQ(complex.labels(), std::vector<int>{0});
  // A control that forbids the change
  complex = squares(6, label_at);
  options.topology_control = [](const Complex&, Complex::Cell_handle, int) { return false; };
  EXPECT_EQ(DSC::relabel_components_by_energy(complex, energy_of(complex, outside), options), 0u);
}

// The boundary of two components that become one does not count twice.
TEST(Relabel_by_energy, counts_neighbors_that_changed_before) {
  Complex complex = squares(6, [](std::size_t i, std::size_t j) {
    return j < 2 || j > 3 || i < 1 || i > 4 ? 0 : i < 3 ? 2 : 3;
  });
  // Both prefer the label 1, but their common boundary has no energy only if both get it.
  const auto energy = [&](Complex::Cell_handle c, int label) {
    const bool is_inside = c->subdomain_index() > 1 || label > 1 || label == 1;
    return is_inside ? (label == 1 ? -.5 : 0) * complex.measure(c) : 0.;
  };
  DSC::Relabeling_options<Complex> options;
  options.labels = {1, 2, 3};
  DSC::relabel_components_by_energy(complex, energy, options);
  EXPECT_EQ(complex.labels(), std::vector<int>{1});
  EXPECT_TRUE(complex.interface_facets().empty());
}

TEST(Refine_cells, bisects_the_selected_cells_and_keeps_shapes) {
  Complex complex = squares(4, [](std::size_t i, std::size_t) { return i < 2 ? 1 : 2; });
  const auto near_corner = [&](double size) {
    return [&complex, size](Complex::Cell_handle c) {
      const auto p = complex.corner(c, 0);
      return complex.measure(c) > size && std::hypot(p.x(), p.y()) < 1.5;
    };
  };
  std::size_t splits = 0;
  for (std::size_t done = 1; done > 0; splits += done)
    done = DSC::refine_cells(complex, near_corner(.01));
  EXPECT_GT(splits, 20u);
  EXPECT_TRUE(complex.is_valid());
  double worst = 1;
  for (auto c : complex.cells()) {
    EXPECT_FALSE(near_corner(.01)(c));
    worst = (std::min)(worst, c->quality());
  }
  const double right_isosceles =
      squares(1, [](std::size_t, std::size_t) { return 0; }).cells().front()->quality();
  EXPECT_NEAR(worst, right_isosceles, 1e-9); // bisection reproduces this shape
  EXPECT_DOUBLE_EQ(complex.area(1), 8);
  EXPECT_DOUBLE_EQ(complex.area(2), 8);
  for (const auto& f : complex.interface_facets()) // a straight interface
    for (auto v : complex.facet_vertices(f))
      EXPECT_EQ(complex.position(v).x(), 2);
}

TEST(Refine_cells, does_nothing_if_nothing_is_selected) {
  Complex complex = squares(2, [](std::size_t, std::size_t) { return 0; });
  const auto version = complex.version();
  EXPECT_EQ(DSC::refine_cells(complex, [](Complex::Cell_handle) { return false; }), 0u);
  EXPECT_EQ(complex.version(), version);
  Complex empty;
  EXPECT_EQ(DSC::refine_cells(empty, [](Complex::Cell_handle) { return true; }), 0u);
}

// Cells that are new, have another label, or have a corner at another place.
TEST(Cell_snapshot, finds_changed_cells) {
  Complex complex = squares(8, [](std::size_t i, std::size_t) { return i < 4 ? 1 : 0; });
  const DSC::Cell_snapshot<Complex> before(complex);
  EXPECT_TRUE(before.changed_cells(complex).empty());
  const auto first = complex.cells().front();
  complex.relabel(first, 3);
  EXPECT_EQ(before.changed_cells(complex), std::vector<Complex::Cell_handle>{first});
  complex.relabel(first, 1);
  EXPECT_TRUE(before.changed_cells(complex).empty());

  // A motion of the interface and new cells. Measures of all other cells are the same.
  std::map<std::size_t, double> areas;
  for (auto c : complex.cells())
    areas.emplace(c->time_stamp(), complex.measure(c));
  const auto n = complex.number_of_cells();
  DSC::refine_cells(complex, [&](Complex::Cell_handle c) { return c == first; });
  ASSERT_GT(complex.number_of_cells(), n);
  DSC::deform_interface(complex, [&](Complex::Vertex_handle v) {
    const auto p = complex.position(v);
    return Complex::Point_2(p.x() + (p.y() > 6 ? .1 : 0), p.y());
  });
  const auto changed = before.changed_cells(complex);
  std::size_t same = 0;
  for (auto c : complex.cells())
    if (std::find(changed.begin(), changed.end(), c) == changed.end()) {
      EXPECT_EQ(areas.at(c->time_stamp()), complex.measure(c));
      ++same;
    }
  EXPECT_GT(same, 20u);
  EXPECT_GT(changed.size(), 4u);
  EXPECT_TRUE(std::is_sorted(changed.begin(), changed.end(),
                             [](auto a, auto b) { return a->time_stamp() < b->time_stamp(); }));
}

} // namespace test_energies_of_cells
