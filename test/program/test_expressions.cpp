// Expressions of users, and connected components in samples of a function.
#include "input/expression.h"
#include "input/functions_of_points.h"
#include "input/label_components.h"
#include "input/nearest_name.h"
#include "programs/errors.h"
#include "test.h"

namespace {

using dsc::Expression;

Expression expression(const std::string& text) {
  return {text, {"x", "y", "z"}, "--test", "something else"};
}

double value(const std::string& text, double x = 0, double y = 0, double z = 0) {
  return *expression(text).at({x, y, z});
}

// Returns the error message, which is one line.
std::string refusal(const std::string& text) {
  try {
    expression(text);
  } catch (const dsc::Usage_error& error) {
    return error.what();
  }
  ADD_FAILURE() << text << " is not refused";
  return "";
}

void expect_refusal(const std::string& text, const std::string& reason) {
  const std::string message = refusal(text);
  EXPECT_PRED2(contains, message, reason);
  EXPECT_EQ(message.rfind("--test '", 0), 0u) << message;
}

} // namespace

TEST(Expressions, with_chains_are_what_they_are_without_chains) {
  const std::pair<const char*, const char*> pairs[] = {
      {"0.2<x<0.8", "0.2<x && x<0.8"},
      {"0.2<x<0.8 && y>0.5", "(0.2<x && x<0.8) && y>0.5"},
      {"x<=y<z", "x<=y && y<z"},
      {"1>=x>y>z>-1", "1>=x && x>y && y>z && z>-1"},
      {"z<0 || -0.5<x<y", "z<0 || (-0.5<x && x<y)"},
      {"(0<x<y)+(0<z<x)", "(0<x && x<y)+(0<z && z<x)"},
      {"max(0<x<y,z)", "max((0<x) && (x<y),z)"},
      {"0<x+y*z<x^2<1?x:y", "(0<x+y*z && x+y*z<x^2 && x^2<1)?x:y"},
      {"0<(x<y<z)<2", "0<(x<y && y<z) && (x<y && y<z)<2"},
      {"-1<-x<-y", "-1<-x && -x<-y"},
      {"x<y == z<0", "x<y == z<0"}};
  std::mt19937 random(7);
  const auto coordinate = [&] { return double(random()) / 2147483648. - 1; };
  for (const auto& [chain, plain] : pairs) {
    if (std::string(chain).find("==") != std::string::npos) {
      expect_refusal(chain, "chain");
      continue;
    }
    const Expression a = expression(chain), b = expression(plain);
    for (int i = 0; i < 1000; ++i) {
      const double x = coordinate(), y = coordinate(), z = coordinate();
      ASSERT_EQ(*a.at({x, y, z}), *b.at({x, y, z})) << chain << ' ' << x << ' ' << y << ' ' << z;
    }
  }
}

TEST(Expressions, are_read_as_mathematicians_do) {
  EXPECT_EQ(value("-x^2", 3), -9);
  EXPECT_EQ(value("2^-x", 2), .25);
  EXPECT_EQ(value("2^3^2"), 512);
  EXPECT_EQ(value("--x", 3), 3);
  EXPECT_EQ(value("2 - -\n\tx", 3), 5);
  EXPECT_EQ(value("x<0?-1:x>0?1:0", 3), 1);
  EXPECT_EQ(value("sin (x)", 0), 0);
  EXPECT_EQ(value("1.5e-1*.2E1"), .3);
  EXPECT_EQ(expression("x,y").size(), 2);
  EXPECT_TRUE(expression("1+pi").is_constant());
  EXPECT_TRUE(expression("x+1").depends_on("x"));
  EXPECT_FALSE(expression("x+1").depends_on("y"));
}

TEST(Expressions, that_cannot_be_read_are_refused_with_the_reason) {
  expect_refusal("x=-y", "'=='");
  expect_refusal("x+=1", "'=='");
  expect_refusal("x<y>z", "chain");
  expect_refusal("x==y==z", "chain");
  expect_refusal("x!=y<z", "chain");
  expect_refusal("cso(x)", "did you mean 'cos'?");
  expect_refusal("X", "did you mean");
  expect_refusal("radius", "variables are x, y, z");
  expect_refusal("t", "variables are x, y, z");
  expect_refusal("sin x", "parentheses");
  expect_refusal("2x", "operator is missing before 'x'");
  expect_refusal("x y", "operator is missing before 'y'");
  expect_refusal("x(2)", "operator is missing before '('");
  expect_refusal("1e", "no digits");
  expect_refusal("1.2.3", "two decimal points");
  expect_refusal("!x", "'!'");
  expect_refusal("x×y", "write '*'");
  expect_refusal("x²", "write '^2'");
  expect_refusal("x≤y", "write '<='");
  expect_refusal("x−y", "write '-'");
  expect_refusal("x**2", "write '^'");
  expect_refusal("x=<y", "write '<='");
  expect_refusal("x&y", "write '&&'");
  expect_refusal("\"x\"", "the character");
  expect_refusal("é", "the character 'é'");
  expect_refusal("x\x01", "control character");
  expect_refusal("", "a value is missing at the end");
  expect_refusal("x<", "a value is missing at the end");
  expect_refusal("x<<y", "a value is missing before '<'");
  expect_refusal("(x", "not closed");
  expect_refusal("x)", "no parenthesis is open");
  expect_refusal("x?1", "':' is missing");
  expect_refusal("sin(x,y)", "Too many parameters");
  expect_refusal(std::string(100000, '('), "nested");
  std::string chains = "x";
  for (int i = 0; i < 50; ++i)
    chains = "0<(" + chains + ")<1";
  expect_refusal(chains, "too long");
}

