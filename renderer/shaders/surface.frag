const int kCrackFace = 8, kSelected = 16, kPlain = 32, kClear = 64;  // TriangleFlag; bits 0 to 2 are the edges

uniform samplerBuffer scalars, colors;
uniform isamplerBuffer ids;
uniform usamplerBuffer flags;
#ifdef NATURAL  // colors in plain light only
const int scalars_per_triangle = 0;
const bool draw_edges = false, unlit = false;
#else
uniform int scalars_per_triangle;
uniform bool draw_edges, unlit;
#endif
uniform bool has_colors, has_ids, has_flags;
uniform vec3 plain_color;
uniform float opacity, clear_depth;
centroid in vec3 covered;  // a point in the part of the pixel covered by the triangle
in vec3 barycentric;
in float scalar;
flat in int triangle;
flat in int matter;  // index of the material; negative: none

vec3 triangle_color(int triangle_flags, bool is_scalar) {
  if (is_scalar && scalars_per_triangle == 3) return scalar_color(scalar);
  if (is_scalar) return scalar_color(texelFetch(scalars, triangle).r);
  int first = 3 * triangle;
  vec3 color = has_colors ? vec3(texelFetch(colors, first).r, texelFetch(colors, first + 1).r,
                                 texelFetch(colors, first + 2).r) : plain_color;
  return (triangle_flags & kCrackFace) != 0 ? color * kCrackTint : color;
}

#ifdef GLASS
void main() {
  int triangle_flags = has_flags ? int(texelFetch(flags, triangle).r) : 0;
  if ((triangle_flags & kClear) == 0 || (triangle_flags & kSelected) != 0) discard;
  emit_glass(triangle_color(0, false), clear_depth, covered, position, flat_normal(position), (triangle_flags & kCrackFace) != 0);
}
#else
void main() {
  int triangle_flags = has_flags ? int(texelFetch(flags, triangle).r) : 0;
  bool selected = (triangle_flags & kSelected) != 0;
  bool clear = !selected && (triangle_flags & kClear) != 0;
  bool is_scalar = scalars_per_triangle != 0 && (triangle_flags & kPlain) == 0;
  vec3 color = triangle_color(triangle_flags, is_scalar);
  vec3 marked = vec3(triangle_flags & 1, (triangle_flags >> 1) & 1, (triangle_flags >> 2) & 1);
  Matter here = Matter(vec3(1.0), vec3(0.0));
  Polish polish = kDull;
#ifdef GRAIN
  matter_index = max(matter, 0);
  if (matter >= 0) {
    here = matter_here(2);
    polish = polish_here();
  }
  color *= here.tint;
#endif
  float edge = draw_edges ? edge_coverage(barycentric, marked) : 0.0;
  if (!(unlit && is_scalar)) {
    color = shade(selected ? mix(color, kSelectionColor, 0.45) : color, position, flat_normal(position), here.slope,
                  is_scalar, polish);
  }
  color = mix(color, selected ? kSelectionColor : kEdgeColor, (selected ? 1.0 : 0.6) * edge);
  if (!is_drawn(selected, clear)) discard;
  emit(color, opacity, has_ids ? texelFetch(ids, triangle).r : -1);
}
#endif
