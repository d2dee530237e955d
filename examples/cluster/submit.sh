#!/usr/bin/env bash
# Renders a picture on a Slurm cluster: an array of parts, then their assembly.
#   submit.sh PARTS SCENE PICTURE [OPTION...]       options of `srt part`, such as --aa 16 --by samples
# Submitted again after a failure, only what is missing is rendered.
set -euo pipefail

if [ "$#" -lt 3 ]; then
    printf 'usage: %s PARTS SCENE PICTURE [OPTION...]\n' "$0" >&2
    exit 2
fi
parts="$1" scene="$2" picture="$3"
shift 3
here="$(cd "$(dirname "$0")" && pwd)"
folder="$picture.parts"

array="$(SRT_PARTS="$parts" sbatch --parsable --export=ALL --array="1-$parts" "$here/part.slurm" "$scene" "$folder" "$@")"
sbatch --parsable --job-name=srt-assemble --dependency="afterok:$array" --cpus-per-task=1 \
    --wrap "srt assemble '$folder'/part-*.srtp -o '$picture'"
