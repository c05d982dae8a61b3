const int kCrackFace = 8, kSelected = 16;  // TriangleFlag; bits 0 to 2 are the edges
const vec3 kCrackTint = vec3(0.80, 0.66, 0.55), kEdgeColor = vec3(0.09, 0.10, 0.12);
const vec3 kSelectionColor = vec3(1.0, 0.55, 0.10);

uniform samplerBuffer scalars, colors;
uniform isamplerBuffer ids;
uniform usamplerBuffer flags;
uniform sampler2D color_table;
uniform int scalars_per_triangle;
uniform bool has_colors, has_ids, has_flags, draw_edges, unlit;
uniform vec2 scalar_range;
uniform vec3 plain_color, nan_color;
uniform float edge_width;  // [pixels]
in vec3 position;
in vec3 barycentric;
in float scalar;
layout(location = 0) out vec4 pixel_color;
layout(location = 1) out int pixel_id;

// The table's entry, exactly: the legend shows the same bytes.
vec3 scalar_color(float value) {
  if ((floatBitsToUint(value) & 0x7fffffffu) > 0x7f800000u) return nan_color;
  int size = textureSize(color_table, 0).x;
  float t = clamp((value - scalar_range.x) / (scalar_range.y - scalar_range.x), 0.0, 1.0);
  return texelFetch(color_table, ivec2(min(int(t * float(size)), size - 1), 0), 0).rgb;
}

vec3 triangle_color(int triangle_flags) {
  if (scalars_per_triangle == 3) return scalar_color(scalar);
  if (scalars_per_triangle == 1) return scalar_color(texelFetch(scalars, gl_PrimitiveID).r);
  int first = 3 * gl_PrimitiveID;
  vec3 color = has_colors ? vec3(texelFetch(colors, first).r, texelFetch(colors, first + 1).r,
                                 texelFetch(colors, first + 2).r) : plain_color;
  return (triangle_flags & kCrackFace) != 0 ? color * kCrackTint : color;
}

// How much of the pixel lies on a marked edge. Lines thin out where triangles get too small to tell apart.
float edge_coverage(int triangle_flags) {
  vec3 dx = dFdx(barycentric), dy = dFdy(barycentric);
  vec3 per_pixel = max(sqrt(dx * dx + dy * dy), 1e-7);
  vec3 marked = vec3(triangle_flags & 1, (triangle_flags >> 1) & 1, (triangle_flags >> 2) & 1);
  vec3 coverage = marked * (1.0 - smoothstep(0.5 * edge_width - 0.5, 0.5 * edge_width + 0.5, barycentric / per_pixel));
  float height = 1.0 / max(per_pixel.x, max(per_pixel.y, per_pixel.z));
  return max(coverage.x, max(coverage.y, coverage.z)) * smoothstep(4.0, 14.0, height);
}

// A plain colour takes the whole range of light, a scalar's colour only its upper part so that values stay comparable.
vec3 shade(vec3 color) {
  vec3 normal = normalize(cross(dFdx(position), dFdy(position)));
  if (dot(normal, towards_eye(position)) < 0.0) normal = -normal;
  float light_here = illumination(normal, light_visibility(position, normal));
  float factor = scalars_per_triangle == 0 ? light_here : mix(0.62, 1.0, min(light_here, 1.0));
  return srgb_from_linear(linear_from_srgb(color) * factor);
}

void main() {
  int triangle_flags = has_flags ? int(texelFetch(flags, gl_PrimitiveID).r) : 0;
  bool selected = (triangle_flags & kSelected) != 0;
  bool exact = unlit && scalars_per_triangle != 0;
  vec3 color = triangle_color(triangle_flags);
  float edge = draw_edges ? edge_coverage(triangle_flags) : 0.0;
  if (!exact) color = shade(selected ? mix(color, kSelectionColor, 0.45) : color);
  color = mix(color, selected ? kSelectionColor : kEdgeColor, (selected ? 1.0 : 0.6) * edge);
  pixel_color = vec4(color, 1.0);
  pixel_id = has_ids ? texelFetch(ids, gl_PrimitiveID).r : -1;
}
