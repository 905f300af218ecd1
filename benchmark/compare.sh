#!/usr/bin/env bash
# Runs benchmarks of two builds alternately and reports which of them became slower.
# Usage: benchmark/compare.sh OLD_BUILD NEW_BUILD [RUNS]
# Both builds need the target `benchmarks`. Prints a line for each benchmark: the median of RUNS runs
# (default: 5) for each build in sweeps per step, the noise, and a verdict. The noise is the largest
# deviation of a run from the median of its build. Ends with status 1 if a benchmark became slower by
# more than the noise.
set -euo pipefail
old=$(realpath "$1")/benchmark
new=$(realpath "$2")/benchmark
runs=${3:-5}
work=$(mktemp --directory)
trap 'rm -rf "$work"' EXIT
tar --extract --gzip --file /usr/share/doc/libcgal-demo/data.tar.gz --directory "$work" \
  data/meshes/bunny00.off data/meshes/elephant.off data/meshes/oblong.off
meshes=$work/data/meshes

# The column of the sweeps per step, counted from the right; then the program and its arguments.
jobs=(
  "2 motion_benchmark rotation $meshes/bunny00.off --triangles 13900"
  "2 motion_benchmark rotation $meshes/oblong.off"
  "2 motion_benchmark offset $meshes/bunny00.off --triangles 13900"
  "2 motion_benchmark offset $meshes/elephant.off"
  "2 mean_curvature $meshes/bunny00.off"
  "1 enright sphere -n 8 --period 3 --tolerance .05"
)

sweeps() { # FOLDER JOB...
  "$1/${*:3:1}" "${@:4}" | tail -n 1 | awk -F '|' -v k="$2" '{ print $(NF - k) + 0 }'
}

# Prints medians, noise and verdict for two files of numbers. Fails if the second file is slower.
judge() {
  awk '
    function median(a, n,    i, j, t) {
      for (i = 2; i <= n; ++i)
        for (j = i; j > 1 && a[j - 1] > a[j]; --j) { t = a[j]; a[j] = a[j - 1]; a[j - 1] = t }
      return n % 2 ? a[(n + 1) / 2] : (a[n / 2] + a[n / 2 + 1]) / 2
    }
    function deviation(a, n, m,    i, d, r) {
      for (i = 1; i <= n; ++i) { d = a[i] / m - 1; if (d < 0) d = -d; if (d > r) r = d }
      return r
    }
    FNR == NR { a[++n] = $1; next }
    { b[++k] = $1 }
    END {
      before = median(a, n); after = median(b, k)
      noise = deviation(a, n, before); other = deviation(b, k, after)
      if (other > noise) noise = other
      change = after / before - 1
      verdict = change > noise ? "SLOWER" : change < -noise ? "faster" : "same"
      printf "%.2f -> %.2f sweeps, %+.1f %%, noise %.1f %%: %s\n", before, after, 100 * change, 100 * noise, verdict
      exit verdict == "SLOWER"
    }' "$1" "$2"
}

failed=0
for job in "${jobs[@]}"; do
  read -r -a words <<<"$job"
  rm -f "$work/old" "$work/new"
  for ((i = 0; i < runs; ++i)); do
    sweeps "$old" "${words[@]}" >>"$work/old"
    sweeps "$new" "${words[@]}" >>"$work/new"
  done
  printf '%s: ' "${job#* }" | sed "s|$meshes/||"
  judge "$work/old" "$work/new" || failed=1
done
exit $failed
