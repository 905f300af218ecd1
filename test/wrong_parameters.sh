#!/usr/bin/env bash
# Checks that named parameters that a function does not take do not compile, and that the message
# names the parameter and the options of the function; that arguments that are no models of their concept do not
# compile, and that the message names the concept, with no other error after it. Also checks chains without the extension of CGAL's
# list of named parameters, which FLAGS do not contain.
# Usage: test/wrong_parameters.sh COMPILER FLAGS...
set -euo pipefail
extension=$(dirname "$0")/../src/named_parameters
source=$(cat <<'EOF'
#include <CGAL/Deformable_simplicial_complexes/compiled_2.h>
#include <CGAL/Cartesian.h>
#include <CGAL/Simple_cartesian.h>

#include <string>

namespace DSC = CGAL::Deformable_simplicial_complexes;
namespace parameters = CGAL::parameters;
using Complex = CGAL::Deformable_simplicial_complex_2<>;

void wrong(Complex& complex, const std::vector<std::array<std::size_t, 3>>& triangles) {
  const auto stay = [&](Complex::Vertex_handle v) { return v->point(); };
  DSC::deform_interface(complex, stay, parameters::verbosity_level(1).number_of_threads(2));
  DSC::deform_interface(complex, stay, parameters::number_of_threads(2).collapse_length(2.));
  DSC::improve_mesh(complex, parameters::flow(stay));
  DSC::make_deformable_simplicial_complex_2<Complex>({}, triangles, {},
                                                     parameters::enclosing_box(CGAL::Bbox_2()));
  DSC::control_detail(complex, DSC::Deformation_options<Complex>());
}

void no_models(Complex& complex) {
  const auto stay = [&](Complex::Vertex_handle v) { return v->point(); };
  DSC::deform_interface(std::as_const(complex), stay);
  DSC::deform_interface(complex, [](Complex::Vertex_handle) {});
  DSC::deform_interface(complex, stay, parameters::topology_control([](const Complex&, int) { return true; }));
  DSC::deform_interface(complex, stay, parameters::quality_threshold("high"));
  DSC::deform_interface(complex, stay, parameters::flow([](int, int) { return 1; }));
  DSC::control_detail(complex, parameters::sizing_field([](Complex::Vertex_handle) { return 1.; }));
  DSC::make_deformable_simplicial_complex_2<Complex>(CGAL::Bbox_2(0, 0, 1, 1), .1,
                                                     [](Complex::Point_2) { return std::string(); });
}
// No other errors follow from a wrong argument of a complex.
template <class... Arguments> void wrong_argument(CGAL::Deformable_simplicial_complex_2<Arguments...> complex) {
  complex = CGAL::Deformable_simplicial_complex_2<Arguments...>();
  DSC::deform_interface(complex, [&](typename decltype(complex)::Vertex_handle v) { return complex.position(v); });
}
using Kernel = Complex::Geom_traits;
template void wrong_argument(CGAL::Deformable_simplicial_complex_2<CGAL::Simple_cartesian<double>>);
template void wrong_argument(CGAL::Deformable_simplicial_complex_2<CGAL::Cartesian<float>>);
template void wrong_argument(CGAL::Deformable_simplicial_complex_2<Kernel, CGAL::Triangulation_data_structure_2<>>);
using Bases_of_cgal = CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Kernel>, CGAL::Triangulation_face_base_2<Kernel>>;
template void wrong_argument(CGAL::Deformable_simplicial_complex_2<Kernel, Bases_of_cgal>);
template void wrong_argument(CGAL::Deformable_simplicial_complex_2<Kernel, DSC::Area_length_ratio_2>);
template void wrong_argument(CGAL::Deformable_simplicial_complex_2<Kernel, CGAL::Default, DSC::Area_length_ratio_2>);
EOF
)
names='Named_parameter_check<.*verbosity_level_t, .*Deformation_options<
Named_parameter_check<.*collapse_length_t, .*Deformation_options<
Named_parameter_check<.*flow_t, .*Mesh_improvement_options<
Named_parameter_check<.*enclosing_box_t, .*Construction_options<2>
the last argument is neither a chain of named parameters nor the options of this function
the function changes the complex, which is const
the destination is a function of vertices
TopologyControl: bool operator()
the value of a named parameter has the type of the member
a sizing field is a function of points
a flow is a function of points or of vertices
the function of labels: int operator()
DeformableSimplicialComplexTraits_2 or 3: FT is double, predicates are exact
the bases are Deformable_simplicial_complex_vertex_base_3<Traits, Vb>
SimplicialDomain: Ball_domain, Solid_domain or Torus_domain'
if messages=$("$@" "-I$extension" -fsyntax-only -x c++ - <<<"$source" 2>&1); then
  echo "wrong parameters compile"
  exit 1
fi
while IFS= read -r name; do
  grep --quiet "$name" <<<"$messages" ||
    { printf 'no message contains %s:\n%s\n' "$name" "$messages"; exit 1; }
done <<<"$names"
errors=$(grep --count ' error: ' <<<"$messages")
[ "$errors" = 18 ] || { printf '%s errors instead of 18:\n%s\n' "$errors" "$messages"; exit 1; }

"$@" -Wall -Wextra -Wpedantic -Werror -fsyntax-only -x c++ - <<'EOF'
#include <CGAL/Mesh_support/parameter_values.h>

const auto chain = CGAL::parameters::quality_threshold(.3).number_of_iterations(3).minimum_angle(2).visitor(1);
template <class Tag>
constexpr bool has = CGAL::Deformable_simplicial_complexes::is_given<decltype(chain), Tag>;
static_assert(has<CGAL::internal_np::quality_threshold_t> && has<CGAL::internal_np::number_of_iterations_t>);
static_assert(has<CGAL::internal_np::minimum_angle_t> && has<CGAL::internal_np::visitor_t>);
static_assert(!has<CGAL::internal_np::flow_t>);
EOF
echo "18 wrong calls do not compile"
