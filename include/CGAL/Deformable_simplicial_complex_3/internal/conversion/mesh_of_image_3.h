// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_CONVERSION_MESH_OF_IMAGE_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_CONVERSION_MESH_OF_IMAGE_3_H

#include <CGAL/Deformable_simplicial_complex_3/internal/conversion/Labelled_voxels_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Image_3.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/refine_mesh_3.h>

#include <array>
#include <cstddef>
#include <tuple>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// What Mesh_3 makes of a labelled image.
class Mesh_of_image_3
{
public:
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Domain = Labeled_mesh_domain_3<Kernel>;
  using Triangulation = Mesh_triangulation_3<Domain>::type;
  using Mesh = Mesh_complex_3_in_triangulation_3<Triangulation>;

  // Interface edges are about as long as `edge`.
  Mesh_of_image_3(const Labelled_voxels_3& voxels, double edge)
      : m_image(voxels.padded_image()),
        m_domain(Domain::create_labeled_image_mesh_domain(m_image)) {
    namespace p = CGAL::parameters;
    // Radii of circles around triangles; those of equilateral ones are .58 edges.
    static constexpr double radius = .75;  // edges; triangles are smaller than the largest
    static constexpr double distance = .1; // edges: as for a sphere with a radius of an edge or so
    static constexpr double angle = 25;    // degrees; Mesh_3 ends for 30 and less
    const Mesh_criteria_3<Triangulation> criteria(
        p::facet_angle = angle, p::facet_size = radius * edge, p::facet_distance = distance * edge);
    insert_points(voxels);
    refine_mesh_3(m_mesh, m_domain, criteria, p::no_perturb(), p::no_exude(), p::no_lloyd(),
                  p::no_odt());
  }

  const Mesh& mesh() const { return m_mesh; }

private:
  using Point = Kernel::Point_3;
  using Vector = Kernel::Vector_3;

  // Six around each part: Mesh_3 would not find small ones by itself.
  void insert_points(const Labelled_voxels_3& voxels) {
    const auto intersection = m_domain.construct_intersection_object();
    const double length = voxels.diameter();
    for (const std::size_t voxel : voxels.deepest_voxels()) {
      const auto c = voxels.center(voxel);
      const Point center(c[0], c[1], c[2]);
      for (int axis = 0; axis < 3; ++axis)
        for (const double way : {-length, length}) {
          std::array<double, 3> v = {};
          v[axis] = way;
          const auto hit =
              intersection(Kernel::Segment_3(center, center + Vector(v[0], v[1], v[2])));
          if (std::get<2>(hit) == 0)
            continue; // misses the surface
          const auto vertex = m_mesh.triangulation().insert(Triangulation::Point(std::get<0>(hit)));
          m_mesh.set_dimension(vertex, 2);
          m_mesh.set_index(vertex, std::get<1>(hit));
        }
    }
  }

  Image_3 m_image;
  Domain m_domain;
  Mesh m_mesh;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_CONVERSION_MESH_OF_IMAGE_3_H
