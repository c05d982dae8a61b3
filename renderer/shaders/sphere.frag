in vec3 position;
flat in vec3 center;
flat in float radius;
flat in vec3 color;
flat in int id;
layout(location = 0) out vec4 pixel_color;
layout(location = 1) out int pixel_id;

// Exact intersection of the pixel's ray with the sphere; alpha is the pixel's coverage at the outline.
void main() {
  vec3 direction = -towards_eye(position);
  vec3 offset = position - center;
  vec3 closest = offset - dot(offset, direction) * direction;
  float miss = length(closest);
  float coverage = clamp(0.5 + (radius - miss) / max(fwidth(miss), 1e-9), 0.0, 1.0);
  if (coverage < (viewport.z > 1.0 ? 0.05 : 0.5)) discard;
  vec3 surface = closest - sqrt(max(radius * radius - miss * miss, 0.0)) * direction;
  vec4 clip = view_projection * vec4(center + surface, 1.0);
  gl_FragDepth = clamp(0.5 + 0.5 * clip.z / clip.w, 0.0, 1.0);
  vec3 normal = normalize(surface);
  vec3 light_here = colored_illumination(normal, light_visibility(center + surface, normal), ambient_openness(center + surface));
  float gleam = pow(max(dot(reflect(direction, normal), light.xyz), 0.0), 40.0);
  pixel_color = vec4(srgb_from_linear(linear_from_srgb(color) * light_here + 0.12 * gleam), coverage);
  pixel_id = id;
}
