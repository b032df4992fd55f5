#version 450 core
#include "splat.glsl"

flat out Footprint footprint;
flat out uvec3 splat;  // node, normal for light (view space, octahedral), color

void main() {
  Disc disc = fetchDisc();
  mat2 pxFromDisc;
  footprint = footprintOf(disc, pxFromDisc);
  splat = uvec3(disc.node, packSnorm2x16(toOctahedron(disc.normal)), disc.color);
  gl_Position = cornerOf(disc, footprint, pxFromDisc);
}
