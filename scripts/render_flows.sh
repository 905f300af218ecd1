#!/usr/bin/env bash
# Runs the flows that the manual shows and renders their pictures: doc/PACKAGE/fig/flow_NAME.png.
# Uses the program BUILD_DIR/dsc and the folder BUILD_DIR/flows. Takes some minutes.
# Usage: scripts/render_flows.sh [BUILD_DIR]
. "$(dirname "$0")/figures.sh"
doc=$source/doc

check_needs() {
  require "$build/dsc"
  require_data
  "$python" -c 'import vtk' 2>/dev/null ||
    fail "VTK for Python is missing; run scripts/install_dependencies.sh"
  [ ${#display[@]} -eq 0 ] || command -v "${display[0]}" >/dev/null ||
    fail "there is no display and no ${display[0]}; run scripts/install_dependencies.sh"
}

render() { # NAME FRAMES
  "${display[@]}" "$python" "$source/scripts/render.py" "$1" --frames "$2"
  local package=Interface_flows
  case $1 in
    improved_*) package=Interface_remeshing ;;
    reconstruct_*) package=Solid_reconstruction_3 ;;
  esac
  cp "$1/strip.png" "$doc/$package/fig/flow_$1.png"
}

flow() { # NAME FRAMES COMMAND ARGUMENT...
  run "$1" "${@:3}"
  render "$1" "$2"
}

check_needs
begin_in "$build/flows"
"$python" "$source/scripts/flow_inputs.py" .
tar --extract --gzip --file "$data" --strip-components=2 \
  data/meshes/{armadillo,bunny00,refined_elephant}.off data/points_3/kitten.xyz

flow enright 5 enright --steps 100 --every 5
flow enright_armadillo 3 enright armadillo.off --fit --triangles 6000 --steps 100 --every 5
flow enright_period_3 5 enright --triangles 1280 --period 3 --steps 300 --every 15
flow vortex 5 vortex --triangles 1280 --steps 800 --every 20

flow offset_cube_outwards 4 offset cube.off --triangles 3000 --distance 0.025 --move-faces \
  --steps 18 --improve-interface
flow offset_cube_inwards 4 offset cube.off --triangles 800 --distance=-0.01 --move-faces \
  --steps 30 --improve-interface
flow offset_spheres 4 offset two_spheres.off --distance 0.05 --steps 9 --improve-interface

flow mean_curvature_bunny 4 mean-curvature bunny00.off --triangles 6000 --dt 0.0001 --steps 30 \
  --improve-interface
flow mean_curvature_torus 4 mean-curvature torus.off --dt 0.0045 --steps 30 --improve-interface
flow mean_curvature_dumbbell 4 mean-curvature dumbbell.off --dt 0.001 --steps 39 \
  --improve-interface
run double_bubble offset left_cube.off right_cube.off --triangles 1600 --distance 0.01 \
  --move-faces --steps 3
flow double_bubble 4 mean-curvature --resume double_bubble/checkpoint.dsc --keep-volumes \
  --dt 0.01 --steps 18 --improve-interface

flow improved_elephant 2 rotate refined_elephant.off --triangles 6000 --axis 0,0,1 --angle 0 \
  --improve-interface

flow reconstruct_kitten 4 reconstruct kitten.xyz -o kitten.off
flow reconstruct_block 4 reconstruct drilled_block.xyz -o drilled_block.off
flow reconstruct_gear 3 reconstruct gear.xyz -o gear.off

run grains grains --number 150 --dimension 3 --domain box --edges 6 --until .4 --every 100000
"${display[@]}" "$python" "$source/scripts/render_grains.py" grains/volume_000[1-9]*.vtu \
  "$doc/Interface_flows/fig/grains_in_space.png"
