#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_2_TEST_GRAIN_RATES_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_2_TEST_GRAIN_RATES_H

#include "test.h"

#include <CGAL/Interface_flows/Grain_growth.h>
#include <CGAL/Interface_flows/grain_statistics.h>
#include <CGAL/Interface_remeshing/remove_components.h>

namespace grain_rates {

// von Neumann and Mullins: the area of a grain with n sides grows by pi / 3 (n - 6). Lets grains
// grow, and returns the slope of their rates over those of the law.
template <class Complex> double slope(Complex complex, std::size_t number) {
  DSC::keep_largest_components(complex);
  EXPECT_EQ(complex.labels().size(), number);
  DSC::Grain_growth<Complex> growth(complex, {}, {8, .2});
  const auto by_label = [&complex] {
    std::map<int, DSC::Grain_statistics> result;
    for (const auto& grain : DSC::grain_statistics(complex))
      result[grain.label] = grain;
    return result;
  };
  double xx = 0, xy = 0;
  for (int k = 0; k < 60; ++k) {
    const auto before = by_label();
    const double dt = growth.advance().dt;
    const auto after = by_label();
    for (const auto& [label, grain] : before)
      if (const auto found = after.find(label); k > 5 && found != after.end() &&
                                                found->second.corners == grain.corners &&
                                                found->second.right_angles == grain.right_angles) {
        const double rate = (found->second.measure - grain.measure) / dt;
        xx += grain.growth(2) * grain.growth(2);
        xy += grain.growth(2) * rate;
      }
  }
  EXPECT_TRUE(complex.is_valid());
  return xy / xx;
}

} // namespace grain_rates

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_2_TEST_GRAIN_RATES_H
