#!/bin/sh
# error_against_time.sh [OUT]: the figure of README.md, in ten seconds. Needs fdebench and node on the PATH.
set -eu
out=${1:-error_against_time.svg}
results=$(mktemp -d)
trap 'rm -r "$results"' EXIT

fdebench run --quiet --scene pendulum --scheme adams_pc --scheme l1 --scheme grunwald_letnikov --scheme product_trapezoidal \
  --scheme newton_gregory_3 --scheme bdf4 --scheme bdf6 --repeat 9 --out "$results/runs.jsonl" \
  --steps 64,128,256,512,1024,2048,4096,8192,16384,32768,65536,131072
fdebench run --quiet --scene pendulum --scheme spectral_collocation --repeat 9 --out "$results/runs.jsonl" \
  --accuracy 1e-2,1e-3,1e-4,1e-5,1e-6,1e-7,1e-8,1e-9,1e-10,1e-11,1e-12
fdebench plot pendulum --results "$results/runs.jsonl" --kind work-precision --norm end --width 7 \
  --y-label '|e| / (1 + |y|) at t = 20' --out "$out"