TEST(Expressions, that_are_not_finite_tell_the_place) {
  const dsc::Velocity_expressions velocity("1/(x-1),0,log(t)", 3);
  EXPECT_EQ(velocity.at({2, 0, 0}, 1), (std::array<double, 3>{1, 0, 0}));
  for (const auto& [x, t] : {std::pair(1., 1.), std::pair(2., -1.)})
    try {
      velocity.at({x, 0, 0}, t);
      ADD_FAILURE();
    } catch (const dsc::Input_error& error) {
      const std::string message = error.what();
      EXPECT_PRED2(contains, message, x == 1 ? "inf at x = 1, t = 1" : "nan at x = 2, t = -1");
    }
  EXPECT_THROW(dsc::Velocity_expressions("z,0", 2), dsc::Usage_error);
  EXPECT_THROW(dsc::Velocity_expressions("0,0,0", 2), dsc::Usage_error);
}

TEST(Inequalities, that_are_constant_are_refused) {
  EXPECT_THROW(dsc::Inequalities({"1<2"}), dsc::Usage_error);
  EXPECT_EQ(dsc::Inequalities({"x<1", "sqrt(x)<0.5"}).label_at({.1, 0, 0}), 2);
  EXPECT_EQ(dsc::Inequalities({"x<1", "sqrt(x)<0.5"}).label_at({-1, 0, 0}), 1);
}

TEST(Surfaces, repeat_themselves_after_their_periods) {
  const dsc::Surface_expressions torus("(2+cos(v))*cos(u),(2+cos(v))*sin(u),sin(v)");
  const double turn = 6.28319;
  EXPECT_TRUE(dsc::lengths_repeat(torus, {turn, turn}));
  EXPECT_TRUE(dsc::lengths_repeat(torus, {1, turn})); // a part of it
  EXPECT_FALSE(dsc::lengths_repeat(torus, {turn, 6}));
  EXPECT_FALSE(dsc::lengths_repeat(dsc::Surface_expressions("u,v,u^2"), {turn, turn}));
}

TEST(Names, that_are_misspelt_are_found) {
  EXPECT_EQ(dsc::nearest_name("gravitiy", {"title", "gravity", "cfl"}), "gravity");
  EXPECT_EQ(dsc::nearest_name("cicle", {"cfl", "cylinder"}), "");
  EXPECT_EQ(dsc::nearest_name("naem", {"name", "mode"}), "name");
  EXPECT_EQ(dsc::nearest_name("t", {"x", "y"}), "");
}

namespace {

constexpr std::array<double, 6> cube = {-1, -1, -1, 1, 1, 1};

int two_balls(const std::array<double, 3>& p) {
  return std::hypot(p[0] - .5, p[1], p[2]) < .4 || std::hypot(p[0] + .5, p[1], p[2]) < .4 ? 1 : 0;
}

std::string message_of(double edge, const dsc::Label_function& label_at,
                       const std::map<int, std::size_t>& found) {
  try {
    dsc::require_resolved(cube, edge, label_at, dsc::count_components(cube, edge, label_at), found,
                          {{1, "the body"}});
  } catch (const dsc::Input_error& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST(Label_components, are_counted_by_samples) {
  const auto balls = dsc::count_components(cube, std::array<std::size_t, 3>{40, 41, 39}, two_balls);
  EXPECT_EQ(balls.at(1).least, 2u);
  EXPECT_EQ(balls.at(1).most, 2u);
  EXPECT_EQ(balls.at(0).most, 1u);
  // The cubes of a checkerboard are connected by edges and corners.
  const auto board = dsc::count_components(
      cube, std::array<std::size_t, 3>{4, 4, 4}, [](const std::array<double, 3>& p) {
        return (int(p[0] * 2 + 2) + int(p[1] * 2 + 2) + int(p[2] * 2 + 2)) % 2;
      });
  EXPECT_EQ(board.at(1).least, 1u);
  EXPECT_EQ(board.at(1).most, 32u);
  // A shell has an inside. A comb is one component, although its teeth are found first.
  const auto shell = dsc::count_components(cube, std::array<std::size_t, 3>{31, 31, 31},
                                           [](const std::array<double, 3>& p) {
                                             const double r = std::hypot(p[0], p[1], p[2]);
                                             return .5 < r && r < .8 ? 1 : 0;
                                           });
  EXPECT_EQ(shell.at(1).most, 1u);
  EXPECT_EQ(shell.at(0).least, 2u);
  const auto comb = dsc::count_components(
      cube, std::array<std::size_t, 3>{81, 81, 5},
      [](const std::array<double, 3>& p) { return p[1] > .8 || std::sin(20 * p[0]) > 0 ? 1 : 0; });
  EXPECT_EQ(comb.at(1).least, 1u);
  EXPECT_EQ(comb.at(1).most, 1u);
}

TEST(Label_components, that_are_missing_are_told_with_an_edge_length) {
  EXPECT_EQ(message_of(.1, two_balls, {{0, 1}, {1, 2}}), "");
  const std::string joined = message_of(.3, two_balls, {{0, 1}, {1, 1}});
  EXPECT_PRED2(contains, joined, "the body has 1 connected component in the mesh instead of 2");
  EXPECT_PRED2(contains, joined, "choose about 0.15");
  const auto sheet = [](const std::array<double, 3>& p) { return std::abs(p[2]) < .02 ? 1 : 0; };
  const std::string crumbs = message_of(.1, sheet, {{0, 1}, {1, 153}});
  EXPECT_PRED2(contains, crumbs, "choose about 0.025");
  const auto speck = [](const std::array<double, 3>& p) {
    return std::hypot(p[0] - .31, p[1], p[2]) < 1e-4 ? 1 : 0;
  };
  const std::string nothing = message_of(.1, speck, {{0, 1}});
  EXPECT_PRED2(contains, nothing, "has no cells: it is empty");
}
