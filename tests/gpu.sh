#!/bin/sh
# Checks and measures laver on another machine, such as a bare one with a GPU:
#   sh tests/gpu.sh pack FOLDER                   where laver is built: all that a run needs, libraries included
#   sh FOLDER/gpu.sh run OUT.json [DEVICE]        there; DEVICE as for --device, by default the first
# Both machines need the same architecture, and the other one a glibc that is no older and a Vulkan driver. As root
# there: the tests look for their files under the path of the tree that they were built in, where a run puts a link.
# OUT.json has each step with its exit code, seconds and last lines, and the statistics of the renders.
set -eu

here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)

fail() {
  echo "gpu.sh: $1" >&2
  exit 1
}

pack() {
  tree=$(dirname "$here")
  build=$tree/build
  [ -x "$build/tests/stability/stability_tests" ] || fail "$build has no tests: sh cmake/bootstrap.sh test"
  mkdir -p "$1/lib" "$1/tree/build/tests/stability" "$1/tree/tests"
  programs='laver tests/picture_tests tests/stability/stability_tests'
  for program in $programs; do
    cp "$build/$program" "$1/tree/build/$program"
    # Not the C library, which belongs to the dynamic linker of the other machine.
    ldd "$build/$program" | awk '$2 == "=>" && $3 ~ /^\// { print $3 }' |
      grep -Ev '/(libc|libm|libdl|libpthread|librt)\.so' | xargs cp -Lu -t "$1/lib"
  done
  loader=$(ldconfig -p | awk '/libvulkan\.so\.1 / { print $NF; exit }')
  [ -z "$loader" ] || cp -Lu "$loader" "$1/lib/libvulkan.so.1"
  cp -R "$tree/scenes" "$tree/README.md" "$1/tree"
  cp -R "$tree/tests/suite" "$tree/tests/trace" "$1/tree/tests"
  echo "$tree" > "$1/built-in"
  cp "$here/gpu.sh" "$1/gpu.sh"
}

# Text as a string of JSON.
quoted() {
  tr -d '\000-\010\013-\037' | tr '\t' ' ' | sed 's/\\/\\\\/g; s/"/\\"/g' |
    awk '{ printf "%s%s", s, $0; s = "\\n" }'
}

# step NAME SECONDS COMMAND...: one entry, whatever the exit code. The seconds of all steps add up to ten minutes.
step() {
  name=$1 limit=$2
  shift 2
  echo "== $name" >&2
  start=$(date +%s)
  code=0
  timeout -k 5 "$limit" "$@" > "$work/log" 2>&1 || code=$?
  tail -n 3 "$work/log" >&2
  printf '%s{"name": "%s", "exit": %s, "seconds": %s, "limit": %s, "output": "%s"}' "$comma" "$name" "$code" \
    "$(($(date +%s) - start))" "$limit" "$(tail -n 25 "$work/log" | quoted)" >> "$work/steps"
  comma=', '
}

# A render's statistics, twice: the first run compiles.
measure() {
  scene=$1
  shift
  for run in first second; do
    step "$scene $* $run" 20 "$tree/build/laver" "$tree/scenes/$scene.xml" --device "$device" -q "$@" \
      -o "$work/p.exr" "--stats=$work/stats"
    [ ! -s "$work/stats" ] ||
      printf '%s{"scene": "%s %s", "run": "%s", "stats": %s}' "$between" "$scene" "$*" "$run" "$(cat "$work/stats")" \
        >> "$work/figures"
    rm -f "$work/stats"
    between=', '
  done
}

run() {
  out=$1
  [ -f "$here/built-in" ] || fail 'this is no packed folder: sh tests/gpu.sh pack FOLDER'
  tree=$(cat "$here/built-in")
  device=${2:-0}
  if [ ! -e "$tree" ]; then
    mkdir -p "$(dirname "$tree")"
    ln -s "$here/tree" "$tree"
  fi
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
  export XDG_CACHE_HOME="$work/cache" XDG_RUNTIME_DIR="$work" LAVER_TEST_DEVICE="$device"
  export LD_LIBRARY_PATH="$here/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
  comma='' between=''
  : > "$work/steps"
  : > "$work/figures"
  step devices 10 "$tree/build/laver" devices
  step check 60 "$tree/build/laver" devices --check
  for traversal in lane packet32 packet64; do
    measure bunny-whitted --spp 64 --traversal "$traversal"
  done
  measure cornell-ao --spp 64
  measure box-glass --spp 64
  step pictures 130 "$tree/build/tests/picture_tests" '--gtest_filter=Scenes.*:Scenes/EveryScene.*:PathScenes.*'
  step stability 200 "$tree/build/tests/stability/stability_tests" \
    '--gtest_filter=Stability.*-Stability.Spirv:Stability.Trees'
  printf '{"machine": "%s", "processors": %s, "steps": [%s], "figures": [%s]}\n' "$(uname -srm | quoted)" \
    "$(nproc)" "$(cat "$work/steps")" "$(cat "$work/figures")" > "$out"
  echo "Wrote $out"
}

case ${1:-} in
  pack) [ $# -eq 2 ] || fail 'pack FOLDER'; pack "$2" ;;
  run) [ $# -ge 2 ] || fail 'run OUT.json [DEVICE]'; run "$2" "${3:-}" ;;
  *) fail 'pack FOLDER, or run OUT.json [DEVICE]' ;;
esac
