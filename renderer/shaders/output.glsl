// Output of a fragment shader. Opaque, it writes color and id; TRANSPARENT, the two weighted sums for blend.frag
// (McGuire & Bavoil 2013), with larger weights for near fragments.
#ifdef TRANSPARENT
layout(location = 0) out vec4 color_sum;  // rgb: sum; a: product of the background's fractions
layout(location = 1) out float weight_sum;

void emit(vec3 color, float opacity, int id) {
  float nearness = 1.0 - gl_FragCoord.z;
  float weight = opacity * clamp(1e3 * nearness * nearness * nearness, 1e-2, 1e3);
  color_sum = vec4(color * weight, opacity);
  weight_sum = weight;
}
#else
layout(location = 0) out vec4 pixel_color;
layout(location = 1) out int pixel_id;

void emit(vec3 color, float opacity, int id) {
  pixel_color = vec4(color, 1.0);
  pixel_id = id;
}
#endif
