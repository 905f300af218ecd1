#!/usr/bin/env bash
# Builds the benchmarks, runs them on the meshes of CGAL, and writes tables and raw results to
# BUILD_DIR/benchmark-results. benchmark/README.md describes the measurements.
# Usage: benchmark/run.sh [BUILD_DIR [motion] [breathing] [topology] [improvement] [memory] [operations]
#                                   [flows] [surfaces] [points] [abuse] [meshes] [repair] [cut_loci] [segmentation] [walls]]
# Runs all parts by default.
set -euo pipefail
source=$(realpath "$(dirname "$0")/..")
build=$(realpath --canonicalize-missing "${1:-$source/build}")
parts=("${@:2}")
[ ${#parts[@]} -gt 0 ] || parts=(motion breathing topology flows surfaces points improvement memory operations abuse meshes repair cut_loci segmentation walls)
mesh_seconds=${MESH_SECONDS:-600} # the time limit of one mesh in `meshes`, in seconds

programs=$build/benchmark
meshes=$build/data/meshes
results=$build/benchmark-results
failures=0

begin_table() { # TABLE COLUMN...
  { printf '| %s ' "${@:2}"; printf '|\n'; printf '| --- %.0s' "${@:2}"; printf '|\n'; } >"$1"
}

add_row() { # TABLE PROGRAM ARGUMENT...
  echo "${*:2}"
  "${@:2}" >>"$1" || fail "$1" "${*:2}" $?
}

fail() { # TABLE WHAT EXIT_CODE
  echo "| **failed** with exit code $3: ${2##*/} |" >>"$1"
  failures=$((failures + 1))
}

measure_motion() {
  begin_table "$results/rotation.md" input triangles tetrahedra "sweep (ms)" valid \
    "incomplete steps" "distance / box side" "vanished vertices" "unchanged triangles" \
    "sweeps per step, mean" "maximum"
  begin_table "$results/offset.md" input triangles tetrahedra "sweep (ms)" valid \
    "incomplete steps" "unfinished vertices" "maximum" "angles outside 6–171°" \
    "volume start → out → back" "components" "sweeps per step, mean" "maximum"
  local mode
  for mode in inwards curvature slow_curvature push rest; do
    begin_table "$results/$mode.md" input triangles tetrahedra "sweep (ms)" valid \
      "incomplete steps" "sweeps per step, mean" "maximum"
  done
  for mode in rotation offset inwards curvature slow_curvature push rest; do
    measure_one_motion eight "$meshes/eight.off"
    measure_one_motion two_spheres two_spheres
    measure_one_motion bunny00 "$meshes/bunny00.off" --triangles 13900
    measure_one_motion elephant "$meshes/elephant.off"
    measure_one_motion armadillo "$meshes/armadillo.off"
    measure_one_motion refined_elephant "$meshes/refined_elephant.off"
  done
}

measure_one_motion() { # NAME INPUT..., in the variable `mode`
  add_row "$results/$mode.md" "$programs/motion_benchmark" "$mode" "${@:2}" \
    --json "$results/$mode-$1.json"
}

measure_topology() {
  local table=$results/two_spheres_union.md n
  begin_table "$table" triangles "what is offset" "changes of topology" radius components \
    "Euler characteristic" volume "exact volume" "error (%)" "error of the input (%)" \
    "unfinished vertices" merges seconds
  for n in 9 18 35; do
    add_row "$table" "$programs/two_spheres_union" -n "$n"
  done
  add_row "$table" "$programs/two_spheres_union" -n 9 --forbid
  add_row "$table" "$programs/two_spheres_union" -n 35 --faces

  table=$results/topology_changes.md
  local scenario
  begin_table "$table" scenario triangles "mean edge" steps \
    "components of 1, of 0, Euler characteristic" "since t" expected events "incomplete steps" \
    right seconds
  for scenario in torus dumbbell shell split; do
    add_row "$table" "$programs/topology_changes" "$scenario"
  done

  table=$results/quadruple_point.md
  begin_table "$table" triangles tetrahedra "triple edges" "quadruple points" "incomplete steps" \
    labels "triple lines" "distance / box side" "change of a volume" right seconds
  add_row "$table" "$programs/phases" quadruple_point
  table=$results/double_bubble.md
  begin_table "$table" triangles tetrahedra "incomplete steps" "unfinished vertices" \
    "area of the wall" smallest "volume of a bubble" "components of 0, 1, 2" events right seconds
  add_row "$table" "$programs/phases" double_bubble
  table=$results/relaxed_bubble.md
  begin_table "$table" triangles "in the end" "incomplete steps" "area above the least (%)" \
    "mean angles of 0, 1, 2" "farthest from 120°" "change of the volume (%)" right seconds
  add_row "$table" "$programs/phases" relaxed_bubble -n 32
}

measure_improvement() {
  local table=$results/static_improvement.md
  begin_table "$table" input mode "tetrahedra before" after "angles before" after \
    "of free ones" "free ones outside 25–145°" dictated cramped seconds "tetrahedra / s"
  local name
  for name in bunny00 refined_elephant armadillo; do
    add_row "$table" "$programs/static_improvement" "$meshes/$name.off" --triangles 13900
  done
  add_row "$table" "$programs/static_improvement" "$meshes/bunny00.off" --triangles 13900 \
    --aggressive
}

measure_breathing() {
  local table=$results/breathing.md
  begin_table "$table" input triangles steps "mean edges a step" valid "unfinished vertices" \
    "angles outside 6–171° (%)" "worst angles" "tetrahedra / triangle" tetrahedra seconds
  add_row "$table" "$programs/breathing" "$meshes/bunny00.off" --triangles 13900
  add_row "$table" "$programs/breathing" "$meshes/refined_elephant.off"
  add_row "$table" "$programs/breathing" "$meshes/bunny00.off" --triangles 13900 --breaths 5
  add_row "$table" "$programs/breathing" "$meshes/bunny00.off" --triangles 13900 --breaths 5 \
    --length .02
}

measure_flows() {
  local table=$results/enright.md enright=$programs/enright n
  begin_table "$table" input period tolerance "triangles at the start" "at most" "in the end" valid \
    "incomplete steps" "change of volume at whole periods (%)" "in between (%)" \
    "mean distance to the start / edge" maximum "volume between interface and sphere" \
    "mean distance to the sphere" \
    "area in the middle / at the start" seconds "sweeps per step"
  for n in 16 32; do
    add_row "$table" "$enright" sphere -n "$n" --end 1
    add_row "$table" "$enright" sphere -n "$n" --tolerance 0
  done
  for n in 6000 20480; do
    add_row "$table" "$enright" "$meshes/armadillo.off" --triangles "$n" --tolerance 0
  done
  for n in 8 16 32; do
    add_row "$table" "$enright" sphere -n "$n" --period 3 --end 3
  done
  for n in 8 16 32; do
    add_row "$table" "$enright" sphere -n "$n" --period 3 --end 3 --tolerance .1 --restore-volume
  done

  table=$results/cube_offset.md
  begin_table "$table" direction triangles "in the end" steps "incomplete steps" valid volume \
    "exact volume" "error (%)" "farthest vertex" seconds
  add_row "$table" "$programs/cube_offset"
  add_row "$table" "$programs/cube_offset" --inwards --distance .25

  table=$results/mean_curvature.md
  begin_table "$table" surface triangles what exact measured \
    "components, Euler characteristic" steps "incomplete steps" valid seconds \
    "sweeps per step, mean" maximum
  for n in 8 16 32; do
    add_row "$table" "$programs/mean_curvature" sphere -n "$n"
  done
  add_row "$table" "$programs/mean_curvature" torus
  add_row "$table" "$programs/mean_curvature" thick_torus -n 24
  add_row "$table" "$programs/mean_curvature" dumbbell
  add_row "$table" "$programs/mean_curvature" "$meshes/bunny00.off"
}

measure_surfaces() {
  local table=$results/interface_improvement.md name aggressiveness
  begin_table "$table" input aggressiveness triangles "in the end" valid "maximum distance / edge" \
    "mean distance / edge" "loss of volume (%)" "smallest angle before" after "mean before" after \
    seconds
  for name in refined_elephant armadillo; do
    for aggressiveness in .2 .025 .003125; do
      add_row "$table" "$programs/interface_improvement" "$meshes/$name.off" \
        --aggressiveness "$aggressiveness"
    done
  done
}

measure_points() {
  local table=$results/reconstruction.md reconstruction=$programs/reconstruction cloud seed width
  local points=$build/data/points_3
  begin_table "$table" cloud method triangles "Euler characteristic" "open edges" \
    "points to surface, rms (sp)" maximum "surface to truth, rms (sp)" maximum "creases, rms (sp)" \
    "volume (%)" "what the report tells" "processor (s)" "elapsed (s)" MiB
  add_row "$table" "$reconstruction" "$points/kitten.xyz" --peers
  for cloud in tunnel noise; do
    for seed in 1 2 3 4 5; do
      add_row "$table" "$reconstruction" "$cloud" --seed "$seed" --peers
    done
  done
  add_row "$table" "$reconstruction" "$meshes/fandisk.off" --points 30000 --peers
  add_row "$table" "$reconstruction" "$meshes/elephant.off" --peers
  for seed in 1 2 3 4 5; do
    add_row "$table" "$reconstruction" gear --seed "$seed" --peers
    add_row "$table" "$reconstruction" noisy_gear --seed "$seed"
  done
  add_row "$table" "$reconstruction" spheres --peers
  add_row "$table" "$reconstruction" nested --peers
  for width in 14 7 5 3.5; do
    add_row "$table" "$reconstruction" narrow --width "$width"
  done
  add_row "$table" "$reconstruction" plate --width 2
  for width in 3 8 20; do
    add_row "$table" "$reconstruction" hole --width "$width"
  done
  add_row "$table" "$reconstruction" outliers --peers
  add_row "$table" "$reconstruction" "$points/oni.pwn"
  add_row "$table" "$reconstruction" "$points/hippo1.ply"

  table=$results/reconstruction_sizes.md
  begin_table "$table" cloud method triangles "Euler characteristic" "open edges" \
    "points to surface, rms (sp)" maximum "surface to truth, rms (sp)" maximum "creases, rms (sp)" \
    "volume (%)" "what the report tells" "processor (s)" "elapsed (s)" MiB
  add_row "$table" "$reconstruction" tunnel --points 100000
  add_row "$table" "$reconstruction" tunnel --points 100000 --threads 2
  add_row "$table" "$reconstruction" tunnel --points 1000000
  add_row "$table" "$reconstruction" tunnel --points 1000000 --threads 2

  measure_sharp_edges
}

measure_sharp_edges() {
  local table=$results/sharp_edges.md sharp_edges=$programs/sharp_edges seed noise solid
  begin_table "$table" solid points seed "noise (sp)" "surface to truth, rms (sp)" maximum \
    "truth to surface, maximum (sp)" "creases, rms (sp)" triangles components \
    "Euler characteristic" "processor (s)"
  add_row "$table" "$sharp_edges" gear --teeth 6 --points 7700 --seed 5
  for seed in 1 2 3; do
    add_row "$table" "$sharp_edges" gear --seed "$seed"
  done
  add_row "$table" "$sharp_edges" gear --teeth 24 --points 40000
  for noise in .05 .1 .2 .3; do
    add_row "$table" "$sharp_edges" gear --noise "$noise"
  done
  for solid in cube bracket cylinder cone pyramid; do
    add_row "$table" "$sharp_edges" "$solid" --points 10000
  done
  add_row "$table" "$sharp_edges" plate # 5 spacings thick
}

measure_memory() {
  begin_table "$results/memory.md" input tetrahedra cells vertices other "all" resident
  add_row "$results/memory.md" "$programs/memory_benchmark" "$meshes/bunny00.off" \
    --triangles 13900 --json "$results/memory-bunny00.json"
  add_row "$results/memory.md" "$programs/memory_benchmark" "$meshes/refined_elephant.off" \
    --json "$results/memory-refined_elephant.json"
}

measure_operations() {
  "$programs/operations_benchmark" "$meshes/eight.off" \
    --benchmark_out="$results/operations.json" --benchmark_out_format=json |
    tee "$results/operations.txt" || fail "$results/operations.txt" operations_benchmark $?
}

# Three runs must be bitwise equal.
measure_abuse() {
  local table=$results/random_abuse.md abuse=$programs/random_abuse run
  : >"$table"
  add_row "$table" "$abuse" --checkpoint "$results/random_abuse-1.dsc"
  add_row /dev/null "$abuse" --checkpoint "$results/random_abuse-2.dsc" --threads 1
  add_row /dev/null setarch "$(uname -m)" --addr-no-randomize \
    "$abuse" --checkpoint "$results/random_abuse-3.dsc"
  for run in 2 3; do
    cmp "$results/random_abuse-1.dsc" "$results/random_abuse-$run.dsc" ||
      fail "$table" "run $run differs" 1
  done
}

measure_meshes() {
  local table=$results/all_meshes.md mesh code
  begin_table "$table" file triangles outcome tetrahedra "seconds" "incomplete steps"
  for mesh in "$meshes"/*.{off,ply,stl}; do
    echo "all_meshes $mesh"
    code=0
    timeout "$mesh_seconds" "$programs/all_meshes" "$mesh" >>"$table" || code=$?
    case $code in
      0) ;;
      1) failures=$((failures + 1)) ;; # the program has written the row with the reason
      124) fail "$table" "$mesh, not done in $mesh_seconds s" $code ;;
      *) fail "$table" "$mesh" $code ;;
    esac
  done 2>"$results/all_meshes.log"
  {
    echo
    echo "$(grep -c '| rotates |' "$table") rotate," \
      "$(grep -c '| refused:' "$table") are refused," \
      "$(grep -c '\*\*' "$table") fail."
  } >>"$table"
}

# Repairs the surfaces that are rejected without --repair.
measure_repair() {
  local table=$results/repaired.md
  begin_table "$table" file "points merged" "flat triangles" "repeated triangles" "points stitched" \
    "holes filled" "crossing pairs" wrapped "input to result (mean edges)" "result to input" triangles outcome
  "$source/benchmark/repaired.py" "$build/dsc" "$mesh_seconds" "$meshes"/*.{off,ply,stl} >>"$table"
}

measure_cut_loci() {
  "$programs/cut_loci" >"$results/cut_loci.md" || fail "$results/cut_loci.md" cut_loci $?
}

measure_segmentation() {
  {
    /usr/bin/python3 "$source/benchmark/segmentation.py" "$build/dsc"
    echo
    "$programs/segmentation"
  } >"$results/segmentation.md" || fail "$results/segmentation.md" segmentation $?
}

# Solids that share walls or overlap. Sets that are refused or wrong stay in a folder.
measure_walls() {
  local table=$results/walls.md keep=$results/walls
  : >"$table"
  check_sets walls.py boxes --sets 400
  check_sets walls.py boxes --sets 100 --format %.9g
  check_sets walls.py boxes --sets 60 --format %.6g
  local kind
  for kind in file layers gears nested; do
    check_sets walls.py "$kind" --sets 40
  done
  check_sets walls.py foams --sets 5
  check_sets overlaps.py solids --sets 25 --peer "$programs/boolean_volumes"
  check_sets overlaps.py text --sets 40
}

check_sets() { # SCRIPT ARGUMENT..., in the variables `table` and `keep`
  echo "$*"
  /usr/bin/python3 "$source/benchmark/$1" "$build/dsc" "${@:2}" --keep "$keep" >>"$table" || fail "$table" "$*" $?
}

"$source/scripts/install_dependencies.sh" libvtk9-dev python3-numpy python3-skimage
[ -f "$build/CMakeCache.txt" ] ||
  cmake -S "$source" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release
cmake --build "$build" --target benchmarks dsc dsc-files dsc-full dsc-cut-locus dsc-fluid dsc-reconstruct dsc-segment --parallel "$(nproc)"
mkdir -p "$results"
tar --extract --gzip --file /usr/share/doc/libcgal-dev/data.tar.gz --directory "$build" data/meshes data/points_3
{
  grep --max-count=1 'model name' /proc/cpuinfo || uname -m
  "${CXX:-c++}" --version | head -n 1
} >"$results/machine.txt"

for part in "${parts[@]}"; do
  "measure_$part"
done
echo "Results in $results, $failures failures"
[ "$failures" -eq 0 ]
