#include "mesh_helpers.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/Deformation_options.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Interface_flows/Mean_curvature_flow.h>
#include <CGAL/Interface_flows/Normal_offset.h>
#include <CGAL/Interface_flows/advect_adaptively.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_remeshing/control_detail.h>
#include <CGAL/Interface_remeshing/improve_interface.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>
#include <CGAL/Interface_remeshing/internal/remeshing/Failed_collapses.h>
#include <CGAL/Interface_remeshing/remove_degeneracies.h>
#include <CGAL/Interface_remeshing/restore_volumes.h>
#include <CGAL/Mesh_support/Error.h>

namespace test_options {

using namespace small_meshes;

// Counts the replaced cavities, and ends a deformation after its first pass.
struct Counter : public DSC::Deformation_visitor<Complex>
{
  std::size_t replacements = 0;

  void after_replacement(const DSC::Cavity<Complex>&) override { ++replacements; }
  bool go_further(unsigned pass) override { return pass < 2; }
};

// Applies two functions to copies of a ball with long and short edges, and compares the results.
template <class ByOptions, class ByParameters>
void expect_equal(const ByOptions& by_options, const ByParameters& by_parameters) {
  Complex a = mesh_helpers::sphere(8, .5);
  mesh_helpers::jitter(a, .02, 1);
  Complex b = a;
  const Complex before = a;
  by_options(a);
  by_parameters(b);
  EXPECT_TRUE(a.is_valid());
  EXPECT_FALSE(a.state() == before.state());
  EXPECT_TRUE(a.state() == b.state());
}

double sizes(const Position& p) { return p.x() > 0 ? .1 : .3; }

TEST(Options, of_deformations_are_those_of_the_named_parameters) {
  const auto destination = [](Complex::Vertex_handle v) {
    return v->point() + .3 * (v->point() - CGAL::ORIGIN);
  };
  Counter first, second;
  expect_equal(
      [&](Complex& dsc) {
        DSC::Deformation_options<Complex> options;
        options.quality_threshold = .3;
        options.minimum_angle = 12;
        options.forbid_topology_changes();
        options.visitor = &first;
        EXPECT_LE(DSC::deform_interface(dsc, destination, options).passes, 1u);
      },
      [&](Complex& dsc) {
        DSC::deform_interface(dsc, destination,
                              parameters::quality_threshold(.3)
                                  .minimum_angle(12)
                                  .topology_control(DSC::Forbid_topology_changes())
                                  .relabeling_threshold(0)
                                  .visitor(std::ref(second)));
      });
  EXPECT_GT(first.replacements, 0u);
  EXPECT_EQ(first.replacements, second.replacements);
}

TEST(Options, of_remeshing_are_those_of_the_named_parameters) {
  expect_equal(
      [](Complex& dsc) {
        DSC::Interface_improvement_options<Complex> options;
        options.sizing_field = sizes;
        options.flip_angle = 20;
        options.number_of_iterations = 2;
        DSC::improve_interface(dsc, options);
      },
      [](Complex& dsc) {
        DSC::improve_interface(
            dsc, parameters::sizing_field(sizes).flip_angle(20).number_of_iterations(2));
      });
  expect_equal(
      [](Complex& dsc) {
        DSC::Detail_options<Complex> options;
        options.sizing_field = sizes;
        options.where = [](Complex::Cell_handle c) { return c->subdomain_index() == 1; };
        options.split_length = 2;
        options.change_interface = true;
        DSC::control_detail(dsc, options);
      },
      [](Complex& dsc) {
        DSC::control_detail(
            dsc, parameters::sizing_field(sizes)
                     .where([](Complex::Cell_handle c) { return c->subdomain_index() == 1; })
                     .split_length(2)
                     .change_interface(true));
      });
  expect_equal(
      [](Complex& dsc) {
        DSC::Mesh_improvement_options<Complex> options;
        options.quality_threshold = .6;
        options.number_of_iterations = 3;
        DSC::improve_mesh(dsc, options);
      },
      [](Complex& dsc) {
        DSC::improve_mesh(dsc, parameters::quality_threshold(.6).number_of_iterations(3));
      });
  expect_equal(
      [](Complex& dsc) {
        DSC::Degeneracy_options<Complex> options;
        options.degenerate_length = 1.2;
        DSC::remove_degeneracies(dsc, options);
      },
      [](Complex& dsc) { DSC::remove_degeneracies(dsc, parameters::degenerate_length(1.2)); });
}

TEST(Options, of_flows_are_those_of_the_named_parameters) {
  expect_equal(
      [](Complex& dsc) {
        DSC::Advection_options<Complex> options;
        options.scheme = DSC::Integration_scheme::rk4;
        options.deformation.quality_threshold = .25;
        DSC::advect_interface(dsc, DSC::Normal_offset{.1}, 0, 1, options);
      },
      [](Complex& dsc) {
        DSC::advect_interface(
            dsc, DSC::Normal_offset{.1}, 0, 1,
            parameters::scheme(DSC::Integration_scheme::rk4).quality_threshold(.25));
      });
  // The default values depend on the velocity.
  expect_equal(
      [](Complex& dsc) {
        DSC::Adaptive_advection_options<Complex> options(true);
        options.interface_tolerance = .02;
        DSC::advect_adaptively(dsc, DSC::Mean_curvature_flow(true), 0, .01, options);
      },
      [](Complex& dsc) {
        DSC::advect_adaptively(dsc, DSC::Mean_curvature_flow(true), 0, .01,
                               parameters::interface_tolerance(.02));
      });
  expect_equal(
      [](Complex& dsc) {
        DSC::Volume_restoration_options<Complex> options;
        options.volume_tolerance = 1e-4;
        options.deformation.forbid_topology_changes();
        EXPECT_TRUE(DSC::restore_volumes(dsc, {{1, .55}}, options).complete);
      },
      [](Complex& dsc) {
        EXPECT_TRUE(DSC::restore_volumes(dsc, {{1, .55}},
                                         parameters::volume_tolerance(1e-4)
                                             .topology_control(DSC::Forbid_topology_changes())
                                             .relabeling_threshold(0))
                        .complete);
      });
}

TEST(Options, that_are_out_of_range_leave_the_complex_unchanged) {
  Complex dsc = mesh_helpers::sphere(6, .5);
  const auto before = dsc.state();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto destination = [](Complex::Vertex_handle v) { return v->point(); };
  DSC::Deformation_options<Complex> deformation;
  deformation.minimum_angle = 31;
  EXPECT_THROW(DSC::deform_interface(dsc, destination, deformation), DSC::Error);
  DSC::Interface_improvement_options<Complex> interface_;
  interface_.aggressiveness = nan;
  EXPECT_THROW(DSC::improve_interface(dsc, interface_), DSC::Error);
  DSC::Detail_options<Complex> detail;
  detail.split_length = 0;
  EXPECT_THROW(DSC::control_detail(dsc, detail), DSC::Error);
  DSC::Mesh_improvement_options<Complex> mesh;
  mesh.quality_threshold = 1.1;
  EXPECT_THROW(DSC::improve_mesh(dsc, mesh), DSC::Error);
  DSC::Degeneracy_options<Complex> degeneracy;
  degeneracy.degenerate_cosine = .4;
  EXPECT_THROW(DSC::remove_degeneracies(dsc, degeneracy), DSC::Error);
  DSC::Advection_options<Complex> advection;
  advection.integration_tolerance = -1;
  EXPECT_THROW(DSC::advect_interface(dsc, DSC::Normal_offset{.1}, 0, 1, advection), DSC::Error);
  DSC::Adaptive_advection_options<Complex> adaptive;
  adaptive.adaptation_interval = 0;
  EXPECT_THROW(DSC::advect_adaptively(dsc, DSC::Normal_offset{.1}, 0, 1, adaptive), DSC::Error);
  DSC::Volume_restoration_options<Complex> volumes;
  volumes.volume_tolerance = 0;
  EXPECT_THROW(DSC::restore_volumes(dsc, {{1, .5}}, volumes), DSC::Error);
  EXPECT_TRUE(dsc.state() == before);
}

TEST(Failed_collapses, are_forgotten_when_a_star_changes) {
  const Complex dsc = mesh_helpers::sphere(6, .5);
  DSC::internal::Failed_collapses<Complex> failed;
  const auto cells = dsc.cells();
  const auto v = cells[0]->vertex(0), w = cells[0]->vertex(1);
  failed.add(v, w);
  EXPECT_TRUE(failed.contains(v, w));
  EXPECT_FALSE(failed.contains(w, v));
  const auto distant = std::find_if(cells.begin(), cells.end(), [&](Complex::Cell_handle c) {
    return !c->has_vertex(v) && !c->has_vertex(w);
  });
  ASSERT_NE(distant, cells.end());
  failed.update({*distant});
  EXPECT_TRUE(failed.contains(v, w));
  failed.update({cells[0]});
  EXPECT_FALSE(failed.contains(v, w));
  failed.add(v, w);
  EXPECT_TRUE(failed.contains(v, w));
}

} // namespace test_options
