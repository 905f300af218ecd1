#!/usr/bin/env bash
# Draws the pictures of planar complexes, of flows in the plane and of cut loci for the manual: doc/PACKAGE/fig/plane_NAME.png.
# Needs the targets dsc, dsc-fluid, dsc-cut-locus, dsc-grains, example_planar_foam, example_cut_locus and
# example_rising_bubble_2 in BUILD_DIR. Takes ten minutes.
# Usage: scripts/draw_plane.sh [BUILD_DIR]
. "$(dirname "$0")/figures.sh"
doc=$source/doc
foam=$build/examples/planar_foam
cut_locus=$build/examples/cut_locus
bubble=$build/examples/rising_bubble_2

"$source/scripts/install_dependencies.sh" librsvg2-bin
require "$build/dsc" "$foam" "$cut_locus" "$bubble"
begin_in "$build/plane"

picture() { # FILE.svg NAME [WIDTH]
  local package=Interface_flows
  [[ $2 != cut_locus* ]] || package=Cut_loci_2
  [[ ! $2 =~ ^(bubble|wheel|u_tube|floating|draining|thermocapillary) ]] || package=Incompressible_fluids_3
  rsvg-convert --width "${3:-480}" --background-color white "$1" --output "$doc/$package/fig/plane_$2.png"
}

# Two stars and a ring
python3 - >offset.wkt <<'STARS'
from math import cos, pi, sin


def way(x, y, n, radius):
    points = [(x + radius(2 * pi * i / n) * cos(2 * pi * i / n),
               y + radius(2 * pi * i / n) * sin(2 * pi * i / n)) for i in range(n)]
    return "(" + ", ".join(f"{x} {y}" for x, y in points + points[:1]) + ")"


stars = ["(" + way(x, 0, 120, lambda a: .8 + .25 * cos(5 * a)) + ")" for x in (-1.2, 1.2)]
ring = "(" + way(0, 1.8, 90, lambda a: .75) + ", " + way(0, 1.8, 60, lambda a: .6) + ")"
print("MULTIPOLYGON (" + ", ".join(stars + [ring]) + ")")
STARS
run offset offset offset.wkt --distance .05 --steps 8 --every 8 --domain -3,-2,3,3.5
picture offset/picture_000000.svg offset_before
picture offset/picture_000008.svg offset
run zalesak zalesak --dt 15.7 --steps 15 --every 15
picture zalesak/picture_000015.svg zalesak
run vortex vortex --plane --steps 400 --every 400
picture vortex/picture_000400.svg vortex
"$foam" 100 .014 60 foam.svg
picture foam.svg foam
"$build/dsc" grains --number 300 --picture grains.svg
picture grains.svg grains
"$build/dsc" grains --number 300 --energy read-shockley --largest-angle 30 --picture textured_grains.svg \
  --plot grain_distributions.svg
picture textured_grains.svg textured_grains
picture grain_distributions.svg grain_distributions 900
"$build/dsc" grains --number 100 --particles 60 --until .1 --picture pinned.svg
picture pinned.svg pinned_grains
for case in 1 2; do
  "$bubble" $case .03 .01 2.2 "bubble_$case.svg"
  picture "bubble_$case.svg" "bubble_$case"
done
liquid() { # NAME SCENE QUANTITY END [WIDTH]
  "$build/dsc" fluid "$2" --quiet --color "$3" --end "$4" --picture "$1.svg"
  picture "$1.svg" "$1" "${@:5}"
}
liquid floating_1 floating-box pressure .02
liquid floating_2 floating-box pressure 2
liquid u_tube u-tube velocity 2
liquid wheel wheel velocity 1 340
liquid draining draining velocity 1
liquid thermocapillary thermocapillary field 10
locus() { # NAME V B
  "$cut_locus" .15 "$2" "$3" "$1.svg"
  picture "$1.svg" "$1"
}
# The parameter v starts at 1.2, so that the cut locus does not lie on the border of the chart.
"$build/dsc" cut-locus --point 0,1.2 --spacing .15 -o cut_locus_equator.svg \
  --surface "(2+cos(v-1.2))*cos(u),(2+cos(v-1.2))*sin(u),sin(v-1.2)"
picture cut_locus_equator.svg cut_locus_equator
locus cut_locus .314159265 1
locus cut_locus_high .314159265 2
tube='(1+.2*cos(3*u))'
"$build/dsc" cut-locus --point .3,.5 --spacing .12 -o cut_locus_own.svg \
  --surface "(2+$tube*cos(v))*cos(u),(2+$tube*cos(v))*sin(u),$tube*sin(v)"
picture cut_locus_own.svg cut_locus_own
"$build/dsc" cut-locus --surface ellipsoid --point 1,1,1 -o cut_locus_ellipsoid.svg
picture cut_locus_ellipsoid.svg cut_locus_ellipsoid
bumps='(1+.4*(x^4+y^4+z^4))'
"$build/dsc" cut-locus --surface "x*$bumps,y*$bumps,z*$bumps" --point 1,.6,.4 --spacing .07 \
  -o cut_locus_bumps.svg
picture cut_locus_bumps.svg cut_locus_bumps
