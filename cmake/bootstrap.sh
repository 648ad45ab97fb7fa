#!/bin/sh
# From a bare Debian 12 or 13 to a picture, a test run or all checks:
#   sh cmake/bootstrap.sh build|render|test|check
set -eu

root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
build=$root/build

packages='
  ca-certificates cmake fonts-dejavu-core g++ glmark2-data glslang-dev glslang-tools libboost-dev
  libcairo2-dev libcli11-dev libdeflate-dev libembree-dev libfmt-dev libgl1-mesa-dri libglfw3-dev
  libglm-dev libgtest-dev libimgui-dev libjpeg62-turbo-dev libopenexr-dev libpng-dev libpugixml-dev
  libtinyobjloader-dev libvulkan-dev libvulkan-volk-dev libvulkan1 libx11-dev libxxhash-dev
  mesa-vulkan-drivers ninja-build nlohmann-json3-dev pkgconf spirv-tools vulkan-validationlayers
  xvfb'
checkPackages='clang clang-format clang-tidy dpkg-dev file gcovr libclang-rt-dev'

usage() {
  cat >&2 <<'TEXT'
usage: sh cmake/bootstrap.sh COMMAND
  build   install the Debian packages that are missing (as root), build laver into build/
  render  build, then render scenes/bunny-whitted.xml on the CPU
  test    build, then run the tests
  check   install more packages, then clang-tidy and clang-format, the tests under sanitizers,
          line coverage, the Debian package, and a minute of each fuzzer; half an hour or more
TEXT
  exit 2
}

fail() {
  echo "bootstrap.sh: $1" >&2
  exit 1
}

installed() {
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# Uses apt, and thus the network, only if a package is missing.
installPackages() {
  command -v dpkg-query >/dev/null || fail 'this is no Debian system; see README.md for what laver needs'
  missing=''
  for package in $packages; do
    installed "$package" || missing="$missing $package"
  done
  [ -n "$missing" ] || return 0
  [ "$(id -u)" -eq 0 ] || fail "run as root once, or install these packages:$missing"
  export DEBIAN_FRONTEND=noninteractive
  apt-get update
  # shellcheck disable=SC2086 # a list of words
  apt-get install -y --no-install-recommends $missing
}

# SwiftShader, a second Vulkan driver for CPUs, from Debian's chromium-common: its tests run where it is. The
# package itself, which needs a desktop's libraries, is not installed.
fetchSwiftShader() {
  [ ! -e "$build/swiftshader/usr" ] || return 0
  mkdir -p "$build/swiftshader"
  (cd "$build/swiftshader" && apt-get download chromium-common && dpkg-deb -x chromium-common_*.deb . &&
    rm chromium-common_*.deb) ||
    echo 'bootstrap.sh: SwiftShader cannot be had: its tests are left out' >&2
}

# Builds the given targets.
buildLaver() {
  installPackages
  cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release
  cmake --build "$build" --parallel "$jobs" --target "$@"
}

render() {
  picture=$build/bunny-whitted.exr
  "$build/laver" "$root/scenes/bunny-whitted.xml" --device cpu -o "$picture"
  echo "Wrote $picture and ${picture%.exr}.png"
}

buildPreset() {
  echo "== $1"
  cmake --preset "$1"
  cmake --build --preset "$1" --parallel "$jobs"
}

testPreset() {
  buildPreset "$1"
  ctest --preset "$1" -j "$jobs"
}

# The contents of the package must render without this tree.
checkPackage() {
  buildPreset package
  rm -f build-package/*.deb
  cpack --preset package
  unpacked="build-package/unpacked"
  rm -rf "$unpacked"
  dpkg-deb -x build-package/*.deb "$unpacked"
  "$unpacked/usr/bin/laver" "$unpacked/usr/share/laver/scenes/cornell-two-lights.xml" \
    --device cpu --size 64x64 -o "$unpacked/picture.exr"
  dpkg-deb -I build-package/*.deb
}

# New inputs of a fuzzer and files that crash it are kept in build-fuzz/.
fuzz() {
  found=build-fuzz/found-$1
  mkdir -p "$found"
  build-fuzz/tests/fuzz/"fuzz_$1" -max_total_time=60 -timeout=10 -print_final_stats=1 \
    -dict=tests/fuzz/"$1.dict" -artifact_prefix=build-fuzz/ "$found" "tests/fuzz/$1"
}

check() {
  packages="$packages $checkPackages"
  installPackages
  cd "$root"
  buildPreset tidy
  testPreset asan
  testPreset coverage
  cmake --build --preset coverage --target coverage
  checkPackage
  buildPreset fuzz
  fuzz scene
  fuzz obj
  fuzz picture
  echo 'All checks passed.'
}

# One job per processor, but at most one per 1.5 GiB of memory, the need of a compiler.
countJobs() {
  jobs=$(nproc)
  memory=$(awk '/^MemAvailable:/ { print int($2 / 1572864) }' /proc/meminfo 2>/dev/null || :)
  if [ -n "$memory" ] && [ "$memory" -lt "$jobs" ]; then jobs=$memory; fi
  if [ "$jobs" -lt 1 ]; then jobs=1; fi
}

[ $# -eq 1 ] || usage
case $1 in
  build | render | test | check) ;;
  *) usage ;;
esac
countJobs
# Mesa warns if this is not set; a private empty folder suffices.
if [ -z "${XDG_RUNTIME_DIR:-}" ]; then
  XDG_RUNTIME_DIR=$(mktemp -d)
  export XDG_RUNTIME_DIR
  trap 'rm -rf "$XDG_RUNTIME_DIR"' EXIT
  trap 'exit 130' HUP INT TERM
fi
case $1 in
  build) buildLaver laver laver_meshes ;;
  render)
    buildLaver laver laver_meshes
    render
    ;;
  check) check ;;
  test)
    installPackages
    fetchSwiftShader
    buildLaver all
    ctest --test-dir "$build" --output-on-failure -LE full -j "$jobs"
    ;;
esac
