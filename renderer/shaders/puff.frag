in vec2 place;
flat in vec3 center;
flat in vec4 color;
layout(location = 0) out vec4 pixel_color;
layout(location = 1) out int pixel_id;

// Denser towards the middle; light comes from all sides.
void main() {
  float density = max(1.0 - dot(place, place), 0.0);
  if (density == 0.0) discard;
  vec3 light_here = kSkyLight + 0.5 * kLampLight * light_visibility(center, light.xyz);
  pixel_color = vec4(srgb_from_linear(linear_from_srgb(mix(color.rgb, vec3(1.0), 0.25)) * light_here), color.a * density * density);
  pixel_id = -1;
}
