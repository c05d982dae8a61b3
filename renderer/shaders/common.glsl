// Shared by all programs. The block mirrors ViewBlock in view.h.
layout(std140) uniform View {
  mat4 view_projection;
  mat4 shadow_matrix;  // world to shadow map, [0, 1]³
  vec4 eye;  // homogeneous: a point (w = 1), or the direction toward the eye of a parallel projection (w = 0)
  vec4 light;  // unit vector toward the light; w: size of a shadow texel [m]
  vec4 viewport;       // width, height [pixels]; z: samples per pixel; w: height of the whole picture over that of the drawn part
  vec4 visible;  // surfaces are drawn if dot(visible.xyz, position) <= visible.w
  vec4 effects;  // x: width of penumbras over distance; y: their samples; z: 1 for transparent materials; w: 1 for a sky
  vec4 surroundings;  // rgb: light from the ground; w: factor on all light but the lamp's
};

vec3 towards_eye(vec3 position) { return normalize(eye.xyz - position * eye.w); }

vec3 linear_from_srgb(vec3 color) {
  return mix(color / 12.92, pow((color + 0.055) / 1.055, vec3(2.4)), step(0.04045, color));
}

vec3 srgb_from_linear(vec3 color) {
  color = clamp(color, 0.0, 1.0);
  return mix(12.92 * color, 1.055 * pow(color, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, color));
}

// Film's response to light (a fit to the curve of the ACES: Narkowicz 2016), encoded for display. Colors of values never go through it.
vec3 displayed(vec3 light_there) {
  vec3 x = max(light_there, 0.0);
  return srgb_from_linear(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14));
}

// Returns the light that is displayed as a color: the inverse of displayed().
vec3 light_displayed_as(vec3 color) {
  vec3 y = min(linear_from_srgb(color), 0.995);
  vec3 a = 2.51 - 2.43 * y, b = 0.03 - 0.59 * y;
  return (sqrt(b * b + 0.56 * y * a) - b) / (2.0 * a);
}
