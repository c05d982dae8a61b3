layout(location = 0) in vec3 sphere_center;
layout(location = 1) in float sphere_radius;
layout(location = 2) in vec3 sphere_color;
layout(location = 3) in int sphere_id;
layout(location = 4) in vec3 sphere_finish;
layout(location = 5) in vec4 sphere_rotation;
out vec3 position;
flat out vec3 center;
flat out float radius;
flat out vec3 color;
flat out int id;
flat out vec3 finish;
flat out vec4 rotation;

// A square through the center, facing the eye, that covers the sphere's outline (the tangents from the eye).
void main() {
  vec3 axis = eye.xyz - sphere_center * eye.w;
  float ratio = eye.w * sphere_radius * sphere_radius / dot(axis, axis);
  float size = 1.05 * sphere_radius / sqrt(max(1.0 - ratio, 1e-3));
  axis = normalize(axis);
  vec3 right = normalize(cross(abs(axis.y) < 0.9 ? vec3(0, 1, 0) : vec3(1, 0, 0), axis));
  vec3 up = cross(axis, right);
  vec2 corner = vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, (gl_VertexID & 2) == 0 ? -1.0 : 1.0);
  position = sphere_center + size * (corner.x * right + corner.y * up);
  center = sphere_center;
  radius = sphere_radius;
  color = sphere_color;
  id = sphere_id;
  finish = sphere_finish;
  rotation = sphere_rotation;
  gl_Position = view_projection * vec4(position, 1.0);
}
