#include "mesh_helpers.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>

// For any input, a deformation terminates, reports its changes and leaves a valid complex.

namespace {

using CGAL::Deformable_simplicial_complexes::Invalid_destination_error;
using mesh_helpers::Random;
using small_meshes::Complex;
using small_meshes::grid;
using small_meshes::make_complex;
using small_meshes::Point;
using Vertex_handle = Complex::Vertex_handle;

constexpr unsigned maximum_number_of_passes = 6;

enum class Abuse { nothing, rough, smooth, pull_at_box, single_vertex, far_away, not_finite };

// Random destinations for the interface vertices, of several kinds.
std::vector<Point> random_destinations(const Complex& dsc, Abuse abuse, Random& random) {
  static constexpr double huge = 1e100;
  const auto vertices = dsc.interface_vertices();
  const double length = random(.1, 3) * dsc.mean_interface_edge();
  const auto wave = random.vector<Complex>(6), amplitude = random.vector<Complex>(length);
  const std::size_t chosen = random.below(vertices.size());
  std::vector<Point> result;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    auto p = dsc.position(vertices[i]);
    const auto rough = random.vector<Complex>(length);
    switch (abuse) {
    case Abuse::nothing:
      break;
    case Abuse::rough:
      p = p + rough;
      break;
    case Abuse::smooth:
      p = p + std::sin(wave * (p - CGAL::ORIGIN)) * amplitude;
      break;
    case Abuse::pull_at_box:
      p = p + .7 * (p - CGAL::ORIGIN) + .2 * rough;
      break;
    case Abuse::single_vertex:
      p = i == chosen ? p + 3 * rough : p;
      break;
    case Abuse::far_away:
      p = i % 5 == chosen % 5 ? CGAL::ORIGIN + huge * rough : p + rough;
      break;
    case Abuse::not_finite:
      p = i == chosen ? Complex::Point_3(p.x(), std::nan(""), p.z()) : p + rough;
      break;
    }
    result.push_back(p);
  }
  return result;
}

// Applies random deformations to a mesh and returns the result.
template <class Label>
Complex::State abused(Label label, std::size_t n, int fields, unsigned seed) {
  Random random(seed);
  Complex dsc = mesh_helpers::jittered_grid(n, label, .3, seed);
  for (int field = 0; field < fields && !dsc.interface_vertices().empty(); ++field) {
    const auto abuse = Abuse(field % 7);
    const auto destinations = random_destinations(dsc, abuse, random);
    const auto vertices = dsc.interface_vertices();
    const auto before = dsc.state();
    const auto destination = [&](Vertex_handle v) {
      return destinations[std::size_t(std::find(vertices.begin(), vertices.end(), v) -
                                      vertices.begin())];
    };
    const auto np = parameters::maximum_number_of_passes(maximum_number_of_passes);
    if (abuse == Abuse::not_finite) {
      EXPECT_THROW(DSC::deform_interface(dsc, destination, np), Invalid_destination_error);
      EXPECT_TRUE(dsc.state() == before);
      continue;
    }
    const auto report = DSC::deform_interface(dsc, destination, np);
    EXPECT_TRUE(dsc.is_valid()) << "field " << field << " of seed " << seed;
    EXPECT_LE(report.passes, maximum_number_of_passes);
    EXPECT_EQ(report.complete,
              report.unfinished.empty() && report.stopped_at_boundary == 0 && report.is_balanced());
    if (abuse == Abuse::nothing) {
      EXPECT_TRUE(dsc.state() == before);
    }
    double volume = 0;
    for (const auto& change : report.labels) {
      EXPECT_EQ(change.volume_after, dsc.volume(change.label));
      EXPECT_GE(change.volume_after, 0);
      volume += change.volume_after;
      EXPECT_EQ(change.before + change.split + change.appeared,
                change.after + change.merged + change.vanished);
    }
    EXPECT_NEAR(volume, 8, 1e-12);
    for (const auto& unfinished : report.unfinished) {
      EXPECT_TRUE(unfinished.vertex->is_interface());
      EXPECT_GT(unfinished.distance, 0);
    }
    if (field % 7 == 6)
      DSC::improve_mesh(dsc);
  }
  EXPECT_TRUE(dsc.is_valid());
  return dsc.state();
}

} // namespace

TEST(Random_abuse, of_a_ball) {
  for (unsigned seed = 0; seed < 2; ++seed)
    abused(small_meshes::ball, 4, 10, seed);
}

TEST(Random_abuse, of_four_phases_between_the_sides_of_the_box) {
  for (unsigned seed = 0; seed < 2; ++seed)
    abused(small_meshes::four_phases, 4, 10, seed);
}

TEST(Random_abuse, of_boxes_with_triple_lines) { abused(small_meshes::two_boxes, 4, 10, 5); }

TEST(Random_abuse, of_labels_without_order) {
  Random random(6);
  abused([&](const Point&) { return int(random.below(4)); }, 3, 10, 7);
}

TEST(Random_abuse, repeats_to_the_same_bits) {
  EXPECT_TRUE(abused(small_meshes::ball, 4, 5, 8) == abused(small_meshes::ball, 4, 5, 8));
  EXPECT_TRUE(abused(small_meshes::four_phases, 4, 5, 9) ==
              abused(small_meshes::four_phases, 4, 5, 9));
}
