#include "mesh_helpers.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/Deformation_options.h>
#include <CGAL/Mesh_support/named_parameters.h>
#include <CGAL/Mesh_support/parameter_values.h>

// Chains of named parameters of CGAL and of the package. Parameters that a function does not take
// are in test/wrong_parameters.sh.

namespace test_named_parameters {

using CGAL::parameters::get_parameter;
using small_meshes::Complex;

TEST(Named_parameters, are_chained_with_those_of_cgal_in_any_order) {
  const double quality = .3;
  const auto check = [&](const auto& np) {
    EXPECT_EQ(get_parameter(np, CGAL::internal_np::quality_threshold), .3);
    EXPECT_EQ(get_parameter(np, CGAL::internal_np::number_of_iterations), 3);
    EXPECT_EQ(get_parameter(np, CGAL::internal_np::verbosity_level), 1);
    EXPECT_EQ(get_parameter(np, CGAL::internal_np::minimum_angle), 2.);
  };
  check(CGAL::parameters::quality_threshold(quality)
            .number_of_iterations(3)
            .verbosity_level(1)
            .minimum_angle(2.));
  check(CGAL::parameters::number_of_iterations(3)
            .quality_threshold(quality)
            .minimum_angle(2.)
            .verbosity_level(1));
  check(CGAL::parameters::default_values()
            .minimum_angle(2.)
            .verbosity_level(1)
            .number_of_iterations(3)
            .quality_threshold(quality));
}

TEST(Named_parameters, replace_the_members_of_options) {
  DSC::Deformation_options<Complex> options;
  const unsigned passes = options.maximum_number_of_passes;
  DSC::read_parameters(CGAL::parameters::number_of_threads(2).quality_threshold(.4), options);
  EXPECT_EQ(options.number_of_threads, 2u);
  EXPECT_EQ(options.quality_threshold, .4);
  EXPECT_EQ(options.maximum_number_of_passes, passes);
  DSC::read_parameters(CGAL::parameters::default_values(), options);
  EXPECT_EQ(options.quality_threshold, .4);
}

// The number of threads that a function uses, from the options that it would pass on.
template <class Tag, class NamedParameters> unsigned threads(const NamedParameters& np) {
  Complex complex;
  return DSC::internal::call_with_parameters<Tag>(
      complex, np, DSC::Deformation_options<Complex>(),
      [](const auto& options) { return options.number_of_threads; });
}

TEST(Named_parameters, get_the_number_of_threads_from_a_concurrency_tag) {
  const auto none = CGAL::parameters::default_values();
  [[maybe_unused]] const unsigned all = (std::max)(1u, std::thread::hardware_concurrency());
  EXPECT_EQ(threads<CGAL::Sequential_tag>(none), 1u);
#ifdef CGAL_LINKED_WITH_TBB
  EXPECT_EQ(threads<CGAL::Parallel_tag>(none), all);
  EXPECT_EQ(threads<CGAL::Parallel_if_available_tag>(none), all);
#else
  EXPECT_EQ(threads<CGAL::Parallel_if_available_tag>(none), 1u);
#endif
  EXPECT_EQ(threads<CGAL::Parallel_if_available_tag>(CGAL::parameters::number_of_threads(3)), 3u);
}

} // namespace test_named_parameters
