#!/usr/bin/env bash
# Checks that named parameters that a function does not take do not compile, and that the message
# names the parameter and the options of the function. Also checks chains without the extension of CGAL's
# list of named parameters, which FLAGS do not contain.
# Usage: test/wrong_parameters.sh COMPILER FLAGS...
set -euo pipefail
extension=$(dirname "$0")/../src/named_parameters
source=$(cat <<'EOF'
#include <CGAL/Deformable_simplicial_complexes/compiled_2.h>

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
EOF
)
names='Named_parameter_check<.*verbosity_level_t, .*Deformation_options<
Named_parameter_check<.*collapse_length_t, .*Deformation_options<
Named_parameter_check<.*flow_t, .*Mesh_improvement_options<
Named_parameter_check<.*enclosing_box_t, .*Construction_options<2>
the last argument is neither a chain of named parameters nor the options of this function'
if messages=$("$@" "-I$extension" -fsyntax-only -x c++ - <<<"$source" 2>&1); then
  echo "wrong parameters compile"
  exit 1
fi
while IFS= read -r name; do
  grep --quiet "$name" <<<"$messages" ||
    { printf 'no message contains %s:\n%s\n' "$name" "$messages"; exit 1; }
done <<<"$names"
errors=$(grep --count ' error: ' <<<"$messages")
[ "$errors" = 5 ] || { printf '%s errors instead of 5:\n%s\n' "$errors" "$messages"; exit 1; }

"$@" -Wall -Wextra -Wpedantic -Werror -fsyntax-only -x c++ - <<'EOF'
#include <CGAL/Mesh_support/parameter_values.h>

const auto chain = CGAL::parameters::quality_threshold(.3).number_of_iterations(3).minimum_angle(2).visitor(1);
template <class Tag>
constexpr bool has = CGAL::Deformable_simplicial_complexes::is_given<decltype(chain), Tag>;
static_assert(has<CGAL::internal_np::quality_threshold_t> && has<CGAL::internal_np::number_of_iterations_t>);
static_assert(has<CGAL::internal_np::minimum_angle_t> && has<CGAL::internal_np::visitor_t>);
static_assert(!has<CGAL::internal_np::flow_t>);
EOF
echo "5 wrong parameters do not compile"
