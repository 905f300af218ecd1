#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_UNITS_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_UNITS_H

#include "test.h"

#include <nlohmann/json.hpp>

// Comparison of results in different units.
namespace units {

using Json = nlohmann::json;

struct Units
{
  double length = 1, time = 1, mass = 1;
};

// Exponents of length, time and mass, by the names of fields. Nested fields have the dimension of
// the enclosing field, unless they have their own dimension.
using Dimensions = std::map<std::string, std::array<int, 3>>;

inline const Dimensions in_space = {{"volume", {3, 0, 0}},
                                    {"estimated_error", {1, 0, 0}},
                                    {"volumes_before", {3, 0, 0}},
                                    {"volumes_after", {3, 0, 0}},
                                    {"volume_before", {3, 0, 0}},
                                    {"volume_after", {3, 0, 0}},
                                    {"volume_swept", {3, 0, 0}},
                                    {"volume_of_overlaps", {3, 0, 0}},
                                    {"volume_unexplained", {3, 0, 0}},
                                    {"where", {1, 0, 0}},
                                    {"area", {2, 0, 0}},
                                    {"mean_edge", {1, 0, 0}},
                                    {"distance_from_input", {1, 0, 0}},
                                    {"distance_to_input", {1, 0, 0}}};
inline const Dimensions in_the_plane = {{"area", {2, 0, 0}},
                                        {"length", {1, 0, 0}},
                                        {"estimated_error", {1, 0, 0}},
                                        {"volumes_before", {2, 0, 0}},
                                        {"volumes_after", {2, 0, 0}},
                                        {"volume_before", {2, 0, 0}},
                                        {"volume_after", {2, 0, 0}},
                                        {"volume_swept", {2, 0, 0}},
                                        {"volume_of_overlaps", {2, 0, 0}},
                                        {"volume_unexplained", {2, 0, 0}},
                                        {"where", {1, 0, 0}}};
inline const Dimensions squared_time = {{"time", {2, 0, 0}}}; // for flows by curvature

inline Dimensions operator+(Dimensions a, const Dimensions& b) {
  a.insert(b.begin(), b.end());
  return a;
}

// Returns a result in units 1 that was written in other units.
inline Json scaled(const Json& json, const Units& units, const Dimensions& dimensions,
                   double factor = 1) {
  if (json.is_number())
    return factor == 1 ? json : Json(json.get<double>() * factor);
  Json result = json;
  for (auto i = result.begin(); json.is_structured() && i != result.end(); ++i) {
    double of_field = factor;
    if (json.is_object())
      if (const auto found = dimensions.find(i.key()); found != dimensions.end()) {
        const auto& [length, time, mass] = found->second;
        of_field = std::pow(units.length, length) * std::pow(units.time, time) *
                   std::pow(units.mass, mass);
      }
    *i = scaled(*i, units, dimensions, of_field);
  }
  return result;
}

// Removes fields that depend on the run and not on units, for example times and parameters.
inline Json of_any_run(Json report) {
  static const std::set<std::string> of_this_run = {
      "seconds",         "sweeps", "sweep_seconds", "seconds_of_solver",
      "seconds_of_mesh", "input",  "parameters",    "scene"};
  if (report.is_object())
    for (const std::string& key : of_this_run)
      report.erase(key);
  if (report.is_structured())
    for (Json& part : report)
      part = of_any_run(part);
  return report;
}

inline void expect_equal(const Json& expected, const Json& result) {
  const Json differences = Json::diff(expected, result);
  EXPECT_TRUE(differences.empty())
      << differences.size() << " differences, the first one " << differences[0].dump()
      << " instead of "
      << expected.value(Json::json_pointer(differences[0]["path"].get<std::string>()), Json());
}

// Returns whether regions are equal, up to a relative tolerance of their measures.
inline void expect_near(const Json& expected, const Json& result, double part) {
  ASSERT_EQ(expected.size(), result.size());
  for (auto i = expected.begin(); i != expected.end(); ++i) {
    if (i->is_structured()) {
      const bool matters = !expected.is_object() || i.key() == "steps" || i.key() == "labels" ||
                           i.key() == "parts" || i.key() == "state";
      if (matters)
        expect_near(*i,
                    expected.is_object() ? result.at(i.key())
                                         : result[std::size_t(i - expected.begin())],
                    part);
    } else if (expected.is_object()) {
      const std::string& key = i.key();
      if (key == "volume" || key == "area" || key == "length") {
        EXPECT_NEAR(result.at(key).get<double>(), i->get<double>(),
                    part * std::abs(i->get<double>()))
            << key;
      } else if (key == "label" || key == "components" || key == "euler_characteristic") {
        EXPECT_EQ(result.at(key), *i) << key;
      }
    }
  }
}

// Returns whether all words are equal, except coordinates, which are multiplied by the unit.
inline void expect_scaled(const std::string& expected, const std::string& result, double unit) {
  const auto words_of = [](std::string text) {
    const std::string separators = "(),\"<>=";
    for (char& c : text)
      if (separators.find(c) != std::string::npos)
        c = ' ';
    std::istringstream in(text);
    return std::vector<std::string>(std::istream_iterator<std::string>(in), {});
  };
  const auto before = words_of(expected), after = words_of(result);
  ASSERT_EQ(before.size(), after.size());
  std::size_t directions = 0; // number of following values without unit: normals in STL
  for (std::size_t i = 0; i < before.size(); ++i) {
    static constexpr std::size_t version = 3; // characters: 1.0
    const std::string &was = before[i], &is = after[i];
    const bool has_decimals = was.find('.') != std::string::npos && was.size() > version;
    char* end = nullptr;
    const double x = std::strtod(was.c_str(), &end);
    const bool is_scaled = *end == '\0' && x * unit == std::strtod(is.c_str(), nullptr);
    ASSERT_TRUE(is_scaled || (was == is && (!has_decimals || directions > 0 || *end != '\0')))
        << "word " << i << ": " << was << " became " << is;
    directions = before[i] == "normal" ? 3 : directions > 0 ? directions - 1 : 0;
  }
}

} // namespace units

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_UNITS_H
