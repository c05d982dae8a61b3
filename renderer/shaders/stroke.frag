flat in vec2 start, end;  // [pixels]
flat in float width;
flat in vec3 color;
flat in int id;
layout(location = 0) out vec4 pixel_color;
layout(location = 1) out int pixel_id;

void main() {
  vec2 along = end - start, offset = gl_FragCoord.xy - start;
  float t = clamp(dot(offset, along) / max(dot(along, along), 1e-6), 0.0, 1.0);
  float coverage = clamp(0.5 * width + 0.5 - length(offset - t * along), 0.0, 1.0);
  if (coverage < 0.02) discard;
  pixel_color = vec4(color, coverage);
  pixel_id = id;
}
