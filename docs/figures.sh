#!/bin/sh
# figures.sh FOLDER [FORMAT]: the figures of Yin, Liu & Anh 2007 and of the motions of docs/papers.md, as svg, pdf or vl.json. The
# references of the families take a minute where they are not kept on disk. Needs fdebench on the PATH.
set -eu
folder=$1
format=${2:-pdf}
mkdir -p "$folder"

draw() {
  name=$1
  shift
  fdebench plot "$@" --out "$folder/$name.$format"
}

# Example 1: the pendulum, its derivatives of order 1/2, 1 and 3/2, its energy, and families in beta and alpha.
draw figure_7_1 pendulum --kind solution
draw figure_7_2 pendulum --kind solution --columns energy
draw figure_7_3 pendulum --kind solution --set beta=0:1:0.2
draw figure_7_4 pendulum --kind solution --set alpha=1:2:0.2

# Example 2: the extensible pendulum.
draw figure_7_5 extensible_pendulum --kind solution --columns phi,xi
draw figure_7_6 extensible_pendulum --kind solution --columns phi,Dbeta_phi,dphi,Dalpha_phi
draw figure_7_7 extensible_pendulum --kind solution --columns xi,Dbeta_xi,dxi,Dalpha_xi
draw figure_7_8 extensible_pendulum --kind solution --columns energy
draw figure_7_9 extensible_pendulum --kind solution --columns phi,xi --set beta=0:1:0.2
draw figure_7_10 extensible_pendulum --kind solution --columns phi,xi --set alpha=1:2:0.2

# Phase portraits.
draw phase_pendulum pendulum --kind phase
draw phase_extensible_pendulum extensible_pendulum --kind phase --columns phi,xi

# Motions under constraints, and their multipliers.
draw path_knife_edge knife_edge --kind motion
draw path_rolling_disc rolling_disc:pull=0.4 --kind motion
draw path_loxodrome loxodrome --kind motion
draw path_blade_on_sphere blade_on_sphere --kind motion
draw path_particle nonholonomic_particle --kind motion
draw multiplier_knife_edge knife_edge --kind solution --columns lambda
draw multipliers_rolling_disc rolling_disc:pull=0.4 --kind solution --columns lambda1,lambda2
draw multiplier_with_memory fractional_constraint_2d --kind solution --columns lambda
