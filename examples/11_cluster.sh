#!/usr/bin/env bash
# 11. A cluster: the tests of a comparison in three parts, which may run on three machines.
#
#   examples/11_cluster.sh FOLDER      # with Slurm: tools/batch/submit does the same
set -euo pipefail
scenario=$(dirname "$0")/05_comparison.yaml
folder=$1
mkdir -p "$folder"

# Each part is a shard: it has its own file, and goes on where it was if it is started again.
for shard in 1 2 3; do
  jaywalk compare "$scenario" --shard "$shard/3" --store "$folder/part-$shard.gpkg" --resume --quiet &
done
wait

# Together they are what one run of all tests gives.
jaywalk merge "$folder/all.gpkg" "$folder"/part-{1,2,3}.gpkg --csv "$folder/all.csv"
