layout(location = 0) in vec3 stroke_start;
layout(location = 1) in vec3 stroke_end;
layout(location = 2) in vec3 stroke_color;
layout(location = 3) in float stroke_width;  // [pixels]
layout(location = 4) in int stroke_id;
flat out vec2 start, end;  // [pixels]
flat out float width;
flat out vec3 color;
flat out int id;

// Returns the start of the segment from a to b in front of the near plane.
vec4 clipped(vec4 a, vec4 b) {
  float near_a = a.z + a.w, near_b = b.z + b.w;
  return near_a < 0.0 && near_b > 0.0 ? mix(a, b, 1.001 * near_a / (near_a - near_b)) : a;
}

// A rectangle on the screen around the line and its round ends; a point is a line of zero length.
void main() {
  vec4 clip_a = view_projection * vec4(stroke_start, 1.0), clip_b = view_projection * vec4(stroke_end, 1.0);
  vec4 a = clipped(clip_a, clip_b), b = clipped(clip_b, clip_a);
  start = (0.5 + 0.5 * a.xy / a.w) * viewport.xy;
  end = (0.5 + 0.5 * b.xy / b.w) * viewport.xy;
  vec2 along = end - start;
  along = dot(along, along) > 1e-6 ? normalize(along) : vec2(1, 0);
  bool at_end = (gl_VertexID & 1) == 1;
  vec2 across = vec2(-along.y, along.x) * ((gl_VertexID & 2) == 0 ? -1.0 : 1.0);
  vec4 clip = at_end ? b : a;
  vec2 reach = (0.5 * stroke_width + 1.0) * ((at_end ? along : -along) + across);
  width = stroke_width;
  color = stroke_color;
  id = stroke_id;
  // Depth of a point 0.3 % closer to the eye: in front of the surface on which it may lie.
  float nearer = 0.003 * (view_projection * eye).z;
  gl_Position = vec4(clip.xy + 2.0 * reach / viewport.xy * clip.w, clip.z + nearer, clip.w);
}
