// What all passes of a frame know, written from render/splat/frame_block.h. View space: x right, y down, z forward.
// Pixel (x, y) has its center at (x + .5, y + .5), y from the top; row 0 of every texture is the top of the picture.
layout(std140, binding = 0) uniform Frame {
  mat3 viewFromWorld;
  vec3 eye;                // world
  float focalPx;
  vec2 principalPx;        // where the line of sight through the eye falls
  vec2 sizePx;
  float nearDepth;
  float depthScale;        // of the depth buffer, see depthOrder
  float depthShift;
  uint isPerspective;
  float leastCosine;
  float screenRadiusPx;
  float depthBand;
  float normalCosine;
  vec3 keyLight;           // towards the light
  float ambient;
  vec3 selectionColor;     // linear
  float selectionShare;
  vec3 brushCenter;        // view space
  float brushRadius;       // 0: no brush
  vec3 brushColor;         // linear
  float diffuse;
  vec4 background;         // linear, straight alpha
  float leastWeight;
  float edgeStrength;      // of the mean response of the neighbors
  uint isLit;
  uint isTwoSided;
  uint splatMode;          // kSplats, kDiscs, kPoints
  uint isBlended;          // the sums hold the surface, otherwise the visible splat alone
  float headLight;         // light from the viewer
  float ringPx;            // width of the line of the brush's ring
  float ringFill;          // how much the surface inside takes on its color
  float visibleShare;      // up to this distanceIn a disc hides what is behind it
  float smallDiscPx;       // see screenRadiusOf
  float leastScreenRadiusPx;
  uint isOneOfMany;        // the frame is part of a mean: weights fall off faster
} frame;

const uint kSplats = 0u, kDiscs = 1u, kPoints = 2u;

// The first channel of a visible texel where no splat is: nothing at all, or a triangle.
const uint kNothing = 0xffffffffu, kTriangle = 0xfffffffeu;

// Falls with depth, in (0, 1]: the nearest is the greatest, with the relative precision of a float.
float depthOrder(float depth) {
  return clamp(frame.depthScale / (frame.depthShift + max(depth, 0)), 0, 1);
}

float pixelsPerUnit(float depth) {
  return frame.isPerspective != 0 ? frame.focalPx / depth : frame.focalPx;
}

// The point of view space at this pixel position and depth.
vec3 fromPixels(vec2 px, float depth) {
  return vec3((px - frame.principalPx) / pixelsPerUnit(depth), depth);
}

// Where a pixel position falls in the space that is clipped.
vec2 clipFromPixels(vec2 px) {
  return 2 * px / frame.sizePx - 1;
}

// Unit, from a point of view space.
vec3 towardsEye(vec3 inView) {
  return frame.isPerspective != 0 ? -normalize(inView) : vec3(0, 0, -1);
}

vec3 linearFromSrgb(vec3 s) {
  return mix(pow((s + 0.055) / 1.055, vec3(2.4)), s / 12.92, lessThanEqual(s, vec3(0.04045)));
}

// A linear color, of which a share is selected.
vec3 withSelection(vec3 color, float selected) {
  return mix(color, frame.selectionColor, frame.selectionShare * selected);
}

// Linear color of a splat (sRGB, share that is selected).
vec3 albedoOf(vec4 color) {
  return withSelection(linearFromSrgb(color.rgb), color.a);
}
