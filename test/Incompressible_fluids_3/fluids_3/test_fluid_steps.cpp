// Time steps of fluids that fail: they are undone and repeated, or they end with an exception.
#include "fluids_3.h"
#include "mesh_helpers.h"

#include <Eigen/Dense>

#include <type_traits>

namespace test_fluid_steps {

using DSC::Fluid_failure;
using DSC::internal::Mesh_treatment;
using DSC::internal::Step_plan;
using mesh_helpers::sphere;
using namespace fluids_3;
using Vector = CGAL::Epick::Vector_3;
using Point = CGAL::Epick::Point_3;

// A solver that fails, or returns a wrong solution, in its next calls.
class Faulty_solver
{
public:
  static unsigned failures, wrong_solutions; // remaining numbers

  void factorize(DSC::Saddle_point_system&& system, unsigned number_of_threads) {
    m_solver.factorize(std::move(system), number_of_threads);
  }
  void update(DSC::Saddle_point_system&& system) { m_solver.update(std::move(system)); }
  unsigned solve(const Eigen::VectorXd& f, const Eigen::VectorXd& s, Eigen::VectorXd& v,
                 Eigen::VectorXd& p, double tolerance) {
    if (failures > 0) {
      --failures;
      throw DSC::Convergence_error("does not converge", .5, 1e-8);
    }
    const unsigned result = m_solver.solve(f, s, v, p, tolerance);
    if (wrong_solutions > 0) {
      --wrong_solutions;
      v *= 1.01;
    }
    return result;
  }

private:
  DSC::Direct_saddle_point_solver m_solver;
};

unsigned Faulty_solver::failures = 0;
unsigned Faulty_solver::wrong_solutions = 0;

using Fluid = CGAL::Incompressible_fluid_3<Complex>;

struct Fluid_steps : testing::Test
{
  void SetUp() override {
    Faulty_solver::failures = Faulty_solver::wrong_solutions = 0;
    fluid.solver().use<Faulty_solver>();
  }

