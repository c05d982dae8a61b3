uniform vec3 top, bottom;
uniform float sky_share;  // 1: the sky of the environment, 0: a gradient
in vec3 far_place;
layout(location = 0) out vec4 pixel_color;

// The gradient is mixed in the encoding, in which equal steps look equal. It begins below the horizon, where the ground fades into it.
void main() {
  vec3 direction = normalize(far_place - eye.xyz);
  vec3 color = mix(bottom, top, smoothstep(-0.08, 0.5, direction.y));
#ifndef PLAIN_LIGHT
  color = mix(color, displayed(environment(direction, 0.0)), sky_share);
#endif
  pixel_color = vec4(color, 1.0);
}
