uniform vec3 center;
uniform float radius;  // [m]
out vec3 position;

void main() {
  position = center + radius * vec3((gl_VertexID & 1) == 0 ? -1.0 : 1.0, 0.0, (gl_VertexID & 2) == 0 ? -1.0 : 1.0);
  gl_Position = view_projection * vec4(position, 1.0);
}
