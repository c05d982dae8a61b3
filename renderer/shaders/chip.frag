flat in int id;
layout(location = 0) out vec4 pixel_color;
layout(location = 1) out int pixel_id;

// Alpha is the pixel's coverage at the outline.
void main() {
  vec3 direction = -towards_eye(position), normal;
  float enter;
  float way = way_through(position - center, direction, enter, normal);
  float coverage = clamp(0.5 + way / max(fwidth(way), 1e-9), 0.0, 1.0);
  vec3 surface = position + enter * direction;
  vec3 light_here = colored_illumination(normal, light_visibility(surface, normal), ambient_openness(surface));
  if (coverage < (viewport.z > 1.0 ? 0.05 : 0.5)) discard;
  gl_FragDepth = depth_of(surface);
  pixel_color = vec4(reflected(color, light_here), coverage);
  pixel_id = id;
}
