// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "programs/option_values.h"

#include <CGAL/Mesh_files/internal/text/files.h>

#include <CLI/CLI.hpp>
#include <sched.h>

#include <charconv>
#include <cmath>
#include <thread>

namespace dsc {
namespace {

using DSC::internal::in_quotes;

/// Returns the number at the beginning of `text`, and removes it from `text`.
double take_number(std::string& text, const std::string& option) {
  if (!text.empty() && text[0] == '+')
    text.erase(0, 1);
  double number = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || !std::isfinite(number))
    throw Usage_error(option + " needs a finite number, not " + in_quotes(text) +
                      "; write a number like 1, -0.5 or 2e-3");
  text.erase(0, rest - text.data());
  return number;
}

void require_end(const std::string& text, const std::string& option, const std::string& form) {
  if (!text.empty())
    throw Usage_error(option + " ends with unexpected text " + in_quotes(text) +
                      "; write it like " + form);
}

template <std::size_t n>
std::array<double, n> parse_numbers(std::string text, const std::string& option,
                                    const std::string& form) {
  std::array<double, n> numbers;
  for (std::size_t i = 0; i < n; ++i) {
    if (i > 0) {
      if (text.empty() || text[0] != ',')
        throw Usage_error(option + " needs " + std::to_string(n) + " numbers; write it like " +
                          form);
      text.erase(0, 1);
    }
    numbers[i] = take_number(text, option);
  }
  require_end(text, option, form);
  return numbers;
}

} // namespace

double Number_range::operator()(const std::string& text, const std::string& option) const {
  const double number = parse_numbers<1>(text, option, example)[0];
  if (contains != nullptr && !contains(number))
    throw Usage_error(option + complaint);
  return number;
}

Distance Length_range::operator()(const std::string& text, const std::string& option) const {
  const bool in_mean_edges = !text.empty() && text.back() == 'e';
  return {numbers(in_mean_edges ? text.substr(0, text.size() - 1) : text, option), in_mean_edges};
}

std::array<double, 3> parse_axis(const std::string& text, const std::string& option) {
  const std::string form = "0,0,1";
  const std::array<double, 3> axis = parse_numbers<3>(text, option, form);
  const double length = std::hypot(axis[0], axis[1], axis[2]);
  if (!(length > 0) || !std::isfinite(length))
    throw Usage_error(option + " must have a positive, finite length; write it like " + form);
  return axis;
}

std::array<double, 6> parse_domain(const std::string& text, int dimension) {
  const std::string form = dimension == 2 ? "-1,-1,1,1" : "-1,-1,-1,1,1,1";
  std::array<double, 6> box = {};
  if (dimension == 2) {
    const std::array<double, 4> square = parse_numbers<4>(text, "--domain", form);
    box = {square[0], square[1], 0, square[2], square[3], 0};
  } else {
    box = parse_numbers<6>(text, "--domain", form);
  }
  for (int i = 0; i < dimension; ++i)
    if (!(box[i] < box[i + 3]))
      throw Usage_error(
          "--domain is empty; write the minimum coordinates, then the maximum coordinates, like " +
          form);
  return box;
}

bool take_growth(std::string& domain) {
  const std::string word = "grow";
  if (domain == word) {
    domain.clear();
    return true;
  }
  const std::string end = "," + word;
  if (domain.size() < end.size() ||
      domain.compare(domain.size() - end.size(), end.size(), end) != 0)
    return false;
  domain.erase(domain.size() - end.size());
  return true;
}

std::array<double, 2> parse_pair(const std::string& text, const std::string& option) {
  return parse_numbers<2>(text, option, "1.5,0");
}

std::vector<double> parse_point(const std::string& text, const std::string& option) {
  const std::string form = "0,0.3 or 1,0.5,0";
  if (std::count(text.begin(), text.end(), ',') == 2) {
    const std::array<double, 3> p = parse_numbers<3>(text, option, form);
    return {p.begin(), p.end()};
  }
  const std::array<double, 2> p = parse_numbers<2>(text, option, form);
  return {p.begin(), p.end()};
}

std::vector<double> parse_list(std::string text, const std::string& option) {
  std::vector<double> result = {take_number(text, option)};
  while (!text.empty() && text[0] == ',') {
    text.erase(0, 1);
    result.push_back(take_number(text, option));
  }
  require_end(text, option, "0.1,0.5");
  return result;
}

Cut parse_cut(const std::string& text, const std::string& option) {
  static const std::string axes = "xyz", form = "x=0.5";
  const std::size_t axis = text.empty() ? std::string::npos : axes.find(text[0]);
  if (axis == std::string::npos || text.size() < 2 || text[1] != '=')
    throw Usage_error(option + " needs an axis and a coordinate, not " + in_quotes(text) +
                      "; write it like " + form);
  return {axis, parse_numbers<1>(text.substr(2), option, form)[0]};
}

unsigned default_number_of_threads() {
  // mpirun and batch systems bind a process to some of the cores.
  cpu_set_t cores;
  if (sched_getaffinity(0, sizeof(cores), &cores) == 0)
    return std::clamp(unsigned(CPU_COUNT(&cores)), 1u, most_threads);
  return std::clamp(std::thread::hardware_concurrency(), 1u, most_threads); // 0 if unknown
}

void add_threads_option(CLI::App& command, unsigned& threads) {
  command
      .add_option("--threads", threads,
                  "Number of threads (default: all cores); the result does not depend on it")
      ->check(CLI::Range(1u, most_threads));
}

} // namespace dsc