  Complex complex = sphere(8, .4);
  Fluid fluid{complex, liquid(1, .1, .5, 1)};
};

TEST_F(Fluid_steps, that_fail_are_repeated_in_parts) {
  fluid.advance(.02);
  Faulty_solver::failures = 2;
  const auto report = fluid.advance(.02);
  EXPECT_EQ(fluid.time(), .04);
  EXPECT_EQ(fluid.state().steps, 2u);
  EXPECT_EQ(report.dt, .02);
  EXPECT_EQ(report.parts, 4u);
  ASSERT_EQ(report.repetitions.size(), 2u);
  EXPECT_EQ(report.repetitions[0].cause, Fluid_failure::equations);
  EXPECT_EQ(report.repetitions[0].dt, .02);
  EXPECT_EQ(report.repetitions[1].dt, .01);
  EXPECT_EQ(report.repetitions[1].time, .02);
  EXPECT_EQ(report.repetitions[1].amount, .5);
  EXPECT_NEAR(report.after.momentum.z(), -.04 * report.after.mass, 1e-9);
  EXPECT_NEAR(report.after.mass, report.after.volume, 1e-12); // the density is 1
  EXPECT_TRUE(complex.is_valid());
}

TEST_F(Fluid_steps, that_succeed_tell_a_small_residual) {
  const auto report = fluid.advance(.02);
  EXPECT_LT(report.residual, 1e-10);
  EXPECT_EQ(report.parts, 1u);
  EXPECT_TRUE(report.repetitions.empty());
  EXPECT_EQ(report.flat_cells, 0u);
  double sum = 0;
  std::size_t number = 0;
  for (auto v : complex.vertices())
    if (!v->is_interface() && fluid.pressure(v) > 0) {
      sum += fluid.pressure(v);
      ++number;
    }
  ASSERT_GT(number, 0u);
  EXPECT_NEAR(sum / double(number), 2.5, 1); // 2 tension / radius; the sphere is coarse
}

TEST_F(Fluid_steps, with_wrong_solutions_are_repeated) {
  fluid.advance(.02);
  Faulty_solver::wrong_solutions = 2; // the predictor and the corrector
  const auto report = fluid.advance(.02);
  ASSERT_EQ(report.repetitions.size(), 1u);
  EXPECT_GT(report.repetitions[0].amount, 1e-8);
  EXPECT_LT(report.residual, 1e-8);
}

TEST_F(Fluid_steps, that_fail_for_ever_leave_the_state_before) {
  fluid.advance(.02);
  const auto before = complex.state();
  const auto motion = fluid.state().motion;
  const auto volumes = fluid.state().volumes;
  Faulty_solver::failures = (std::numeric_limits<unsigned>::max)();
  const auto error = thrown_by<DSC::Fluid_step_error>([&] { fluid.advance(.02); });
  EXPECT_EQ(error.step(), 2u);
  EXPECT_EQ(error.last_attempt().cause, Fluid_failure::equations);
  EXPECT_EQ(error.last_attempt().time, .02);
  EXPECT_EQ(error.last_attempt().dt, .02 / 32);
  EXPECT_PRED2(contains, std::string(error.what()), "step 2");
  EXPECT_LE((error.last_attempt().place - CGAL::ORIGIN).squared_length(), .5 * .5);
  EXPECT_TRUE(complex.state() == before);
  EXPECT_EQ(fluid.state().motion, motion);
  EXPECT_EQ(fluid.state().volumes, volumes);
  EXPECT_EQ(fluid.time(), .02);
  Faulty_solver::failures = 0;
  EXPECT_TRUE(fluid.advance(.02).repetitions.empty());
}

// An undone step has no effect: the next step is bitwise equal to a step without it.
TEST_F(Fluid_steps, that_are_interrupted_leave_no_trace) {
  Complex other_complex = sphere(8, .4);
  Fluid other(other_complex, liquid(1, .1, .5, 1));
  other.solver().use<Faulty_solver>();
  fluid.advance(.02);
  other.advance(.02);
  unsigned calls = 0;
  {
    DSC::Progress_scope scope([&](const char*) { return ++calls < 20000; },
                              std::chrono::milliseconds(0));
    EXPECT_THROW(for (int k = 0; k < 1000; ++k) fluid.advance(.02), DSC::Interrupted_error);
  }
  while (other.state().steps < fluid.state().steps)
    other.advance(.02);
  EXPECT_TRUE(complex.state() == other_complex.state());
  fluid.advance(.02);
  other.advance(.02);
  EXPECT_TRUE(complex.state() == other_complex.state());
  EXPECT_EQ(fluid.state().motion, other.state().motion);
}

// Drops that land on a plane. The liquid adheres, and remeshing wets whole facets. The motion may
// raise the energy by at most one thousandth, remeshing by at most one twentieth.
TEST(Fluid, that_lands_gains_hardly_any_energy) {
  for (const double angle : {70., 100.}) {
    Complex complex = sphere(8, .4);
    CGAL::Incompressible_fluid_3<Complex> drop(complex, liquid(1.3, .02, .5, 2));
    drop.add_solid(DSC::Plane_solid_3(Point(0, 0, -.43), Vector(0, 0, 1)), {angle, false, true});
    double floor = drop.balance().mass * 2 * -.43; // the potential energy there
    double energy = drop.advance(.01).after.energy();
    for (int k = 0; k < 25; ++k) {
      const auto before = complex.state();
      try {
        const auto report = drop.advance(.02, parameters::adaptation_interval(2u));
        const double scale = std::abs(energy - floor) + 2 * std::abs(report.after.surface_energy);
        EXPECT_LE(report.after.energy() - energy, .05 * scale);
        EXPECT_LE(report.moved.energy() - report.before.energy(), 1.1e-3 * scale);
        energy = report.after.energy();
      } catch (const DSC::Fluid_step_error&) {
        EXPECT_TRUE(complex.state() == before);
        break;
      }
    }
    EXPECT_TRUE(complex.is_valid());
  }
}

TEST(Step_plan, halves_parts_until_they_are_done) {
  Step_plan plan;
  EXPECT_EQ(plan.length(), 1);
  EXPECT_TRUE(plan.fail(Fluid_failure::motion));
  EXPECT_EQ(plan.length(), .5);
  EXPECT_EQ(plan.mesh(), Mesh_treatment::improved);
  plan.succeed();
  EXPECT_EQ(plan.mesh(), Mesh_treatment::chosen);
  EXPECT_FALSE(plan.is_first());
  EXPECT_EQ(plan.end(), 1);
  EXPECT_TRUE(plan.fail(Fluid_failure::equations));
  EXPECT_EQ(plan.end(), .75);
  EXPECT_EQ(plan.mesh(), Mesh_treatment::adapted);
  plan.succeed();
  plan.succeed();
  EXPECT_TRUE(plan.is_done());
  EXPECT_EQ(plan.parts(), 3u);
}

TEST(Step_plan, preserves_the_mesh_first_if_that_is_the_cause) {
  Step_plan plan;
  EXPECT_TRUE(plan.fail(Fluid_failure::mesh));
  EXPECT_EQ(plan.length(), 1);
  EXPECT_EQ(plan.mesh(), Mesh_treatment::preserved);
  EXPECT_TRUE(plan.fail(Fluid_failure::mesh));
  EXPECT_EQ(plan.length(), .5);
  EXPECT_EQ(plan.mesh(), Mesh_treatment::preserved);
  plan.succeed();
  EXPECT_EQ(plan.mesh(), Mesh_treatment::preserved);
}

TEST(Step_plan, ends) {
  for (const auto& causes : {std::make_pair(Fluid_failure::mesh, Fluid_failure::mesh),
                             std::make_pair(Fluid_failure::mesh, Fluid_failure::equations),
                             std::make_pair(Fluid_failure::motion, Fluid_failure::motion)}) {
    Step_plan plan;
    unsigned failures = 1;
    while (plan.fail(failures % 2 == 0 ? causes.first : causes.second))
      ++failures;
    EXPECT_LE(failures, 2 * Step_plan::halvings + 2);
    EXPECT_EQ(plan.length(), 1. / 32);
  }
}

TEST(Energy_budget, does_not_depend_on_the_origin) {
  for (const double height : {0., -100.}) {
    DSC::Fluid_balance before, after;
    before.mass = after.mass = 2;
    before.potential_energy = after.potential_energy = 2 * 10 * (height + .5);
    before.surface_energy = after.surface_energy = 1;
    after.kinetic_energy = .11;
    DSC::internal::Energy_budget budget(before, {0, 0, -10}, {{0, 0, height}, {0, 0, height + 1}},
                                        0);
    EXPECT_NEAR(budget.rise(after, 0), .01, 1e-3); // .11 of 11
    budget.supply(.11);
    EXPECT_NEAR(budget.rise(after, 0), 0, 1e-12);
    after.kinetic_energy = std::nan("");
    EXPECT_TRUE(std::isinf(budget.rise(after, 0)));
  }
}

// A singular system without a solution: the residual stagnates, and the solver reports this.
TEST(Minimal_residuals, tell_that_they_stagnate) {
  const Eigen::VectorXd diagonal = Eigen::Vector4d(1, 2, 3, 0), right = Eigen::Vector4d(1, 1, 1, 1);
  const DSC::For_each_index for_each(1);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(4);
  const auto multiply = [&](const auto& in, auto& out) {
    using Scalar = typename std::decay_t<decltype(out)>::Scalar;
    out = diagonal.cast<Scalar>().cwiseProduct(in);
  };
  const auto precondition = [](const Eigen::VectorXf& in, Eigen::VectorXf& out) { out = in; };
  const auto error = thrown_by<DSC::Convergence_error>(
      [&] { DSC::internal::minimal_residuals(for_each, multiply, precondition, right, 1e-12, x); });
  EXPECT_GT(error.residual(), .4); // one of four equations cannot be satisfied
  EXPECT_LT(error.bound(), 1e-8);
}

// Cells without volume, also at the beginning, give finite equations.
TEST(Fluid_equations, of_flat_cells_are_finite) {
  using Equations = DSC::internal::Fluid_equations<Complex>;
  Complex complex = sphere(4, .4);
  const DSC::Fluid_properties properties = liquid(1, .1, .5, 1);
  const Equations::Mesh mesh(complex, properties);
  auto positions = mesh.positions(complex);
  const auto& corners = mesh.cells.front().vertices;
  positions[corners[3]] =
      (positions[corners[0]] + positions[corners[1]] + positions[corners[2]]) / 3;
  const DSC::For_each_index for_each(1);
  Equations equations(for_each, mesh, properties, {.01, .5}, positions);
  equations.assemble(positions, positions, [](std::size_t) { return .5; }, {});
  EXPECT_GE(equations.number_of_flat_cells(), 1u);
  const auto is_finite = [](const auto& matrix) { return matrix.coeffs().allFinite(); };
  EXPECT_TRUE(is_finite(equations.system().nodal));
  EXPECT_TRUE(is_finite(equations.system().coupling));
  EXPECT_TRUE(is_finite(equations.system().c));
  EXPECT_LT(equations.system().c.coeffs().abs().maxCoeff(), 1);
}

} // namespace test_fluid_steps
