// Crumbs: balls cut by pairs of parallel planes. Orientation and spacing of the planes follow from the color, which is
// different for each crumb.
in vec3 position;
flat in vec3 center;
flat in float radius;
flat in vec3 color;

// Returns the next three pseudo-random numbers in 0..1.
vec3 chance(inout uint state) {
  state = (state ^ (state >> 16)) * 0x7feb352du;
  state = (state ^ (state >> 15)) * 0x846ca68bu;
  state ^= state >> 16;
  return vec3(state & 1023u, (state >> 10) & 1023u, (state >> 20) & 1023u) / 1023.0;
}

// Returns the length of a ray within the chip [m], below 0 if it misses it, and its entry point and plane. `offset`: of
// a point of the ray from the center; `direction`: unit length.
float way_through(vec3 offset, vec3 direction, out float enter, out vec3 normal) {
  const int kPairs = 4;
  float along = dot(offset, direction), square = radius * radius - dot(offset, offset) + along * along;
  float chord = sqrt(max(square, 0.0)), leave = chord - along;
  enter = -chord - along;
  normal = normalize(offset + enter * direction);
  uint state = floatBitsToUint(color.r) ^ 3u * floatBitsToUint(color.g);
  for (int i = 0; i < kPairs; ++i) {
    vec3 axis = normalize(chance(state) - 0.5 + 1e-3);
    float speed = dot(direction, axis);
    speed = abs(speed) < 1e-4 ? 1e-4 : speed;
    float middle = -dot(offset, axis) / speed, reach = radius * mix(0.45, 0.85, chance(state).x) / abs(speed);
    if (middle - reach > enter) normal = speed > 0.0 ? -axis : axis;
    enter = max(enter, middle - reach);
    leave = min(leave, middle + reach);
  }
  return square < 0.0 ? -1.0 : leave - enter;
}

float depth_of(vec3 place) {
  vec4 clip = view_projection * vec4(place, 1.0);
  return clamp(0.5 + 0.5 * clip.z / clip.w, 0.0, 1.0);
}
