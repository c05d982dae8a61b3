uniform samplerBuffer scalars, colors;
uniform int selected_tet;
#ifdef NATURAL  // materials in plain light only
const int scalar_kind = 0;
const bool has_piece_colors = false, draw_edges = false, unlit = false, checker = false;
#else
uniform int scalar_kind;
uniform bool has_piece_colors, draw_edges, unlit, checker;
#endif
centroid in vec3 covered;  // a point in the part of the pixel covered by the polygon
in vec3 smooth_normal;
in vec2 uv;
in vec4 own_weights;
in float scalar;
flat in int carrier;
flat in ivec4 labels;  // tet, part, piece, style
uniform float opacity;

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
  matter_index = labels.w & 0xffff;
  if (labels.x == selected_tet || material(10) == 0.0) discard;
  bool inner = ((labels.w >> 20) & 1) != 0;
  vec3 color = material_color(vec3(1.0));
  emit_glass(color, material(10), covered, position, normalize(normal_here() + matter_here(2).slope), inner);
}
#else
void main() {
  matter_index = labels.w & 0xffff;
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
                  plain ? kDull : polish_here());
  }
  color = mix(color, selected ? kSelectionColor : kEdgeColor, (selected ? 1.0 : 0.6) * edge);
  if (!is_drawn(selected, clear)) discard;
  emit(color, opacity, labels.x);
}
#endif
