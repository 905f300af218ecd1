// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluid_scenes.h"

namespace dsc {

const std::vector<Named_scene>& named_scenes() {
  static const std::vector<Named_scene> scenes = {
      {"droplet", R"json({
  "title": "a droplet that oscillates by its surface tension, without viscosity",
  "domain": [-2.5, -2.5, -2.5, 2.5, 2.5, 2.5],
  "edge": 0.15,
  "liquids": [{
    "shape": {"type": "ball", "center": [0, 0, 0], "radius": 1, "mode": 2, "amplitude": 0.02,
              "triangles": 1280},
    "density": 1
  }],
  "surface_tension": 1,
  "probes": [{"name": "amplitude", "mode": 2, "center": [0, 0, 0]}],
  "interface_tolerance": 0,
  "time_step": 0.05,
  "end": 9
})json"},
      {"bunny", R"json({
  "title": "a bunny that surface tension makes round (figure 10 of the paper)",
  "domain": [-2.5, -2.5, -2.5, 2.5, 2.5, 2.5],
  "edge": 0.06,
  "liquids": [{
    "shape": {"type": "file", "file": "bunny00.off", "center": [0, 0, 0], "radius": 1,
              "triangles": 2500},
    "density": 1,
    "viscosity": 0.02
  }],
  "surface_tension": 1,
  "time_step": 0.005,
  "cfl": 0.5,
  "end": 1
})json"},
      {"collision", R"json({
  "title": "two droplets that collide obliquely (figure 11 of the paper)",
  "domain": [-4, -4, -4, 4, 4, 4],
  "edge": 0.15,
  "liquids": [
    {"label": 1, "shape": {"type": "ball", "center": [-1.3, -0.35, 0], "radius": 1},
     "density": 1, "velocity": [1.5, 0, 0]},
    {"label": 1, "shape": {"type": "ball", "center": [1.3, 0.35, 0], "radius": 1},
     "density": 1, "velocity": [-1.5, 0, 0]}
  ],
  "surface_tension": 1,
  "time_step": 0.02,
  "cfl": 0.25,
  "end": 2
})json"},
      {"bowl", R"json({
  "title": "a viscous armadillo that splashes in a spherical bowl (figure 12 of the paper)",
  "domain": [-1.6, -1.6, -1.6, 1.6, 1.6, 1.6],
  "edge": 0.05,
  "liquids": [{
    "shape": {"type": "file", "file": "armadillo.off", "center": [0, 0, 0], "radius": 0.8,
              "triangles": 3000},
    "density": 1,
    "viscosity": 0.05
  }],
  "surface_tension": 0.01,
  "gravity": [0, 0, -9.81],
  "solids": [{"type": "ball", "center": [0, 0, 0], "radius": 1, "liquid": "inside"}],
  "time_step": 0.005,
  "cfl": 0.5,
  "end": 1.5
})json"},
      {"dam-break", R"json({
  "title": "a column of water, as wide as 1 and as high as 2, that runs out over a floor",
  "domain": [-1, -1, -1, 6, 1.5, 3],
  "edge": 0.1,
  "liquids": [{
    "shape": {"type": "box", "from": [0, 0, 0], "to": [1, 0.5, 2]},
    "density": 1
  }],
  "gravity": [0, 0, -1],
  "solids": [{"type": "tank", "box": [0, 0, 0, 5, 0.5, 3], "open": true}],
  "time_step": 0.02,
  "cfl": 0.5,
  "end": 2.4
})json"},
      {"crown", R"json({
  "title": "a drop that falls into a pool and throws up a crown",
  "domain": [-2, -2, -1, 2, 2, 2],
  "edge": 0.13,
  "liquids": [
    {"label": 1, "shape": {"type": "pool", "level": 0}, "density": 1, "viscosity": 0.002},
    {"label": 1, "shape": {"type": "ball", "center": [0, 0, 0.62], "radius": 0.5}, "density": 1,
     "viscosity": 0.002, "velocity": [0, 0, -4]}
  ],
  "surface_tension": 0.05,
  "gravity": [0, 0, -4],
  "time_step": 0.02,
  "cfl": 0.4,
  "end": 1
})json"},
      {"capillary-wave", R"json({
  "title": "a wave on deep water that surface tension flattens and viscosity damps",
  "domain": [0, 0, 0, 0.5, 0.0625, 1.5],
  "edge": 0.0625,
  "liquids": [{
    "shape": {"type": "pool", "level": 1, "height": "1+0.01*cos(2*pi*x)"},
    "density": 1,
    "viscosity": 0.01
  }],
  "surface_tension": 1,
  "probes": [{"name": "height", "height_at": [0, 0]}],
  "interface_tolerance": 0,
  "time_step": 0.006,
  "end": 0.798
})json"},
      {"jet", R"json({
  "title": "a thread of liquid that surface tension tears into drops (Rayleigh and Plateau)",
  "domain": [-1, -3, -3, 13.5663706, 3, 3],
  "edge": 0.25,
  "liquids": [{
    "shape": {"type": "cylinder", "from": [0, 0, 0], "to": [12.5663706, 0, 0], "radius": 1,
              "amplitude": 0.02, "wave_length": 12.5663706},
    "density": 1
  }],
  "surface_tension": 1,
  "solids": [
    {"type": "plane", "point": [0, 0, 0], "normal": [1, 0, 0], "separates": false},
    {"type": "plane", "point": [12.5663706, 0, 0], "normal": [-1, 0, 0], "separates": false}
  ],
  "time_step": 0.1,
  "cfl": 0.5,
  "end": 20
})json"},
      {"sloshing", R"json({
  "title": "water that sloshes in a tank, the slowest wave",
  "domain": [0, 0, 0, 1, 1, 1],
  "edge": 0.0833333333,
  "liquids": [{
    "shape": {"type": "pool", "level": 0.5, "height": "0.5+0.005*cos(pi*x)"},
    "density": 1
  }],
  "gravity": [0, 0, -1],
  "probes": [{"name": "height", "height_at": [0, 0.5]}],
  "interface_tolerance": 0,
  "time_step": 0.08,
  "end": 11.2
})json"},
      {"bubble", R"json({
  "title": "a light liquid that rises in a heavy one, in a closed cylinder with slippery walls",
  "domain": [-0.8, -0.8, -0.3, 0.8, 0.8, 2.3],
  "edge": 0.055,
  "liquids": [
    {"shape": {"type": "ball", "center": [0, 0, 0.5], "radius": 0.25}, "density": 100,
     "viscosity": 1},
    {"shape": {"type": "cylinder", "from": [0, 0, 0], "to": [0, 0, 2], "radius": 0.5},
     "density": 1000, "viscosity": 10}
  ],
  "surface_tension": [{"labels": [1, 2], "value": 24.5}],
  "gravity": [0, 0, -0.98],
  "solids": [
    {"type": "cylinder", "point": [0, 0, 0], "axis": [0, 0, 1], "radius": 0.5, "liquid": "inside",
     "separates": false},
    {"type": "plane", "point": [0, 0, 0], "normal": [0, 0, 1], "separates": false},
    {"type": "plane", "point": [0, 0, 2], "normal": [0, 0, -1]}
  ],
  "time_step": 0.02,
  "cfl": 0.5,
  "end": 3
})json"},
      {"breathing", R"json({
  "title": "a bubble of gas in a ball of liquid, which expands until the air around stops it",
  "domain": [-3, -3, -3, 3, 3, 3],
  "edge": 0.15,
  "liquids": [
    {"shape": {"type": "ball", "center": [0, 0, 0], "radius": 1, "triangles": 1280}, "density": 1}
  ],
  "gases": [
    {"shape": {"type": "surroundings"}, "pressure": 1, "exponent": 0},
    {"shape": {"type": "ball", "center": [0, 0, 0], "radius": 0.5, "triangles": 320},
     "pressure": 1.1}
  ],
  "surface_tension": 0.01,
  "time_step": 0.025,
  "end": 2
})json"},
      {"tap", R"json({
  "title": "a jet that falls from a ceiling, where a source feeds it",
  "domain": [-1, -1, -3, 1, 1, 2.2],
  "edge": 0.12,
  "liquids": [{
    "shape": {"type": "cylinder", "from": [0, 0, 0], "to": [0, 0, 2], "radius": 0.3},
    "density": 1,
    "viscosity": 0.01
  }],
  "sources": [{"center": [0, 0, 1.7], "radius": 0.4, "rate": 1}],
  "surface_tension": 0.02,
  "gravity": [0, 0, -1],
  "solids": [
    {"type": "plane", "point": [0, 0, 2], "normal": [0, 0, -1], "separates": false}
  ],
  "time_step": 0.04,
  "cfl": 0.5,
  "end": 2
})json"},
      {"sessile", R"json({
  "title": "a cube of liquid on a floor that becomes a drop with a contact angle of 60 degrees",
  "domain": [-3, -3, -1, 3, 3, 3],
  "edge": 0.2,
  "liquids": [{
    "shape": {"type": "box", "from": [-0.8, -0.8, 0], "to": [0.8, 0.8, 1.6]},
    "density": 1,
    "viscosity": 0.3
  }],
  "surface_tension": 1,
  "solids": [{"type": "plane", "point": [0, 0, 0], "normal": [0, 0, 1], "contact_angle": 60}],
  "time_step": 0.03,
  "cfl": 0.25,
  "implicitness": 1,
  "end": 12
})json"},
      {"spinning", R"json({
  "title": "a ball that spins, without surface tension: it flattens as an ellipsoid",
  "domain": [-4, -4, -4, 4, 4, 4],
  "edge": 0.2,
  "liquids": [{
    "shape": {"type": "ball", "center": [0, 0, 0], "radius": 1},
    "density": 1,
    "velocity": "-y,x,0"
  }],
  "interface_tolerance": 0,
  "time_step": 0.02,
  "end": 1
})json"},
  };
  return scenes;
}

} // namespace dsc
