#!/usr/bin/env bash
# Draws one run by builds of different compilers and optimisation, and holds their pictures against each other:
# tests/builds.sh. Builds into build/builds; ends with 1 where pictures differ.
set -euo pipefail
cd "$(dirname "$0")/.."

jobs=${PLUMB_JOBS:-$(nproc)}
names=() left_out=()

# NAME COMPILER C_COMPILER OPTIMISATION
build() {
  if ! command -v "$2" >/dev/null; then
    left_out+=("$1: $2 is not installed")
    return
  fi
  echo "builds: $1"
  local log=build/builds/$1.log
  if ! { cmake -S . -B "build/builds/$1" -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_COMPILER="$2" \
           -DCMAKE_C_COMPILER="$3" -DCMAKE_CXX_FLAGS="$4 -DNDEBUG" &&
         cmake --build "build/builds/$1" --target plumb -j "$jobs"; } >"$log" 2>&1; then
    grep -m 3 'error' "$log" >&2 || tail -n 5 "$log" >&2
    echo "builds: $1 cannot be built; see $log" >&2
    exit 1
  fi
  names+=("$1")
}

mkdir -p build/builds
build gcc-O3 g++ gcc -O3
build gcc-O0 g++ gcc -O0
build clang-O3 clang++ clang -O3
build clang-O0 clang++ clang -O0

# One run, drawn by all. Fields, ghosts and an orbit are where digits could tell.
cd build/builds
first=${names[0]}
"$first/plumb" solve ../../cases/pendulum.toml --set time.end=0.4 --set scene.ghosts=2 --set scene.color_by=curvature \
  --set 'scene.camera="orbit"' -o run --quiet
for name in "${names[@]}"; do
  rm -rf "drawn-$name"
  "$name/plumb" render run -o "drawn-$name" --quiet
done

status=0
printf '%-10s %8s %8s  %s\n' build pictures differ "plumb diff against $first"
for name in "${names[@]}"; do
  pictures=0 differing=0
  while read -r file; do
    pictures=$((pictures + 1))
    cmp -s "drawn-$first/$file" "drawn-$name/$file" || differing=$((differing + 1))
  done < <(cd "drawn-$first" && find . -name '*.png' -o -name '*.csv')
  said=$("$first/plumb" diff "drawn-$first" "drawn-$name" 2>&1) || status=1
  if [ "$differing" -gt 0 ]; then status=1; fi
  printf '%-10s %8d %8d  %s\n' "$name" "$pictures" "$differing" "$(tail -n 1 <<<"$said")"
done
for reason in ${left_out[@]+"${left_out[@]}"}; do echo "left out: $reason"; done
exit $status
