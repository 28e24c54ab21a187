#!/usr/bin/env bash
# A study in shares by GNU parallel, on this machine or on several:
#
#   SHARES=16 ./parallel.sh CASE KIND FOLDER [OPTION...]                       # OPTION as of plumb study: --set KEY=VALUE
#   SHARES=16 HOSTS=anna,otto,: ./parallel.sh CASE KIND FOLDER [OPTION...]     # by ssh; ":" is this machine
#
# The report ends up in FOLDER/study. A share uses all processors, so each machine computes one at a time. Several hosts
# must see the working folder under the same name, and have the same program, $PLUMB or plumb. (Where they share no
# files, --transferfile CASE, --return and --cleanup of parallel take them there and back.) Given again, the command
# computes what is missing and no more.
set -euo pipefail
case=$1 kind=$2 folder=$3
shares=${SHARES:-8}
study=("${PLUMB:-plumb}" study "$case" "$kind" "${@:4}")
mkdir -p "$folder"

where=()
if [ -n "${HOSTS:-}" ]; then where=(--sshlogin "$HOSTS" --workdir "$PWD"); fi
# A share that fails is tried again, on another machine if there is one; it goes on where it was.
parallel --quote --jobs 1 --retries 3 --joblog "$folder/shares.log" "${where[@]}" \
  "${study[@]}" --share "{}/$shares" -o "$folder/share-{}" ::: $(seq "$shares") || true
"${study[@]}" --merge "$folder"/share-* -o "$folder/study"
