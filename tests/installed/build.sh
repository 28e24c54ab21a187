#!/usr/bin/env bash
# Builds the example of this folder against an installed Plumb and runs it: tests/installed/build.sh BUILD_OF_PLUMB.
set -euo pipefail
build=$1
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cmake --install "$build" --prefix "$work/prefix" >"$work/install.log"
cmake -G Ninja -S "$here" -B "$work/example" -DCMAKE_PREFIX_PATH="$work/prefix" "${@:2}" >"$work/configure.log" || {
  cat "$work/configure.log"
  exit 1
}
cmake --build "$work/example"
"$work/example/hanging_cable"
# Moved to where it was installed, the program finds its cases from anywhere.
cd "$work"
"$work/prefix/bin/plumb" check pendulum
