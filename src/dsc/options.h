// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_OPTIONS_H
#define DSC_OPTIONS_H

#include <CGAL/Interface_flows/Integration_scheme.h>

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace dsc {

constexpr int most_subdivisions = 5; ///< of a surface: each makes four triangles of one

/// Turn about an axis through the centre of the domain, in the plane about that.
struct Rotation
{
  std::array<double, 3> axis; ///< of any length; zero in the plane
  double degrees;             ///< per step
};

struct Distance
{
  double value;
  bool in_mean_edges; ///< the unit: mean interface edges of the input, or that of the input's
                      ///< coordinates
  bool operator==(const Distance& other) const {
    return value == other.value && in_mean_edges == other.in_mean_edges;
  }
};

/// Move along the outward normals.
struct Offset
{
  Distance distance; ///< per step, positive outwards
  bool moves_faces;  ///< as a whole, and not each vertex along its own normal
};

/// Move with a field of velocities, given in the coordinates of the input.
struct Advection
{
  enum class Field { enright, vortex, expressions };

  Field field;
  std::string expressions; ///< of the coordinates, in x, y, z and t, if the field is these
  double period;           ///< T of the factor cos(pi t / T); 0 for no such factor
  double dt;               ///< per step
  CGAL::Deformable_simplicial_complexes::Integration_scheme scheme;
  std::optional<double> tolerance; ///< of the interface, in mean edges; the library's if not set
};

/// Move by the mean curvature.
struct Curvature_flow
{
  double dt; ///< per step, in squares of the input's unit of length; 0 for the square of the mean
             ///< interface edge of the input
  bool keeps_volumes;
  std::optional<double> tolerance; ///< of the interface, in mean edges; the library's if not set
};

/// Turn about the point (50, 50) of the plane, once in 628 units of time.
struct Zalesak
{
  static constexpr double period = 628;

  double dt; ///< per step
};

using Motion = std::variant<Rotation, Offset, Advection, Curvature_flow, Zalesak>;

/// What each step of a run does.
struct Step_options
{
  Motion motion;
  bool improves_interface = false;      ///< before the motion
  std::optional<double> aggressiveness; ///< of that; the library's if not set
  bool grows_domain = false;            ///< where the interface comes near its boundary
};

/// A ball in the coordinates of the input.
struct Ball
{
  std::array<double, 3> center;
  double radius;
};

/// A figure in the plane that needs no file.
enum class Figure { none, disk, slotted_disk };

/// The surfaces, or the figures of the plane, that a run starts from.
struct Run_start
{
  std::vector<std::string> inputs; ///< files
  std::size_t triangles = 0;       ///< of all surfaces together; 0 keeps them as they are
  std::optional<Ball> ball;        ///< that the inputs are fitted into or, without any, that is the
                                   ///< surface
  std::size_t segments = 0;        ///< of all curves together, at least; 0 keeps them as they are
  Figure figure = Figure::none;    ///< without any input in the plane
  bool repairs = false;            ///< surfaces that bound no solid
  std::string labels; ///< name of the array of a .vtu file that holds them, `none` for label 1
                      ///< everywhere; empty for the one with a name that is known
  std::optional<Distance> largest_hole; ///< length of its border that is filled at the most; the
                                        ///< library's bound if not set
  double edge = 0; ///< about how long interface edges are to be, of images and inequalities; 0 for
                   ///< the default of each
};

/// What the inputs of a run in space are; all of them are of the same kind.
enum class Input_kind { surfaces, inequalities, image, tetrahedra };

/// Of a file, or of what is written in its place.
Input_kind input_kind(const std::string& input);
Input_kind input_kind(const Run_start& start);

/// 2 if a run starts in the plane, else 3.
int dimension_of(const Run_start& start);

/// What the commands that move an interface are asked to do.
struct Run_options
{
  Step_options step;
  std::set<std::string> given;                 ///< names of the options in the command line
  Run_start start;                             ///< empty if `resume` is set
  std::string resume;                          ///< a checkpoint
  std::optional<std::array<double, 6>> domain; ///< of the input's coordinates: least, largest ones
  unsigned steps = 10;                         ///< to do in this run
  unsigned threads = 1;                        ///< to use
  std::string output;                          ///< folder; empty for no files
  unsigned every = 1;
  int subdivisions = 0; ///< for smooth surfaces there, by Loop's scheme; none if 0
  std::string report;   ///< file; empty for none
  std::string picture;  ///< file; empty for none
  bool quiet = false;
};

/// What `dsc info` is asked to do.
struct Info_options
{
  std::string file;
  std::string labels; ///< as in `Run_start`
};

/// What `dsc convert` is asked to do.
struct Convert_options
{
  std::string checkpoint;
  std::string output;
  int subdivisions = 0; ///< of the interface, by Loop's scheme
  bool quiet = false;
};

/// What `dsc improve` is asked to do.
struct Improve_options
{
  std::string input;  ///< labelled tetrahedra
  std::string output; ///< may be the input
  std::string labels; ///< as in `Run_start`
  bool aggressive = false;
  std::optional<double> threshold; ///< of the quality, in (0, 1]; that of the library if not set
  std::string report;              ///< file; empty for none
  bool quiet = false;
};

/// What `dsc cut-locus` is asked to do.
struct Cut_locus_options
{
  std::string surface = "torus"; ///< that, ellipsoid, or three expressions in u and v, or x, y, z
  std::vector<double> point;     ///< u and v, or the x, y and z of a direction
  std::array<double, 2> periods;
  double spacing =
      0; ///< in the chart; a fortieth of the shorter period, or of half a chart's width, if 0
  double step = 0;    ///< of the front; half the spacing, measured on the surface, if 0
  double radius = 0;  ///< of a ball, instead of the cut locus
  std::string output; ///< picture; empty for none
  std::string report; ///< file; empty for none
  bool quiet = false;
};

/// What `dsc reconstruct` is asked to do.
struct Reconstruct_options
{
  std::string input;       ///< points
  std::string output;      ///< surface or tetrahedra
  double tolerance = .03;  ///< in spacings of the points
  bool keeps_open = false; ///< writes the sheet that the points sample, and not the closed surface
  unsigned steps = 80;     ///< at the most
  unsigned threads = 1;
  std::string folder;  ///< for the steps; empty for none
  std::string report;  ///< file; empty for none
  std::string picture; ///< file; empty for none
  bool quiet = false;
};

/// What `dsc fluid` is asked to do.
struct Fluid_options
{
  std::string scene;    ///< file, or name of one that the program has; empty if `resume` is set
  std::string data;     ///< folder of the files that a scene names; empty for the present one
  bool lists = false;   ///< all that the program has
  bool prints = false;  ///< the scene
  double end = 0;       ///< time; that of the scene if 0
  unsigned steps = 0;   ///< at the most; 0 for any number
  unsigned threads = 1; ///< to use
  std::string output;   ///< folder; empty for no files
  unsigned every = 1;
  int subdivisions = 0; ///< for smooth surfaces there, by Loop's scheme; none if 0
  std::string resume;   ///< a checkpoint
  std::string report;   ///< file; empty for none
  std::string picture;  ///< file; empty for none
  bool quiet = false;
};

using Options = std::variant<Info_options, Run_options, Convert_options, Improve_options,
                             Cut_locus_options, Reconstruct_options, Fluid_options>;

} // namespace dsc

#endif // DSC_OPTIONS_H
