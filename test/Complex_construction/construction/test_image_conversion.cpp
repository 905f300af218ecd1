#include "test.h"

#include <CGAL/Complex_construction/convert_labeled_image_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/number_utils.h>

namespace test_image_conversion {

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using CGAL::Deformable_simplicial_complexes::Error;
namespace internal = CGAL::Deformable_simplicial_complexes::internal;

struct Sides
{
  double x = 1, y = 1, z = 1;
};

// Returns an image of n x n x n voxels with the labels of a function.
template <class LabelAt>
CGAL::Image_3 image(unsigned n, const LabelAt& label_at, const Sides& sides = {}) {
  _image* voxels = _createImage(n, n, n, 1, sides.x, sides.y, sides.z, 4, WK_FIXED, SGN_UNSIGNED);
  auto* const values = static_cast<std::uint32_t*>(voxels->data);
  for (unsigned i = 0; i < n * n * n; ++i)
    values[i] = std::uint32_t(label_at(i % n, i / n % n, i / (n * n)));
  return CGAL::Image_3(voxels);
}

// Returns pseudo-random labels below a number; deterministic.
struct Noise
{
  unsigned number;
  unsigned operator()(unsigned i, unsigned j, unsigned k) const {
    std::uint32_t h = i * 73856093u ^ j * 19349663u ^ k * 83492791u;
    h = (h ^ h >> 15) * 2246822519u;
    h = (h ^ h >> 13) * 3266489917u;
    return (h ^ h >> 16) % number;
  }
};

Complex convert(const CGAL::Image_3& voxels, double edge = 0) {
  return DSC::make_complex_from_labeled_image_3<Complex>(voxels, edge, parameters::normalize(true));
}

double volume(const Complex& dsc, int label) {
  return dsc.volume(label) * std::pow(dsc.normalization().scale, 3);
}

// Checks that all labels have the volumes and the numbers of components of their voxels.
void expect_volumes_and_components(const CGAL::Image_3& voxels, const Complex& dsc) {
  const internal::Labeled_voxels_3 box = internal::labeled_voxels(voxels, true);
  const internal::Voxel_components_3 components(box);
  std::map<int, double> volumes;
  std::map<int, std::size_t> numbers;
  for (const int label : box.labels)
    volumes[label] += box.spacing[0] * box.spacing[1] * box.spacing[2];
  for (std::size_t c = 1; c < components.number(); ++c) // 0 is around the image
    ++numbers[components.label(c)];
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_EQ(dsc.labels().size(), volumes.size());
  for (const auto& [label, wanted] : volumes) {
    EXPECT_NEAR(volume(dsc, label), wanted, 1e-3 * wanted) << "label " << label;
    EXPECT_EQ(dsc.number_of_components(label), numbers[label]) << "label " << label;
  }
}

TEST(Image_conversion, keeps_labels_components_and_volumes) {
  // Two adjacent slabs that reach the border, and a single isolated voxel.
  const auto voxels =
      image(10,
            [](unsigned i, unsigned j, unsigned k) {
              return i == 8 && j == 8 && k == 8 ? 9 : i >= 5 ? 0 : k < 3 ? 2 : k < 6 ? 5 : 0;
            },
            {1, 1, 2});
  const auto dsc = convert(voxels);
  EXPECT_EQ(dsc.labels(), (std::vector<int>{0, 2, 5, 9}));
  expect_volumes_and_components(voxels, dsc);
  EXPECT_NEAR(volume(dsc, 2), 300, 1e-6);
  EXPECT_NEAR(volume(dsc, 9), 2, 1e-6);
}

// The interface ends on the domain boundary; label 0 is one of the phases.
TEST(Image_conversion, fills_the_domain_with_voxels) {
  const auto voxels = image(9, [](unsigned i, unsigned j, unsigned) {
    return i + j < 8 ? 1 : i < 5 ? 2 : 0;
  });
  std::map<int, double> wanted;
  for (unsigned i = 0; i < 9; ++i)
    for (unsigned j = 0; j < 9; ++j)
      wanted[i + j < 8 ? 1 : i < 5 ? 2 : 0] += 9;
  const auto all = [](bool normalize) { return parameters::normalize(normalize); };
  for (const bool normalize : {false, true})
    for (const auto& dsc :
         {DSC::make_complex_from_labeled_image_3<Complex>(voxels, 0, all(normalize)),
          DSC::make_complex_from_labeled_image_3<Complex>(
              voxels, 0,
              all(normalize).enclosing_box(CGAL::Bbox_3(-.5, -.5, -.5, 8.5, 8.5, 8.5)))}) {
      EXPECT_TRUE(dsc.is_valid());
      EXPECT_EQ(dsc.labels(), (std::vector<int>{0, 1, 2}));
      for (const auto& [label, value] : wanted)
        EXPECT_NEAR(volume(dsc, label), value, 1e-3 * value) << label;
      for (const auto v : dsc.vertices())
        EXPECT_EQ(v->boundary_class() & DSC::Boundary_class::fixed, 0);
    }
}

// No label appears that no voxel has, also if an image consists of one voxel or one label.
TEST(Image_conversion, has_the_labels_of_the_voxels_only) {
  for (const unsigned n : {1u, 2u, 4u}) {
    const auto cubes = image(n, [](unsigned i, unsigned j, unsigned k) {
      return 1 + (i > 1) + 2 * (j > 1) + 4 * (k > 1);
    });
    expect_volumes_and_components(cubes, convert(cubes));
  }
  const auto zeros = image(3, [](unsigned, unsigned, unsigned) { return 0; });
  expect_volumes_and_components(zeros, convert(zeros));
}

TEST(Image_conversion, keeps_single_voxels) {
  const auto grains = image(12, [](unsigned i, unsigned j, unsigned k) {
    return i % 3 == 1 && j % 3 == 1 && k % 3 == 1 ? 1 + (i == 1) : 0;
  });
  expect_volumes_and_components(grains, convert(grains));
  // The edges may be much longer than voxels, too.
  expect_volumes_and_components(grains, convert(grains, 20));
}

TEST(Image_conversion, keeps_noise_of_few_and_of_many_labels) {
  for (const unsigned labels : {2u, 5u, 1000u}) {
    const auto noise = image(6, Noise{labels});
    expect_volumes_and_components(noise, convert(noise));
  }
}

TEST(Image_conversion, keeps_components_that_touch_apart) {
  const auto voxels = image(6, [](unsigned i, unsigned j, unsigned k) {
    const unsigned side = (i >= 3) + (j >= 3) + (k >= 3);
    return i < 1 || j < 1 || k < 1 || i > 4 || j > 4 || k > 4 ? 0u : unsigned(side % 2 == 0);
  });
  const auto dsc = convert(voxels);
  expect_volumes_and_components(voxels, dsc);
  EXPECT_EQ(dsc.number_of_components(1), 4u); // boxes with common edges
}

TEST(Image_conversion, finds_smooth_surfaces) {
  const double radius = 8;
  const auto ball = image(20, [&](unsigned i, unsigned j, unsigned k) {
    return std::hypot(i - 9.6, j - 9.3, k - 9.5) < radius;
  });
  const auto dsc = convert(ball);
  expect_volumes_and_components(ball, dsc);
  double area = 0;
  for (const auto& f : dsc.interface_facets())
    area += dsc.area(f);
  area *= std::pow(dsc.normalization().scale, 2);
  // The area is compared with the ball of the same volume; the faces of the voxels have one and a
  // half times this area.
  const double least = std::cbrt(36 * CGAL_PI * std::pow(volume(dsc, 1), 2));
  EXPECT_GE(area, least * (1 - 1e-9));
  EXPECT_LT(area, 1.03 * least);
  const double mean = dsc.mean_interface_edge() * dsc.normalization().scale;
  EXPECT_GT(mean, 1.5);
  EXPECT_LT(mean, 3);
}

// The cells become larger towards the sides of an image of any size.
TEST(Image_conversion, has_large_cells_at_the_sides) {
  for (const unsigned n : {48u, 50u, 53u, 64u}) {
    const auto ball = image(n, [&](unsigned i, unsigned j, unsigned k) {
      return std::hypot(i - 20., j - 20., k - 20.) < 6;
    });
    const auto dsc = convert(ball);
    expect_volumes_and_components(ball, dsc);
    EXPECT_LT(dsc.number_of_cells(), 20000u) << n;
  }
  // The interface ends on sides with copies of voxels.
  const auto wall =
      image(13, [](unsigned i, unsigned j, unsigned k) { return i + j < 13 + k % 2; });
  expect_volumes_and_components(wall, convert(wall));
}

TEST(Image_conversion, does_not_depend_on_units) {
  const auto label = [](unsigned i, unsigned j, unsigned k) {
    return i < 2 || i > 8 || k < 2 ? 0 : j < 5 ? 1 : 7;
  };
  const auto unit = convert(image(11, label));
  for (const double side : {std::pow(2., 30), std::pow(2., -30)}) {
    const auto scaled = convert(image(11, label, {side, side, side}));
    auto state = scaled.state(), expected = unit.state();
    EXPECT_EQ(state.normalization_scale, side * expected.normalization_scale);
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_EQ(state.normalization_translation[axis],
                side * expected.normalization_translation[axis]);
    state.normalization_scale = expected.normalization_scale;
    state.normalization_translation = expected.normalization_translation;
    EXPECT_TRUE(state == expected);
  }
  for (const double side : {1e-12, 1e-5, 1e4, 1e12}) {
    const auto voxels = image(11, label, {side, side, side});
    const auto scaled = convert(voxels);
    EXPECT_NEAR(double(scaled.number_of_cells()), double(unit.number_of_cells()),
                1e-3 * double(unit.number_of_cells()));
    for (const int l : {1, 7})
      EXPECT_NEAR(volume(scaled, l) / std::pow(side, 3), volume(unit, l), 1e-3 * volume(unit, l));
  }
}

TEST(Image_conversion, takes_voxels_of_any_sides) {
  for (const Sides& sides : {Sides{1, 1, 5}, Sides{.3, 2, 1}, Sides{1e-6, 2e-6, 1e-6}}) {
    const auto voxels = image(
        9, [](unsigned i, unsigned j, unsigned k) { return i + j + k < 9 ? 1
                                                           : k > 6       ? 3
                                                                         : 0; },
        sides);
    expect_volumes_and_components(voxels, convert(voxels));
  }
}

TEST(Image_conversion, fills_the_box_that_is_given) {
  const auto voxels = image(5, [](unsigned i, unsigned, unsigned) { return i > 1 ? 3 : 0; });
  const auto dsc = DSC::make_complex_from_labeled_image_3<Complex>(
      voxels, 0, parameters::enclosing_box(CGAL::Bbox_3(0, -3, -2, 6, 40, 5)));
  EXPECT_NEAR(dsc.volume(0) + dsc.volume(3), 6. * 43 * 7, 1e-9);
  EXPECT_NEAR(dsc.volume(3), 75, 1e-6);
  EXPECT_THROW(DSC::make_complex_from_labeled_image_3<Complex>(
                   voxels, 0, parameters::enclosing_box(CGAL::Bbox_3(2, -3, -2, 6, 40, 5))),
               Error);
}

TEST(Image_conversion, reads_large_labels_exactly) {
  const int largest = (std::numeric_limits<int>::max)();
  const auto voxels = image(4, [&](unsigned i, unsigned, unsigned) {
    return i < 2 ? unsigned(largest) : (1u << 24) + 1;
  });
  EXPECT_EQ(convert(voxels).labels(), (std::vector<int>{(1 << 24) + 1, largest}));
  const auto larger = image(4, [&](unsigned, unsigned, unsigned) { return unsigned(largest) + 1; });
  EXPECT_THROW(convert(larger), Error);
  _image* negative = _createImage(2, 1, 1, 1, 1, 1, 1, 4, WK_FIXED, SGN_SIGNED);
  static_cast<int*>(negative->data)[0] = -largest;
  static_cast<int*>(negative->data)[1] = -1;
  EXPECT_EQ(convert(CGAL::Image_3(negative)).labels(), (std::vector<int>{-largest, -1}));
}

TEST(Image_conversion, stops_when_asked) {
  const auto noise = image(12, Noise{5});
  int calls = 0;
  const CGAL::Deformable_simplicial_complexes::Progress_scope scope(
      [&](const char*) { return ++calls < 3; });
  EXPECT_THROW(convert(noise), CGAL::Deformable_simplicial_complexes::Interrupted_error);
}

TEST(Image_conversion, refuses_what_holds_no_labels) {
  EXPECT_THROW(convert(CGAL::Image_3()), Error);
  const auto nothing = image(3, [](unsigned, unsigned, unsigned) { return 0; });
  EXPECT_THROW(DSC::make_complex_from_labeled_image_3<Complex>(
                   nothing, 0, parameters::enclosing_box(CGAL::Bbox_3(-5, -5, -5, 5, 5, 5))),
               Error);
  const auto one = image(3, [](unsigned, unsigned, unsigned) { return 1; });
  EXPECT_THROW(convert(one, -1), Error);
  _image* gray = _createImage(2, 2, 2, 1, 1, 1, 1, 4, WK_FLOAT, SGN_SIGNED);
  std::fill_n(static_cast<float*>(gray->data), 8, .5f);
  EXPECT_THROW(convert(CGAL::Image_3(gray)), Error);
}

// The tetrahedra fill the root of the octree, and each component has the volume of its voxels.
TEST(Octree_tetrahedra, fill_the_voxels_and_the_space_around) {
  for (const double side : {8., 100.}) {
    const internal::Voxel_components_3 components(
        internal::labeled_voxels(image(7, Noise{3}), false));
    const internal::Voxel_pyramid_3 pyramid(components, 1);
    const internal::Voxel_octree_3 octree(pyramid, side);
    const DSC::Octree_tetrahedra_3 mesh(octree.tree(),
                                        [&](unsigned level, const DSC::Octree_3::Place& block) {
                                          return octree.component(level, block);
                                        });
    double all = 0;
    std::vector<double> volumes(components.number(), 0);
    std::map<std::set<std::size_t>, int> facets;
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
      const auto& v = mesh.tetrahedra[t];
      const auto corner = [&](int i) {
        const auto& p = mesh.points[v[i]];
        return CGAL::Epick::Point_3(p[0], p[1], p[2]);
      };
      const double volume = CGAL::volume(corner(0), corner(1), corner(2), corner(3));
      EXPECT_GT(volume, 0);
      all += volume;
      volumes[mesh.labels[t]] += volume;
      for (int i = 0; i < 4; ++i) {
        std::set<std::size_t> facet(v.begin(), v.end());
        facet.erase(v[i]);
        ++facets[facet];
      }
    }
    EXPECT_NEAR(all, std::pow(double(octree.tree().side()), 3), 1e-6);
    for (std::size_t c = 1; c < components.number(); ++c)
      EXPECT_NEAR(volumes[c], double(components.number_of_voxels(c)), 1e-9);
    for (const auto& [facet, number] : facets) {
      bool is_on_side = false;
      for (int axis = 0; axis < 3; ++axis)
        for (const unsigned end : {0u, octree.tree().side()})
          is_on_side = is_on_side || std::all_of(facet.begin(), facet.end(), [&](std::size_t v) {
                         return mesh.points[v][axis] == end;
                       });
      EXPECT_EQ(number, is_on_side ? 1 : 2);
    }
  }
}

} // namespace test_image_conversion
