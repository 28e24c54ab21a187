#!/usr/bin/env bash
# A study on a cluster with Slurm: an array of jobs computes one share each, and a job after them puts all together.
#
#   SHARES=16 ./slurm.sh CASE KIND FOLDER [OPTION...]      # OPTION as of plumb study: --set KEY=VALUE
#
# FOLDER must be seen by all nodes; the report ends up in FOLDER/study. Where shares were lost, the last job fails and
# FOLDER/study.missing.jsonl lists their points: the same command again computes just those, in SHARES jobs, and puts all
# together. The program is $PLUMB, or plumb; what the cluster asks for is set as sbatch takes it from the environment:
# SBATCH_PARTITION, SBATCH_TIMELIMIT, SBATCH_ACCOUNT, ... Each share uses all processors that its job has.
set -euo pipefail
case=$1 kind=$2 folder=$3
shares=${SHARES:-8}
study=("${PLUMB:-plumb}" study "$case" "$kind" "${@:4}")
mkdir -p "$folder"

quoted() { printf ' %q' "$@"; }
submit() { sbatch --parsable --output="$folder/job-%j.log" "$@"; }

part=()
name=share
if [ -e "$folder/study.missing.jsonl" ]; then
  part=(--only "$folder/study.missing.jsonl")
  name=missing
fi

shares_id=$(submit --job-name=plumb-$name --array="1-$shares" <<END
#!/bin/bash
exec$(quoted "${study[@]}" "${part[@]}") --share \$SLURM_ARRAY_TASK_ID/$shares -o$(quoted "$folder/$name")-\$SLURM_ARRAY_TASK_ID
END
)
# Whatever became of the shares: what they computed is used. A share that was ended left its journal beside its folder.
merge_id=$(submit --job-name=plumb-merge --dependency="afterany:$shares_id" <<END
#!/bin/bash
shopt -s nullglob
$(quoted "${study[@]}") --merge$(quoted "$folder")/{share,missing}-* -o$(quoted "$folder/study")
status=\$?
[ \$status -gt 1 ] || rm -f$(quoted "$folder/study.missing.jsonl")
exit \$status
END
)
echo "shares: job $shares_id; put together: job $merge_id"
