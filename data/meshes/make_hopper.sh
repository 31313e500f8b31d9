#!/bin/sh
# Draws data/meshes/hopper.stl, in millimeters, about z: a round hopper of 32 sides. From the rim at the top a bin of
# radius 25 down to z = 70, a funnel of half angle 20 degrees down to radius 9, a spout to z = 20. Open above and below.
# Usage: data/meshes/make_hopper.sh > data/meshes/hopper.stl
awk 'BEGIN {
  pi = atan2(0, -1); sides = 32
  slope = cos(pi / 9) / sin(pi / 9)
  spout = 70 - (25 - 9) * slope
  r[0] = 25; z[0] = 120; r[1] = 25; z[1] = 70; r[2] = 9; z[2] = spout; r[3] = 9; z[3] = 20
  print "solid hopper"
  for (k = 0; k < 3; ++k)
    for (n = 0; n < sides; ++n) {
      # from inside counterclockwise: normals to the fibers
      a = corner(k, n); b = corner(k, n + 1); c = corner(k + 1, n + 1); d = corner(k + 1, n)
      facet(a, b, c); facet(a, c, d)
    }
  print "endsolid hopper"
}
function corner(k, n,  angle) {
  angle = 2 * pi * (n % sides) / sides
  return sprintf("%.6f %.6f %.6f", r[k] * cos(angle), r[k] * sin(angle), z[k])
}
function facet(a, b, c) {
  printf "facet normal 0 0 0\nouter loop\nvertex %s\nvertex %s\nvertex %s\nendloop\nendfacet\n", a, b, c
}'
