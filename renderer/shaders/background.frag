uniform vec3 top, bottom;
uniform float sky_share;  // 1: the sky of the environment, 0: a gradient
in vec3 far_place;
layout(location = 0) out vec4 pixel_color;

#ifndef PLAIN_LIGHT
// Thin high clouds on a plane far above the eye, drawn out by wind: their share of the sky in a direction.
float clouds(vec3 direction) {
  vec2 place = mat2(0.86, -0.51, 0.51, 0.86) * direction.xz / (direction.y + 0.12) * vec2(0.45, 1.0) + 3.7;
  float sum = 0.0, scale = 1.0;
  for (int i = 0; i < (sky_share > 0.0 ? 6 : 0); ++i) {
    sum += speckle(scale * place + 0.6 * sum) / scale;
    scale *= 2.1;
    place = mat2(0.8, -0.6, 0.6, 0.8) * place;
  }
  return smoothstep(-0.05, 0.65, sum) * smoothstep(0.02, 0.35, direction.y);
}

vec3 sky(vec3 direction) {
  const vec3 kCloud = vec3(0.80, 0.82, 0.85);
  direction.y = max(direction.y, 0.07);  // haze hides the ground far away
  direction = normalize(direction);
  return displayed(mix(environment(direction, 0.0), kCloud, 0.6 * clouds(direction)));
}
#endif

// The gradient is mixed in the encoding, in which equal steps look equal. It begins below the horizon, where the ground fades into it.
void main() {
  vec3 direction = normalize(far_place - eye.xyz);
  vec3 color = mix(bottom, top, smoothstep(-0.08, 0.5, direction.y));
#ifndef PLAIN_LIGHT
  color = mix(color, sky(direction), sky_share);
#endif
  pixel_color = vec4(color, 1.0);
}
