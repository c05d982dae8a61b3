// Common functions of the fragment shaders of surfaces.
const vec3 kCrackTint = vec3(0.80, 0.66, 0.55), kEdgeColor = vec3(0.09, 0.10, 0.12);
const vec3 kSelectionColor = vec3(1.0, 0.55, 0.10);

// Part drawn in this pass, a DrawnPart.
#ifdef NATURAL
const int drawn_part = 0;
#else
uniform int drawn_part;
#endif
bool is_drawn(bool selected, bool clear) {
  if (drawn_part >= 3) return (drawn_part == 4) == clear;
  return drawn_part == 0 || (drawn_part == 1) == selected;
}

uniform sampler2D color_table;
uniform vec2 scalar_range;
uniform vec3 nan_color;
uniform float edge_width;  // [pixels]

// Returns the table's entry without interpolation: the legend shows the same bytes.
vec3 scalar_color(float value) {
  if ((floatBitsToUint(value) & 0x7fffffffu) > 0x7f800000u) return nan_color;
  int size = textureSize(color_table, 0).x;
  float t = clamp((value - scalar_range.x) / (scalar_range.y - scalar_range.x), 0.0, 1.0);
  return texelFetch(color_table, ivec2(min(int(t * float(size)), size - 1), 0), 0).rgb;
}

// Returns the fraction of the pixel on a marked edge. Lines thin out for very small triangles.
float edge_coverage(vec3 barycentric, vec3 marked) {
  vec3 dx = dFdx(barycentric), dy = dFdy(barycentric);
  vec3 per_pixel = max(sqrt(dx * dx + dy * dy), 1e-7);
  vec3 coverage = marked * (1.0 - smoothstep(0.5 * edge_width - 0.5, 0.5 * edge_width + 0.5, barycentric / per_pixel));
  float height = 1.0 / max(per_pixel.x, max(per_pixel.y, per_pixel.z));
  return max(coverage.x, max(coverage.y, coverage.z)) * smoothstep(4.0, 14.0, height);
}

// Returns the normal of the visible side of the triangle.
vec3 flat_normal(vec3 position) {
  vec3 normal = normalize(cross(dFdx(position), dFdy(position)));
  return dot(normal, towards_eye(position)) < 0.0 ? -normal : normal;
}

// Polish of a face: glaze, varnish or metal.
struct Polish {
  float gloss;      // 0: none, 1: smooth
  float roughness;  // 0..1
  float metal;      // 1: light is reflected in the color of the material
};
const Polish kDull = Polish(0.0, 1.0, 0.0);

// Shades a color: a plain one with the full range of light, a scalar's with the upper part alone so that values stay
// comparable.
vec3 shade(vec3 color, vec3 position, vec3 normal, vec3 bump, bool is_scalar, Polish polish) {
  float visibility = light_visibility(position, flat_normal(position)), openness = ambient_openness(position);
  vec3 bumped = normalize(normal + bump);
  if (is_scalar) {
    float factor = mix(0.62, 1.0, min(illumination(bumped, visibility), 1.0));
#ifdef PLAIN_LIGHT
    return reflected(color, vec3(factor));
#else
    return srgb_from_linear(linear_from_srgb(color) * factor);
#endif
  }
  vec3 factor = colored_illumination(bumped, visibility, openness);
#ifdef PLAIN_LIGHT
  return reflected(color, factor);
#else
  vec3 matter = linear_from_srgb(color);
  vec3 least = mix(vec3(kDielectric), matter, polish.metal);
  vec3 mirrored = polish.gloss * mirrored_light(least, position, bumped, polish.roughness, visibility, openness);
  return displayed(matter * factor * (1.0 - 0.85 * polish.metal) + mirrored);
#endif
}
