#!/bin/sh
#SBATCH --array=1-64 --cpus-per-task=1 --requeue --output=shard-%a.log
# A fault campaign as a job array of Slurm, one shard a task; a task that is begun again goes on with its file:
#   sbatch --wait examples/campaigns/array.sh PLAN results
# Next: build/counterpoint campaign merge PLAN results.* --html page.html
# Exit status 1 of a shard is a finding, which the merge tells, and no reason to begin it again.
build/counterpoint campaign "$1" --jobs 1 --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" --out "$2.$SLURM_ARRAY_TASK_ID" || [ $? -eq 1 ]
