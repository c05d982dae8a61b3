uniform isamplerBuffer tets, carriers;
uniform samplerBuffer points, scalars;
uniform int scalar_kind;  // 0: none, 1: per tet, 2: per point
layout(location = 0) in vec3 corner_rest;
layout(location = 1) in vec4 weights;
layout(location = 2) in vec4 other_weights;
layout(location = 3) in ivec4 corner_labels;  // tet, part, piece, style
out vec3 position;
out vec3 rest;
out vec4 own_weights;
out float scalar;
out float gl_ClipDistance[1];
flat out int carrier;
flat out ivec4 labels;

vec3 point_at(int index) {
  return vec3(texelFetch(points, 3 * index).r, texelFetch(points, 3 * index + 1).r, texelFetch(points, 3 * index + 2).r);
}

void main() {
  carrier = texelFetch(carriers, corner_labels.y).r;
  vec4 share = carrier == corner_labels.x ? weights : other_weights;
  position = vec3(0.0);
  scalar = 0.0;
  for (int i = 0; i < 4; ++i) {
    int point = texelFetch(tets, 4 * carrier + i).r;
    position += share[i] * point_at(point);
    if (scalar_kind == 2) scalar += share[i] * texelFetch(scalars, point).r;
  }
  rest = corner_rest;
  own_weights = weights;
  labels = corner_labels;
  gl_ClipDistance[0] = visible.w - dot(visible.xyz, position);
  gl_Position = view_projection * vec4(position, 1.0);
}
