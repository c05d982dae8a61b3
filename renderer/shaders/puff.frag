in vec2 place;
flat in vec3 center;
flat in vec4 color;
layout(location = 0) out vec4 pixel_color;
layout(location = 1) out int pixel_id;

// Between 0 and 1, another one for each pixel and puff (interleaved gradient noise: Jimenez 2014).
float noise() {
  vec2 at = gl_FragCoord.xy + 64.0 * fract(center.xy + center.zz);
  return fract(52.9829189 * fract(dot(at, vec2(0.06711056, 0.00583715))));
}

// Denser towards the middle; light comes from all sides. Many faint puffs lie on one another, of which rounding would
// take the channels that differ most first, so that dust would fade to another hue: each pixel has few of them instead.
void main() {
  float density = max(1.0 - dot(place, place), 0.0);
  if (density == 0.0) discard;
  vec3 light_here = kSkyLight + 0.5 * kLampLight * light_visibility(center, light.xyz);
  const float kSteps = 32.0;
  float alpha = floor(kSteps * color.a * density * density + noise()) / kSteps;
  pixel_color = vec4(srgb_from_linear(linear_from_srgb(mix(color.rgb, vec3(1.0), 0.45)) * light_here), alpha);
  pixel_id = -1;
}
