// What a disc covers of the picture. A pixel at `offset` from the center's has y = discFromPx * offset; the disc's own
// coordinates there (1: the rim) are y / (1 + slope . y) in perspective, y otherwise.
struct Footprint {
  vec2 centerPx;
  mat2 discFromPx;
  vec2 slope;    // of the depth: relative in perspective, in world units otherwise
  float depth;   // of the center
  float radius;  // world units
};

// As it passes from corners to fragments: in few registers.
mat3x4 pack(Footprint f) {
  return mat3x4(vec4(f.centerPx, f.slope), vec4(f.discFromPx[0], f.discFromPx[1]), vec4(f.depth, f.radius, 0, 0));
}

Footprint unpack(mat3x4 p) {
  return Footprint(p[0].xy, mat2(p[1].xy, p[1].zw), p[0].zw, p[2].x, p[2].y);
}

// Of the screen-space kernel: discs that are drawn large enough cover pixels by themselves.
float screenRadiusOf(Footprint f) {
  float discPx = f.radius * pixelsPerUnit(f.depth);
  return clamp(frame.screenRadiusPx + frame.smallDiscPx - discPx, frame.leastScreenRadiusPx, frame.screenRadiusPx);
}

// Squared distance from the center, 1 at the rim: of the disc or of the least circle in the picture, whichever is less.
// `depth` is where the pixel's ray meets the disc, kept within the disc's radius about the center.
float distanceIn(Footprint f, vec2 px, out float depth) {
  depth = f.depth;
  if (frame.splatMode == kPoints) return 0;
  vec2 offset = px - f.centerPx;
  float screenRadiusPx = screenRadiusOf(f);
  float inScreen = dot(offset, offset) / (screenRadiusPx * screenRadiusPx);
  vec2 y = f.discFromPx * offset;
  float inDisc = dot(y, y);
  if (frame.isPerspective != 0) {
    float nearness = 1 + dot(f.slope, y);
    if (nearness <= 0) return inScreen;
    inDisc /= nearness * nearness;
    depth = f.depth / nearness;
  } else {
    depth += dot(f.slope, y);
  }
  depth = clamp(depth, f.depth - f.radius, f.depth + f.radius);
  return min(inDisc, inScreen);
}
