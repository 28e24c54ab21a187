#!/usr/bin/env bash
# Builds Plumb on Debian 12 and does what is asked; installs the packages that are missing (packages.txt).
#   ./make.sh report   runs the pendulum and ends with where its report is
#   ./make.sh test     runs the whole test suite
#   ./make.sh build    builds only
#   ./make.sh bench    measures the kernels, one step of each method, and frames
#   ./make.sh gallery  draws every kind of frame and figure onto one page, output/gallery/index.html
#   ./make.sh fuzz S   runs every fuzz target for S seconds in all and ends with a table (clang; tests/fuzz)
#   ./make.sh deb      makes Debian packages, build/deb: the program, and its engine for C++ programs
#   ./make.sh builds   builds with gcc and clang, optimised and not, and compares what they draw (many minutes)
set -euo pipefail
cd "$(dirname "$0")"

preset=${PLUMB_PRESET:-release}

# Installs what is missing of the packages of the program, and of those of the sections that are named.
install_missing_packages() {
  if ! command -v dpkg-query >/dev/null; then
    echo "make.sh: this is no Debian system; the packages of packages.txt are taken to be there" >&2
    return
  fi
  local missing=() package
  while read -r package; do
    if [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" != installed ]; then
      missing+=("$package")
    fi
  done < <(awk -v wanted=" $* " '
    { sub(/#.*/, "") }
    /^\[/ { gsub(/[][]/, ""); skip = !index(wanted, " " $1 " "); next }
    NF && !skip { print $1 }' packages.txt)
  if [ ${#missing[@]} -eq 0 ]; then return; fi

  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "make.sh: these packages are missing, and there is neither root nor sudo to install them: ${missing[*]}" >&2
      exit 1
    fi
    as_root=(sudo)
  fi
  mkdir -p build
  local log=build/packages.log
  echo "make.sh: installing ${missing[*]}"
  echo "make.sh: with all they need this can take some minutes; what apt-get says is in $log"
  if ! {
    ${as_root[@]+"${as_root[@]}"} apt-get update &&
      ${as_root[@]+"${as_root[@]}"} env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"
  } >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    echo "make.sh: the packages could not be installed; all of apt-get's output is in $log" >&2
    exit 1
  fi
}

# As many compilers at once as there are processors, and 1.5 GB of memory for each.
parallel_jobs() {
  local processors memory
  processors=$(nproc)
  memory=$(awk '/^MemAvailable/ { print int($2 / 1500000) }' /proc/meminfo 2>/dev/null || echo "$processors")
  if [ "$memory" -lt "$processors" ]; then processors=$memory; fi
  if [ "$processors" -lt 1 ]; then processors=1; fi
  echo "$processors"
}

# Builds the program alone, or the targets that are named.
build_program() {
  install_missing_packages
  # A build that has the tests keeps them.
  if [ -e "build/$preset/CMakeCache.txt" ]; then cmake --preset "$preset"; else cmake --preset "$preset" -DPLUMB_TESTS=OFF; fi
  cmake --build --preset "$preset" -j "$(parallel_jobs)" --target "${@:-plumb}"
}

# Builds the targets that are named, or everything with all tests.
build_with_tests() {
  install_missing_packages tests
  cmake --preset "$preset" -DPLUMB_TESTS=ON
  cmake --build --preset "$preset" -j "$(parallel_jobs)" ${1+--target "$@"}
  build_seconds=$SECONDS
}

case ${1:-} in
  report)
    build_program
    "build/$preset/plumb" run cases/pendulum.toml
    ;;
  test)
    build_with_tests
    tests=0
    ctest --preset "$preset" -j "$(nproc)" || tests=$?
    echo "make.sh: what took longest: $(sort -k3,3nr "build/$preset/Testing/Temporary/CTestCostData.txt" |
      awk 'NF == 3 && ++n <= 5 { printf "%s%s %.0f s", (n > 1 ? ", " : ""), $1, $3 }')"
    echo "make.sh: the build was done after $build_seconds s, all after $SECONDS s"
    exit "$tests"
    ;;
  build)
    build_program
    ;;
  bench)
    build_with_tests plumb plumb_bench
    "build/$preset/tests/plumb_bench" --benchmark_min_time=0.2 --benchmark_counters_tabular=true "${@:2}"
    # The yardstick for frames_to_disk, in the same run; for those who have it.
    if python3 -c 'import matplotlib' 2>/dev/null; then
      "build/$preset/plumb" solve cases/pendulum.toml --quiet --csv build/bench_probes.csv
      python3 tests/bench/matplotlib_frames.py build/bench_probes.csv 40
    else
      echo "matplotlib is not installed (python3-matplotlib): its frames a second are not measured"
    fi
    ;;
  gallery)
    build_program
    tests/gallery.sh "build/$preset/plumb" output/gallery
    ;;
  fuzz)
    build_with_tests plumb
    preset=fuzz build_with_tests plumb_fuzz
    tests/fuzz/run.py build/fuzz/tests/fuzz/plumb_fuzz "${2:-150}" "${@:3}"
    ;;
  deb)
    install_missing_packages deb
    build_program plumb plumb_texts
    rm -rf build/deb
    cpack --config "build/$preset/CPackConfig.cmake" -B build/deb
    lintian --fail-on error build/deb/*.deb
    ls -sh build/deb/*.deb
    ;;
  builds)
    install_missing_packages tests
    tests/builds.sh
    ;;
  *)
    if [ $# -gt 0 ]; then echo "make.sh: '$1' is none of report, test, build, bench, gallery, fuzz, deb and builds" >&2; fi
    sed -n '2,/^set/ { /^#/ s/^# \{0,1\}//p }' "$0" >&2
    exit 2
    ;;
esac
