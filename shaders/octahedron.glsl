// Unit vectors as two numbers in [-1, 1] (Meyer et al. 2010).
vec2 signOf(vec2 t) {
  return mix(vec2(-1), vec2(1), greaterThanEqual(t, vec2(0)));
}

vec3 fromOctahedron(vec2 p) {
  float z = 1 - abs(p.x) - abs(p.y);
  return normalize(vec3(p - signOf(p) * max(-z, 0), z));
}

vec2 toOctahedron(vec3 n) {
  n /= abs(n.x) + abs(n.y) + abs(n.z);
  return n.z >= 0 ? n.xy : (1 - abs(n.yx)) * signOf(n.xy);
}
