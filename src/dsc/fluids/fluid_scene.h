// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_SCENE_H
#define DSC_FLUID_SCENE_H

#include "input/expression.h"
#include "input/run_start.h"
#include "output/label_titles.h"
#include "output/report_json.h"
#include "scenes/scene_solid.h"

#include <variant>

namespace dsc {

// In the plane, points and vectors have the third coordinate 0, and so have boxes.

/// A vector that is constant, or given by expressions in t.
struct Vector_in_time
{
  std::array<double, 3> constant = {};
  std::optional<Expression> expression; ///< two or three expressions; replaces `constant`

  /// Returns the vector at a time.
  /// \throws Input_error if a coordinate is not finite
  std::array<double, 3> at(double t) const {
    std::array<double, 3> result = constant;
    if (expression)
      std::copy_n(expression->at({t}), expression->size(), result.begin());
    return result;
  }
};

/// A perturbed ball. In the direction of a unit vector with third coordinate z, its radius is
/// `radius` (1 + amplitude P(z)), where P is the Legendre polynomial of degree `mode`. In the
/// plane, it is a disk: at an angle a to the x-axis, its radius is `radius` (1 + amplitude cos(mode
/// a)).
struct Ball_shape
{
  std::array<double, 3> center;
  double radius;
  std::size_t mode;
  double amplitude;
  std::size_t triangles; ///< 0 for edges of the length given in the scene
};

struct Box_shape
{
  std::array<double, 3> from, to;
};

/// Returns the box with given least and largest coordinates.
inline Box_shape box_shape(const std::array<double, 6>& b) {
  return {{b[0], b[1], b[2]}, {b[3], b[4], b[5]}};
}

/// A cylinder in space between the centers of its two caps. At distance s from the first cap, its
/// radius is `radius` (1 + amplitude cos(2 pi s / wave_length)).
struct Cylinder_shape
{
  std::array<double, 3> from, to;
  double radius, amplitude, wave_length;
};

/// A closed surface of a file, in the plane closed curves, fitted into a ball.
struct File_shape
{
  std::string file, part; ///< part: name of a part of the file; empty for the whole surface
  Ball ball;
  std::size_t triangles; ///< 0 keeps the triangles of the file
};

/// The part of the domain below a height. The height is an expression in x and y, in the plane in
/// x, whose values are near `level`.
struct Pool_shape
{
  double level;
  std::optional<Expression> height; ///< equal to `level` if not set
};

/// The part of the domain that no other liquid fills. Its label is 0.
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
  std::optional<double> diffusivity; ///< of the field
  /// Three expressions in x, y and z, or two expressions in x and y; zero velocity if not set.
  std::optional<Expression> velocity;
};

/// A gas, see `Gas`.
struct Scene_gas
{
  int label;
  Fluid_shape shape;
  double pressure, exponent;
};

/// A ball in which liquids gain or lose volume.
struct Scene_source
{
  std::array<double, 3> center;
  double radius;
  double rate; ///< fraction of the volume per unit of time; 0 if `flux` is set
  /// Volume per unit of time: an expression in t.
  std::optional<Expression> flux;
};

/// The field that liquids carry. Expressions are in the coordinates of a point, and those of given
/// values also in t.
struct Scene_field
{
  Expression initial;
  double diffusivity; ///< of liquids without their own
  /// By side of the domain: the given values on it.
  std::array<std::optional<Expression>, 6> on_sides;
  std::optional<Expression> on_surface; ///< given values on free surfaces
};

/// A quantity to be measured in each step.
struct Scene_probe
{
  enum class Kind {
    mode,        ///< amplitude of a mode of `Ball_shape` in the distance of the interface
    height,      ///< largest last coordinate of the interface above a place
    circularity, ///< of a label; surface of the ball of equal volume over the surface of the label
    centroid,    ///< of a label
    velocity,    ///< mean velocity of a label
    point        ///< label, pressure, velocity and field at a point
  };

  std::string name;
  Kind kind;
  std::size_t mode = 0;
  std::array<double, 3> center = {}; ///< of a mode
  std::array<double, 3> point = {};
  std::array<double, 2> place = {}; ///< of a height: x and, in space, y
  int label = 0;
};

/// An inflow through the part of a side of the domain that is in a box.
struct Scene_inflow
{
  Vector_in_time velocity;
  std::array<double, 6> box;
};

/// The part of a side of the domain that is in a box, with a pressure outside.
struct Scene_opening
{
  Expression pressure;                           ///< in x, y, z and t; in the plane in x, y and t
  std::optional<std::array<double, 3>> velocity; ///< of the side, if it is a no-slip side
  std::array<double, 6> box;
};

/// The input of `dsc fluid`.
struct Fluid_scene
{
  Json json; ///< the source of the scene
  std::string title;
  int dimension; ///< 2 or 3
  std::array<double, 6> domain;
  double edge; ///< target edge length of surfaces or curves
  std::vector<Scene_liquid> liquids;
  std::vector<Scene_gas> gases;
  Label_names names; ///< of liquids and gases
  std::vector<Scene_source> sources;
  struct Tension
  {
    std::array<int, 2> labels;
    double value;                         ///< 0 if there is an expression
    std::optional<Expression> expression; ///< in the value c of the field
  };
  std::vector<Tension> tensions;
  std::optional<Scene_field> field;
  Vector_in_time gravity;
  std::vector<Scene_solid> solids;
  /// By side of the domain: the velocity of a no-slip side.
  std::array<std::optional<Vector_in_time>, 6> sides;
  std::array<std::optional<Scene_inflow>, 6> inflows;   ///< by side of the domain
  std::array<std::optional<Scene_opening>, 6> openings; ///< by side of the domain
  std::vector<Scene_probe> probes;
  double time_step; ///< maximum
  double cfl;       ///< 0 for constant time steps
  double end;       ///< final time
  double implicitness;
  double interface_tolerance;
  std::size_t adaptation_interval;
  double relaxation_step;
  std::size_t relaxation_steps;
};

/// The names of the sides of the domain, in the order of `Fluid_scene::sides`. A domain in the
/// plane has the first four sides.
inline constexpr std::array<const char*, 6> names_of_sides = {"x-", "x+", "y-", "y+", "z-", "z+"};

/// Returns whether a label is the label of a liquid.
bool is_liquid(const Fluid_scene& scene, int label);

/// Returns the labels and shapes, liquids first.
std::vector<std::pair<int, const Fluid_shape*>> shapes_of(const Fluid_scene& scene);

/// Returns the name of shape i of shapes_of() in the scene, such as "gases[0]".
std::string name_of_shape(const Fluid_scene& scene, std::size_t i);

/// Reads a scene.
/// \throws Usage_error if a field is unknown, missing, out of range or without effect
Fluid_scene read_scene(const Json& json);

/// Reads a scene from a file, or finds an installed scene by its name.
/// \throws Input_error if there is neither
/// \throws Usage_error as read_scene() does
Fluid_scene find_scene(const std::string& name);

/// Returns name and title of each installed scene, sorted by name.
/// \throws Input_error if no installed scene is found
std::vector<std::array<std::string, 2>> scene_names();

} // namespace dsc

#endif // DSC_FLUID_SCENE_H
