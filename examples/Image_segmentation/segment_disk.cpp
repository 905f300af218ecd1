// Segments an image of a disk with noise, and writes the mesh.
// Usage: segment_disk [FILE.vtu]
#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Image_segmentation/segment_image.h>
#include <CGAL/Mesh_files/VTU_2.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <random>

namespace DSC = CGAL::Deformable_simplicial_complexes;
using Complex = CGAL::Deformable_simplicial_complex_2<>;

int main(int argc, char** argv) {
  DSC::Gray_image<2> image;
  image.grid = {
      {100, 80}, {1, 1}, {0, 0}}; // 100 x 80 pixels of side 1, the first one at the origin
  image.channels.resize(1);
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 20);
  for (int y = 0; y < 80; ++y)
    for (int x = 0; x < 100; ++x)
      image.channels[0].push_back(
          float((std::hypot(x - 50, y - 40) < 25 ? 150 : 100) + noise(random)));

  DSC::Segmentation_options<2> options;
  options.phases = 2;
  const auto [complex, report] = DSC::segment_image<Complex>(image, options);
  for (const auto& phase : report.phases)
    std::cout << "label " << phase.label << ": intensity " << phase.intensities[0] << ", area "
              << phase.measure << ", components " << phase.components << '\n';
  for (const auto& boundary : report.boundaries)
    std::cout << "boundary of " << boundary.a << " and " << boundary.b << ": length "
              << boundary.measure << " +- " << boundary.uncertainty << '\n';
  if (argc > 1)
    CGAL::IO::write_VTU(argv[1], complex);
}
