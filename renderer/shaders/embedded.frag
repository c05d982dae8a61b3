const float kHalf = 0.5;

uniform samplerBuffer scalars, colors, materials;
uniform int scalar_kind, selected_tet;
uniform bool has_piece_colors, draw_edges, unlit, checker;
in vec3 position;
in vec3 smooth_normal;
in vec2 uv;
in vec3 rest;
in vec4 own_weights;
in float scalar;
flat in int carrier;
flat in ivec4 labels;  // tet, part, piece, style
uniform float opacity;

uint hash(ivec3 place) {
  uint n = uint(place.x) * 73856093u ^ uint(place.y) * 19349663u ^ uint(place.z) * 83492791u;
  n = (n ^ (n >> 15)) * 0x2c1b3c6du;
  n = (n ^ (n >> 12)) * 0x297a2d39u;
  return n ^ (n >> 15);
}

vec4 lattice_value(ivec3 place) {
  uint n = hash(place);
  return vec4(n & 255u, (n >> 8) & 255u, (n >> 16) & 255u, n >> 24) / 255.0 - 0.5;
}

// Four smooth random values at a place, each from -1/2 to 1/2.
vec4 noise(vec3 place) {
  ivec3 cell = ivec3(floor(place));
  vec3 t = place - floor(place);
  t = t * t * (3.0 - 2.0 * t);
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 8; ++i) {
    ivec3 corner = ivec3(i & 1, (i >> 1) & 1, i >> 2);
    vec3 share = mix(1.0 - t, t, vec3(corner));
    sum += share.x * share.y * share.z * lattice_value(cell + corner);
  }
  return sum;
}

float material(int index) { return texelFetch(materials, 11 * (labels.w & 0xffff) + index).r; }

// Bump (xyz) and change of brightness (w) of the material here.
vec4 texture_here() {
  vec3 fibre = vec3(material(7), material(8), material(9));
  vec3 place = (rest - fibre * dot(fibre, rest)) / material(6);
  vec4 n = noise(place) + 0.5 * noise(2.3 * place + 11.0);
  return vec4(2.0 * material(5) * n.xyz, material(4) * n.w);
}

vec3 value_color() { return scalar_color(scalar_kind == 1 ? texelFetch(scalars, carrier).r : scalar); }

vec3 piece_color(bool inner) {
  int first = 3 * labels.z;
  vec3 color = vec3(texelFetch(colors, first).r, texelFetch(colors, first + 1).r, texelFetch(colors, first + 2).r);
  return inner ? color * kCrackTint : color;
}

vec3 material_color(float change) {
  float piece = float(hash(ivec3(labels.z, 7, 3)) & 0xffffu) / 65535.0 - 0.5;
  return vec3(material(0), material(1), material(2)) * (1.0 + 2.0 * material(3) * piece + change);
}

float face_edge() {
  int face = ((labels.w >> 16) & 7) - 1;
  if (!draw_edges || face < 0) return 0.0;
  vec3 barycentric = face == 0 ? own_weights.yzw : face == 1 ? own_weights.xzw : face == 2 ? own_weights.xyw : own_weights.xyz;
  return edge_coverage(barycentric, vec3(1.0));
}

// On the side that is seen.
vec3 normal_here() {
  vec3 facet = flat_normal(position);
  if (dot(smooth_normal, smooth_normal) < 0.25) return facet;
  vec3 normal = normalize(smooth_normal);
  return dot(normal, facet) < 0.0 ? -normal : normal;
}

// Squares of a sixteenth of the texture, smoothed where a pixel holds several.
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
  vec4 here = texture_here();
  emit_glass(material_color(0.0), material(10), position, normalize(normal_here() + here.xyz), inner);
}
#else
void main() {
  bool inner = ((labels.w >> 20) & 1) != 0;
  bool selected = labels.x == selected_tet;
  bool is_scalar = scalar_kind != 0;
  bool clear = !selected && material(10) > 0.0;
  float edge = face_edge();
  vec4 here = is_scalar || (has_piece_colors && !inner) ? vec4(0.0) : texture_here();
  vec3 color = is_scalar ? value_color() : has_piece_colors ? piece_color(inner) : material_color(here.w);
  if (checker && ((labels.w >> 21) & 1) != 0) color = checked(color);
  if (!(unlit && is_scalar)) {
    color = shade(selected ? mix(color, kSelectionColor, 0.45) : color, position, normal_here(), here.xyz, is_scalar);
  }
  color = mix(color, selected ? kSelectionColor : kEdgeColor, (selected ? 1.0 : 0.6) * edge);
  if (!is_drawn(selected, clear)) discard;
  emit(color, opacity, labels.x);
}
#endif
