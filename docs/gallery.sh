#!/bin/sh
# gallery.sh [FOLDER]: the pictures of docs/gallery.md, in docs/plots/gallery or another folder. Needs fdebench and node on the PATH.
set -eu
cd "$(dirname "$0")"
folder=${1:-plots/gallery}
mkdir -p "$folder"

draw() {
  name=$1
  shift
  fdebench plot "examples/$name.toml" "$@" --out "$folder/$name.svg"
}

draw duffing --kind phase --columns "x,D(x,1)"
draw zener --kind solution --columns x,r
draw falling --kind solution
draw plate --kind solution
draw subdiffusion --kind solution --columns "u[6],u[5],u[4],u[2]"
draw epidemic --kind solution --columns S,I,R
draw delayed_growth --kind solution
draw radiation --kind solution --x-axis log
draw control --kind solution
draw measured_load --kind solution --columns x
draw roessler --kind phase --columns x,y
draw multi_order --kind solution
draw sleigh --kind motion
node plots/shorten.mjs "$folder"/*.svg
