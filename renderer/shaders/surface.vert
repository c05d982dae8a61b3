uniform samplerBuffer scalars;
uniform int scalars_per_triangle;  // 0: none; 1; 3: one per corner
uniform isamplerBuffer matters;
uniform bool has_matters;
layout(location = 0) in vec3 corner;
layout(location = 1) in vec3 corner_rest;
out vec3 position;
out vec3 rest;
flat out int matter;
centroid out vec3 covered;
out vec3 barycentric;
out float scalar;
flat out int triangle;  // index of the triangle: gl_PrimitiveID would make software GL copy all vertices
out float gl_ClipDistance[1];

void main() {
  triangle = gl_VertexID / 3;
  int k = gl_VertexID % 3;
  position = covered = corner;
  rest = corner_rest;
  matter = has_matters ? texelFetch(matters, triangle).r : -1;
  barycentric = vec3(k == 0, k == 1, k == 2);
  scalar = scalars_per_triangle == 3 ? texelFetch(scalars, gl_VertexID).r : 0.0;
  gl_ClipDistance[0] = visible.w - dot(visible.xyz, corner);
  gl_Position = view_projection * vec4(corner, 1.0);
}
