// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_SCENE_H
#define DSC_FLUID_SCENE_H

#include "expression.h"
#include "report_json.h"
#include "run_start.h"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace dsc {

/// A ball whose radius is, in the direction of a unit vector with the third coordinate z, times
/// 1 + amplitude P(z), with the Legendre polynomial of some degree.
struct Ball_shape
{
  std::array<double, 3> center;
  double radius;
  std::size_t mode;
  double amplitude;
  std::size_t triangles; ///< 0 for edges as the scene has them
};

struct Box_shape
{
  std::array<double, 3> from, to;
};

/// From one center of a cap to the other. Its radius is times 1 + amplitude cos(2 pi s /
/// wave_length) at a distance s from the first cap.
struct Cylinder_shape
{
  std::array<double, 3> from, to;
  double radius, amplitude, wave_length;
};

/// A closed surface, to be fitted into a ball.
struct File_shape
{
  std::string file;
  Ball ball;
  std::size_t triangles; ///< 0 for those of the file
};

/// All of the domain below a height, which may be any expression in x and y near to a level.
struct Pool_shape
{
  double level;
  std::optional<Expression> height; ///< the level if not set
};

/// All that no other liquid fills, with label 0.
struct Surroundings
{
};

using Fluid_shape =
    std::variant<Ball_shape, Box_shape, Cylinder_shape, File_shape, Pool_shape, Surroundings>;

struct Scene_liquid
{
  int label;
  Fluid_shape shape;
  double density, viscosity;
  std::optional<Expression> velocity; ///< three values of x, y and z; at rest if not set
};

/// A gas, see `Gas`.
struct Scene_gas
{
  int label;
  Fluid_shape shape;
  double pressure, exponent;
};

/// A ball in which liquids gain a share of their volume in a unit of time, or lose it.
struct Scene_source
{
  std::array<double, 3> center;
  double radius, rate;
};

struct Scene_solid
{
  enum class Kind { plane, tank, ball, cylinder, mesh };

  Kind kind;
  std::array<double, 3> point = {}, direction = {}; ///< of plane and cylinder; center of a ball
  double radius = 0;
  std::array<double, 6> box = {};
  bool is_open = false;
  bool contains_liquid = false; ///< of ball, cylinder and mesh
  std::string file;
  double contact_angle = 90;
  bool sticks = false, separates = true;
  std::array<double, 3> velocity = {}, angular_velocity = {};
};

/// Something to be measured in each step.
struct Scene_probe
{
  std::string name;
  std::optional<std::size_t> mode;            ///< amplitude of a Legendre polynomial, or
  std::optional<std::array<double, 2>> place; ///< height of the interface at x and y
  std::array<double, 3> center = {};
};

/// What `dsc fluid` computes.
struct Fluid_scene
{
  Json json; ///< what it was read from
  std::string title;
  std::array<double, 6> domain;
  double edge; ///< about how long edges of surfaces are
  std::vector<Scene_liquid> liquids;
  std::vector<Scene_gas> gases;
  std::vector<Scene_source> sources;
  struct Tension
  {
    std::array<int, 2> labels;
    double value;
  };
  std::vector<Tension> tensions;
  std::array<double, 3> gravity = {};
  std::vector<Scene_solid> solids;
  std::vector<Scene_probe> probes;
  double time_step; ///< at the most
  double cfl;       ///< 0 for steps that are all as long
  double end;       ///< time
  double implicitness;
  double interface_tolerance;
  std::size_t adaptation_interval;
  double relaxation_step;
  std::size_t relaxation_steps;
};

/// What fills labels, liquids first.
std::vector<std::pair<int, const Fluid_shape*>> shapes_of(const Fluid_scene& scene);

/// \throws Usage_error if a field is unknown, missing, out of its range or without effect
Fluid_scene read_scene(const Json& json);

/// Of a file, or of the name of a scene that the program has.
/// \throws Input_error if there is neither; Usage_error as above
Fluid_scene find_scene(const std::string& name);

/// Name and title of each scene that the program has, sorted by name.
/// \throws Input_error if the program finds none of its scenes
std::vector<std::array<std::string, 2>> scene_names();

} // namespace dsc

#endif // DSC_FLUID_SCENE_H
