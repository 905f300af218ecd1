#include "grain_rates.h"
#include "test.h"
#include "torus.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_2.h>
#include <CGAL/Interface_flows/Voronoi_labels.h>

namespace test_grains_on_tori {

TEST(Grain_growth, has_the_rates_of_von_neumann_and_mullins_on_a_torus) {
  static constexpr std::size_t number = 20;
  const double edge = 1 / (std::sqrt(double(number)) * 8);
  const auto grains = DSC::make_deformable_simplicial_complex_2<torus::Complex>(
      torus::Domain({1, 1}), edge, DSC::Voronoi_labels<torus::Complex>(number, {1, 1}, true));
  EXPECT_NEAR(grain_rates::slope(grains, number), 1, .04);
}

} // namespace test_grains_on_tori
