// Corners of the triangle about a splat's footprint, from gl_VertexID alone: three for each entry of the node list.
#include "frame.glsl"
#include "octahedron.glsl"
#include "footprint.glsl"

struct Splat {
  float x, y, z;
  float radius;
  uint shape;
  uint color;
};
layout(std430, binding = 0) readonly buffer Splats { Splat splats[]; };
layout(std430, binding = 1) readonly buffer Nodes { uint nodes[]; };
layout(location = 0) uniform uint firstNode;  // of the buffer of splats

// A splat in view space.
struct Disc {
  uint node;
  vec3 center;
  float radius;
  vec3 normal;  // unit, for light: turned to the eye where light is two-sided
  vec3 plane;   // unit, of what is drawn: turned to the eye, by the least cosine at least
  uint color;
};

vec3 unpackNormal(uint shape) {
  return fromOctahedron(vec2(shape & 0xfffu, shape >> 12 & 0xfffu) * (2.0 / 4095) - 1);
}

// normalize(normal + s toEye) with the s that makes its cosine to the eye the least one.
vec3 tilt(vec3 normal, vec3 toEye) {
  float cosine = dot(normal, toEye);
  if (cosine >= frame.leastCosine) return normal;
  float sine = sqrt(max(1 - cosine * cosine, 0));
  float s = frame.leastCosine * sine / sqrt(1 - frame.leastCosine * frame.leastCosine) - cosine;
  return normalize(normal + s * toEye);
}

Disc fetchDisc() {
  uint node = nodes[gl_VertexID / 3];
  Splat s = splats[node - firstNode];
  Disc disc;
  disc.node = node;
  disc.center = frame.viewFromWorld * (vec3(s.x, s.y, s.z) - frame.eye);
  disc.radius = s.radius;
  disc.color = s.color;
  vec3 normal = frame.viewFromWorld * unpackNormal(s.shape);
  vec3 toEye = towardsEye(disc.center);
  vec3 turned = dot(normal, toEye) < 0 ? -normal : normal;
  disc.normal = frame.isTwoSided != 0 ? turned : normal;
  disc.plane = tilt(turned, toEye);
  return disc;
}

// Also what takes the disc's coordinates to pixels from its center, to first order.
Footprint footprintOf(Disc disc, out mat2 pxFromDisc) {
  // Any orthonormal basis of the plane (Duff et al. 2017).
  vec3 n = disc.plane;
  float s = n.z >= 0 ? 1 : -1;
  float a = -1 / (s + n.z), b = n.x * n.y * a;
  vec3 t0 = vec3(1 + s * n.x * n.x * a, s * b, -s * n.x);
  vec3 t1 = vec3(b, s + n.y * n.y * a, -n.y);

  Footprint f;
  float scale = pixelsPerUnit(disc.center.z);
  f.depth = disc.center.z;
  f.radius = disc.radius;
  f.centerPx = frame.principalPx + scale * disc.center.xy;
  pxFromDisc = mat2(t0.xy, t1.xy);
  f.slope = disc.radius * vec2(t0.z, t1.z);
  if (frame.isPerspective != 0) {
    vec2 direction = disc.center.xy / disc.center.z;
    pxFromDisc -= mat2(t0.z * direction, t1.z * direction);
    f.slope /= -disc.center.z;
  }
  pxFromDisc *= scale * disc.radius;
  f.discFromPx = inverse(pxFromDisc);
  return f;
}

// Half axes, in pixels, of an ellipse about the center that holds the whole footprint.
void boundFootprint(Footprint f, mat2 pxFromDisc, out vec2 longAxis, out vec2 shortAxis) {
  mat2 rows = transpose(pxFromDisc);
  float xx = dot(rows[0], rows[0]), yy = dot(rows[1], rows[1]), xy = dot(rows[0], rows[1]);
  float mean = 0.5 * (xx + yy), difference = 0.5 * (xx - yy);
  float deviation = sqrt(difference * difference + xy * xy);
  // Along half the angle of (difference, xy).
  float cosine2 = deviation > 0 ? difference / deviation : 1;
  vec2 direction = vec2(sqrt(max(0.5 + 0.5 * cosine2, 0)), sqrt(max(0.5 - 0.5 * cosine2, 0)));
  if (xy < 0) direction.y = -direction.y;

  // |y| <= 1 + slope . y is an ellipse with one focus at the center that reaches 1 / (1 - |slope|).
  float reach = frame.isPerspective != 0 ? 1 / (1 - length(f.slope)) : 1;
  float longPx = reach * sqrt(mean + deviation), shortPx = reach * sqrt(max(mean - deviation, 0));
  longAxis = max(longPx, frame.screenRadiusPx) * direction;
  shortAxis = max(shortPx, frame.screenRadiusPx) * vec2(-direction.y, direction.x);
}

// A corner of the triangle about the footprint, where it falls in the space that is clipped; all three outside where
// nothing is to be drawn. The triangle lies flat, `ahead` radii in front of the center: what is hidden there may be passed
// over by the depth test before its fragments are shaded.
vec4 cornerOf(Disc disc, Footprint f, mat2 pxFromDisc, float ahead) {
  if (!(disc.center.z > frame.nearDepth && disc.radius > 0)) return vec4(2, 2, 0, 1);
  const float kMargin = 1.001;  // rounding
  float order = min(kMargin * depthOrder(f.depth - ahead * f.radius), 1);
  const vec2 kCorners[3] = vec2[](vec2(2, 0), vec2(-1, 1.7320508), vec2(-1, -1.7320508));  // about the unit circle
  vec2 corner = kCorners[gl_VertexID % 3];
  if (frame.splatMode == kPoints) {
    // Reaches the center of one pixel and of no other.
    return vec4(clipFromPixels(floor(f.centerPx) + 0.5 + 0.25 * corner), order, 1);
  }
  const float kSteepest = 0.9;  // beyond, the disc all but passes beside the eye and any pixel may see it
  if (frame.isPerspective != 0 && dot(f.slope, f.slope) > kSteepest * kSteepest) return vec4(1.5 * corner, order, 1);
  vec2 longAxis, shortAxis;
  boundFootprint(f, pxFromDisc, longAxis, shortAxis);
  vec2 offset = kMargin * (corner.x * longAxis + corner.y * shortAxis);
  return vec4(clipFromPixels(f.centerPx + offset), order, 1);
}
