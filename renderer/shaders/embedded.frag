const float kHalf = 0.5;

uniform samplerBuffer scalars, colors, materials;
uniform int selected_tet;
#ifdef NATURAL  // materials in plain light only
const int scalar_kind = 0;
const bool has_piece_colors = false, draw_edges = false, unlit = false, checker = false;
#else
uniform int scalar_kind;
uniform bool has_piece_colors, draw_edges, unlit, checker;
#endif
in vec3 position;
centroid in vec3 covered;  // a point in the part of the pixel covered by the polygon
in vec3 smooth_normal;
in vec2 uv;
in vec3 rest;
in vec4 own_weights;
in float scalar;
flat in int carrier;
flat in ivec4 labels;  // tet, part, piece, style
uniform float opacity;

float material(int index) { return texelFetch(materials, 14 * (labels.w & 0xffff) + index).r; }

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
  Matter sum = Matter(vec3(0.0), vec3(0.0));
  for (float i = 0.0; i < places; ++i) {
    Matter one = matter;
    vec3 place = rest + ((i + 0.5) / places - 0.5) * along;
    add_grain(one, int(material(11)), place, material(12), fiber, max(across, length_along / places), n);
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

vec3 value_color() { return scalar_color(scalar_kind == 1 ? texelFetch(scalars, carrier).r : scalar); }

vec3 piece_color(bool inner) {
  int first = 3 * labels.z;
  vec3 color = vec3(texelFetch(colors, first).r, texelFetch(colors, first + 1).r, texelFetch(colors, first + 2).r);
  return inner ? color * kCrackTint : color;
}

vec3 material_color(vec3 tint) {
  float piece = float(hash(ivec3(labels.z, 7, 3)) & 0xffffu) / 65535.0 - 0.5;
  return vec3(material(0), material(1), material(2)) * (2.0 * material(3) * piece + tint);
}

float face_edge() {
  int face = ((labels.w >> 16) & 7) - 1;
  if (!draw_edges || face < 0) return 0.0;
  vec3 barycentric = face == 0 ? own_weights.yzw : face == 1 ? own_weights.xzw : face == 2 ? own_weights.xyw : own_weights.xyz;
  return edge_coverage(barycentric, vec3(1.0));
}

// Returns the normal on the visible side.
vec3 normal_here() {
  vec3 facet = flat_normal(position);
  if (dot(smooth_normal, smooth_normal) < 0.25) return facet;
  vec3 normal = normalize(smooth_normal);
  return dot(normal, facet) < 0.0 ? -normal : normal;
}

// Squares of a sixteenth of the texture, antialiased if a pixel contains several.
vec3 checked(vec3 color) {
  vec2 place = 16.0 * uv;
  vec2 width = max(fwidth(place), 1e-4);
  vec2 wave = abs(fract(place / 2.0) - 0.5) * 4.0 - 1.0;
  vec2 side = clamp(wave / width, -1.0, 1.0);
  return color * mix(0.55, 1.0, 0.5 + 0.5 * side.x * side.y);
}

#ifdef GLASS
void main() {
  if (labels.x == selected_tet || material(10) == 0.0) discard;
  bool inner = ((labels.w >> 20) & 1) != 0;
  vec3 color = material_color(vec3(1.0));
  emit_glass(color, material(10), covered, position, normalize(normal_here() + matter_here(2).slope), inner);
}
#else
void main() {
  bool inner = ((labels.w >> 20) & 1) != 0;
  bool selected = labels.x == selected_tet;
  bool is_scalar = scalar_kind != 0;
  bool clear = !selected && material(10) > 0.0;
  float edge = face_edge();
  Matter here = Matter(vec3(1.0), vec3(0.0));
  bool plain = is_scalar || (has_piece_colors && !inner);
  if (!plain) here = matter_here(is_scalar ? 0 : 2);
  vec3 color = is_scalar ? value_color() : has_piece_colors ? piece_color(inner) : material_color(here.tint);
  if (checker && ((labels.w >> 21) & 1) != 0) color = checked(color);
  if (!(unlit && is_scalar)) {
    color = shade(selected ? mix(color, kSelectionColor, 0.45) : color, position, normal_here(), here.slope, is_scalar,
                  plain ? 0.0 : material(13));
  }
  color = mix(color, selected ? kSelectionColor : kEdgeColor, (selected ? 1.0 : 0.6) * edge);
  if (!is_drawn(selected, clear)) discard;
  emit(color, opacity, labels.x);
}
#endif
