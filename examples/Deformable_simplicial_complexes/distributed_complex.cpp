// Moves the interface of a complex that is distributed among three ranks. The ranks are threads
// here. With Mpi_communicator, they are processes, which need not run on one machine.

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Distributed_complexes/Distributed_complex.h>
#include <CGAL/Distributed_complexes/advect_distributed_interface.h>
#include <CGAL/Distributed_complexes/run_in_threads.h>
#include <CGAL/Interface_flows/Normal_offset.h>

#include <CGAL/Bbox_3.h>

#include <cmath>
#include <iostream>

namespace DSC = CGAL::Deformable_simplicial_complexes;
using Complex = CGAL::Deformable_simplicial_complex_3<>;

int main() {
  // two balls in a box
  const Complex start = DSC::make_deformable_simplicial_complex_3<Complex>(
      CGAL::Bbox_3(-2, -1, -1, 2, 1, 1), .15, [](const auto& p) {
        const double x = std::abs(p.x()) - .6;
        return x * x + p.y() * p.y() + p.z() * p.z() < .16 ? 1 : 0;
      });

  DSC::run_in_threads(3, [&](DSC::Communicator& ranks) {
    DSC::Distributed_complex<Complex> complex(ranks);
    complex.distribute(start);
    for (int step = 0; step < 6; ++step) {
      const auto report = advect_interface(complex, DSC::Normal_offset{.05}, step, 1);
      if (ranks.rank() == 0)
        for (const auto& event : report.events)
          std::cout << "step " << step << ": components of the label " << event.label << " "
                    << DSC::Component_event::name_of(event.kind) << '\n';
    }
    const auto measures = complex.label_measures(); // all ranks call this function
    const Complex whole = complex.gather();
    if (ranks.rank() == 0)
      std::cout << "volume " << measures.back().measure << ", " << whole.number_of_components(1)
                << " component\n";
  });
}
