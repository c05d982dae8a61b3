in vec3 position;
flat in vec3 center;
flat in float radius;

void main() {
  vec3 direction = -towards_eye(position);
  vec3 offset = position - center;
  vec3 closest = offset - dot(offset, direction) * direction;
  float square = radius * radius - dot(closest, closest);
  if (square < 0.0) discard;
  vec4 clip = view_projection * vec4(center + closest - sqrt(square) * direction, 1.0);
  gl_FragDepth = clamp(0.5 + 0.5 * clip.z / clip.w, 0.0, 1.0);
}
