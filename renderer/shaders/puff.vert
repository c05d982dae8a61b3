layout(location = 0) in vec3 puff_center;
layout(location = 1) in float puff_radius;
layout(location = 2) in vec3 puff_color;
layout(location = 3) in float puff_opacity;
out vec2 place;
flat out vec3 center;
flat out float radius;
flat out vec4 color;

void main() {
  vec3 axis = normalize(eye.xyz - puff_center * eye.w);
  vec3 right = normalize(cross(abs(axis.y) < 0.9 ? vec3(0, 1, 0) : vec3(1, 0, 0), axis));
  place = vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, (gl_VertexID & 2) == 0 ? -1.0 : 1.0);
  center = puff_center;
  radius = puff_radius;
  color = vec4(puff_color, puff_opacity);
  gl_Position = view_projection * vec4(puff_center + puff_radius * (place.x * right + place.y * cross(axis, right)), 1.0);
}
