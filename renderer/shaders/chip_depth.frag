void main() {
  vec3 direction = -towards_eye(position), normal;
  float enter;
  if (way_through(position - center, direction, enter, normal) < 0.0) discard;
  gl_FragDepth = depth_of(position + enter * direction);
}
