uniform isamplerBuffer tets, carriers;
uniform samplerBuffer points, scalars;
uniform samplerBuffer materials;
uniform int selected_tet, drawn_part;  // a DrawnPart
uniform int scalar_kind;  // 0: none, 1: per tet, 2: per point
layout(location = 0) in vec3 corner_rest;
layout(location = 1) in vec4 weights;
layout(location = 2) in vec4 other_weights;
layout(location = 3) in ivec4 corner_labels;  // tet, part, piece, style
layout(location = 4) in vec4 normal_products;  // products with the edges of the tet at rest
layout(location = 5) in vec4 other_normal_products;
layout(location = 6) in vec2 corner_uv;
out vec3 position;
centroid out vec3 covered;
out vec3 smooth_normal;  // zero: none
out vec2 uv;
out vec3 rest;
out vec4 own_weights;
out float scalar;
out float gl_ClipDistance[1];
flat out int carrier;
flat out ivec4 labels;

vec3 point_at(int index) {
  return vec3(texelFetch(points, 3 * index).r, texelFetch(points, 3 * index + 1).r, texelFetch(points, 3 * index + 2).r);
}

// Transforms a normal with the cofactors of the deformation gradient.
vec3 carried_normal(vec3 products, vec3 places[4]) {
  if (products == vec3(0.0)) return vec3(0.0);
  vec3 a = places[1] - places[0], b = places[2] - places[0], c = places[3] - places[0];
  vec3 normal = products.x * cross(b, c) + products.y * cross(c, a) + products.z * cross(a, b);
  return normalize(normal) * sign(dot(a, cross(b, c)));
}

// False if the polygon, whose corners have one material, is transparent and what is drawn is not, or the other way
// round: its fragments would be shaded for nothing. Selection, which differs between corners, is left to fragments.
bool is_drawn() {
  if (drawn_part < 3 || selected_tet >= 0) return true;
  return (drawn_part == 4) == (texelFetch(materials, 16 * (corner_labels.w & 0xffff) + 10).r > 0.0);
}

void main() {
  carrier = texelFetch(carriers, corner_labels.y).r;
  vec4 share = carrier == corner_labels.x ? weights : other_weights;
  vec3 places[4];
  position = vec3(0.0);
  for (int i = 0; i < 4; ++i) {
    places[i] = point_at(texelFetch(tets, 4 * carrier + i).r);
    position += share[i] * places[i];
  }
  scalar = 0.0;
  for (int i = 0; i < (scalar_kind == 2 ? 4 : 0); ++i)
    scalar += share[i] * texelFetch(scalars, texelFetch(tets, 4 * carrier + i).r).r;
  covered = position;
  smooth_normal = carried_normal(carrier == corner_labels.x ? normal_products.xyz : other_normal_products.xyz, places);
  uv = corner_uv;
  rest = corner_rest;
  own_weights = weights;
  labels = corner_labels;
  gl_ClipDistance[0] = visible.w - dot(visible.xyz, position);
  gl_Position = is_drawn() ? view_projection * vec4(position, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);  // outside
}
