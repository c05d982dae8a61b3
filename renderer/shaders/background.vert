uniform mat4 world_from_clip;
out vec3 far_place;

// One triangle that covers the picture.
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  vec4 place = world_from_clip * vec4(corner, 1.0, 1.0);
  far_place = place.xyz / place.w;
  gl_Position = vec4(corner, 0.0, 1.0);
}
