#version 450 core
#include "splat.glsl"

flat out mat3x4 packedFootprint;
flat out uvec3 splat;  // node, normal for light (view space, octahedral), color

void main() {
  Disc disc = fetchDisc();
  mat2 pxFromDisc;
  Footprint footprint = footprintOf(disc, pxFromDisc);
  packedFootprint = pack(footprint);
  splat = uvec3(disc.node, packSnorm2x16(toOctahedron(disc.normal)), disc.color);
  gl_Position = cornerOf(disc, footprint, pxFromDisc, 1);
}
