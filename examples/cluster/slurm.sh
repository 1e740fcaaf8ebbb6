#!/usr/bin/env bash
# Evaluates a file of episodes as an array of Slurm jobs, a shard each, and joins them when all are done. Tasks that Slurm ends early go on
# where they were when they are started again.
#
#   EPISODES=tasks.jsonl RESULTS=results sbatch --array=1-16 examples/cluster/slurm.sh
#   EPISODES=tasks.jsonl RESULTS=results POLICY=classical REALISM=standard sbatch --array=1-16 examples/cluster/slurm.sh
#   SHARDS=16 EPISODES=tasks.jsonl RESULTS=results sbatch --array=3,7 examples/cluster/slurm.sh     # two of them once more
#
#SBATCH --job-name=marketgen
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=4
#SBATCH --mem=8G
#SBATCH --time=12:00:00
#SBATCH --requeue
set -euo pipefail
: "${EPISODES:?a file of marketgen episodes}" "${RESULTS:?a folder that all nodes see}"
shards=$RESULTS.shards
shard=$SLURM_ARRAY_TASK_ID
of=${SHARDS:-$SLURM_ARRAY_TASK_COUNT}
cores=${SLURM_CPUS_PER_TASK:-1}
mkdir -p "$shards"

# With a summary the shard is whole, also where eval ends with an error since some episodes could not be run: they are results, too.
status=0
marketgen eval --episodes "$EPISODES" --policy "${POLICY:-oracle}" --realism "${REALISM:-ideal}" --shard "$shard/$of" \
  --jobs "$cores" --threads "$cores" --resume --quiet -o "$shards/$shard" || status=$?
[ -e "$shards/$shard/summary.json" ] || exit "$status"
touch "$shards/$shard.done"

# Whoever is last joins them; the lock is there when two are last at once.
(
  flock 9
  finished=("$shards"/*.done)
  if [ "${#finished[@]}" -eq "$of" ] && [ ! -e "$RESULTS" ]; then
    folders=("${finished[@]%.done}")
    marketgen merge "${folders[@]}" --quiet -o "$RESULTS"
  fi
) 9> "$shards/lock"
exit "$status"
