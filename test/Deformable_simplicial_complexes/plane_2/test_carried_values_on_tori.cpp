#include "carried_values_2.h"
#include "test.h"
#include "torus.h"

namespace test_carried_values_on_tori {

TEST(Carried_values_2, are_carried_across_the_seam_of_a_torus) {
  torus::Complex dsc = torus::grid(8, [](const auto& p) { return p.x() < .5 ? 1 : 0; });
  std::mt19937 generator(3);
  for (auto v : dsc.vertices()) {
    const double x = generator() / 4294967296. - .5, y = generator() / 4294967296. - .5;
    const auto p = dsc.position(v);
    dsc.move_vertex(v, torus::Point(p.x() + (v->is_interface() ? 0 : .1 * x), p.y() + .1 * y));
  }
  carried_values_2::expect_carried(std::move(dsc), [](const auto&) { return 3.; });
}

} // namespace test_carried_values_on_tori
