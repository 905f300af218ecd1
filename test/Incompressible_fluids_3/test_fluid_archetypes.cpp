// Fluids run with models that provide only the requirements of the concepts `Solid_3` and
// `SaddlePointSolver`, with the same results as with models of the package.
#include "archetypes.h"
#include "fluids_3.h"

namespace test_fluid_archetypes {

// Solid_3: a floor. It is copyable, but neither default-constructible nor assignable.
class Floor
{
public:
  explicit Floor(double height) : m_height(height) {}
  Floor(const Floor&) = default;
  Floor& operator=(const Floor&) = delete;

  void walls(const CGAL::Epick::Point_3& p, double, std::vector<DSC::Wall_3>& result) const {
    result.push_back({p.z() - m_height, DSC::Wall_3::Vector(0, 0, 1)});
  }

private:
  double m_height;
};

// SaddlePointSolver. It is not copyable.
class Solver
{
public:
  Solver() = default;
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;

  void factorize(DSC::Saddle_point_system&& system, unsigned number_of_threads) {
    m_solver.factorize(std::move(system), number_of_threads);
  }
  void update(DSC::Saddle_point_system&& system) { m_solver.update(std::move(system)); }
  unsigned solve(const Eigen::VectorXd& f, const Eigen::VectorXd& s, Eigen::VectorXd& v,
                 Eigen::VectorXd& p, double tolerance) {
    return m_solver.solve(f, s, v, p, tolerance);
  }

private:
  DSC::Direct_saddle_point_solver m_solver;
};

small_meshes::Labeled_mesh cube() { return small_meshes::grid(4, small_meshes::cube); }

constexpr double height = -.5; // for the floor: the cube stands on it

TEST(Fluid_archetypes, step) {
  const DSC::Fluid_properties properties = fluids_3::liquid(1, .1, .1, 1);
  archetypes::Complex archetype = archetypes::make_complex(cube());
  CGAL::Incompressible_fluid_3<archetypes::Complex, Solver> fluid(archetype, properties);
  fluid.add_solid(Floor(height));
  fluid.add_solid(DSC::Moving_solid_3<Floor>(Floor(height - 1), DSC::Wall_3::Vector(0, 0, .1)));
  const auto report = fluid.advance(.02, parameters::adaptation_interval(0u));
  EXPECT_GT(report.contacts, 0u);
  EXPECT_TRUE(archetype.is_valid());

  small_meshes::Complex reference = small_meshes::make_complex(cube());
  // The default solver is direct for so few vertices.
  fluids_3::Fluid expected(reference, properties);
  using Plane = DSC::Plane_solid_3;
  const auto floor = [](double z) { return Plane(Plane::Point(0, 0, z), Plane::Vector(0, 0, 1)); };
  expected.add_solid(floor(height));
  expected.add_solid(DSC::Moving_solid_3<Plane>(floor(height - 1), Plane::Vector(0, 0, .1)));
  expected.advance(.02, parameters::adaptation_interval(0u));
  EXPECT_TRUE(archetype.state() == reference.state());
  EXPECT_EQ(fluid.state().motion, expected.state().motion);
}

} // namespace test_fluid_archetypes
