// Appearance of a material at a point of a surface.
in vec3 position;
in vec3 rest;  // position at rest, to which patterns are fixed
uniform samplerBuffer materials;
int matter_index;  // of the material; set by main()

float material(int index) { return texelFetch(materials, 16 * matter_index + index).r; }

Polish polish_here() { return Polish(material(13), material(14), material(15)); }

#ifdef GRAIN
// Transforms a slope in rest coordinates to the rotated polygon.
vec3 carried_slope(vec3 slope) {
  vec3 x = dFdx(position), y = dFdy(position), normal = flat_normal(position);
  vec3 across = cross(y, normal);
  float area = dot(x, across);
  if (area == 0.0) return vec3(0.0);
  return (dot(slope, dFdx(rest)) * across + dot(slope, dFdy(rest)) * cross(normal, x)) / area;
}
#endif

#ifdef PLAIN_LIGHT
Matter matter_here(int octaves) { return Matter(vec3(1.0), vec3(0.0)); }
#else
#ifdef GRAIN
// Grain is visible if pixels resolve it in their narrow direction. Along the long direction of faces seen at a grazing
// angle, several points are averaged (anisotropic filtering: Heckbert 1989).
Matter with_grain(Matter matter, vec3 fiber, vec4 n) {
  const float kMost = 6.0;
  vec3 x = dFdx(rest), y = dFdy(rest);
  vec3 along = dot(x, x) > dot(y, y) ? x : y;
  float length_along = max(length(along), 1e-12), across = length(cross(x, y)) / length_along;
  float places = clamp(ceil(length_along / max(across, 1e-12)), 1.0, kMost);
  vec3 color = vec3(material(0), material(1), material(2)), facing = normalize(cross(x, y) + 1e-20);
  Matter sum = Matter(vec3(0.0), vec3(0.0));
  for (float i = 0.0; i < places; ++i) {
    Matter one = matter;
    vec3 place = rest + ((i + 0.5) / places - 0.5) * along;
    add_grain(one, int(material(11)), place, material(12), fiber, max(across, length_along / places), n, color, facing);
    sum.tint += one.tint;
    sum.slope += one.slope;
  }
  return Matter(sum.tint / places, sum.slope / places);
}
#endif

// `octaves` of noise: 2, or 0 if a value is shown.
Matter matter_here(int octaves) {
  vec3 fiber = vec3(material(7), material(8), material(9));
  vec3 place = (rest - fiber * dot(fiber, rest)) / material(6);
  float width = 0.7 * length(fwidth(place));
  vec4 n = vec4(0.0);
  for (int i = 0; i < octaves; ++i) {
    float scale = i == 0 ? 1.0 : 2.3;
    n += seen(scale * width) / float(i + 1) * noise(scale * place + 11.0 * float(i));
  }
  Matter matter = Matter(vec3(1.0 + material(4) * n.w), 2.0 * material(5) * n.xyz);
#ifdef GRAIN
  matter = with_grain(matter, fiber, n);
  matter.slope = carried_slope(matter.slope);
#endif
  return matter;
}
#endif
