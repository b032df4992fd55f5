#version 450 core
#include "splat.glsl"

flat out mat3x4 packedFootprint;
flat out uint node;
flat out vec3 normal;
flat out vec3 albedo;

void main() {
  Disc disc = fetchDisc();
  mat2 pxFromDisc;
  Footprint footprint = footprintOf(disc, pxFromDisc);
  packedFootprint = pack(footprint);
  node = disc.node;
  normal = disc.normal;
  albedo = albedoOf(unpackUnorm4x8(disc.color));
  gl_Position = cornerOf(disc, footprint, pxFromDisc, 1 + frame.depthBand);
}
