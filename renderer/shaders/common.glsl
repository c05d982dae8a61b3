// Shared by all programs. The block mirrors ViewBlock in view.h.
layout(std140) uniform View {
  mat4 view_projection;
  mat4 shadow_matrix;  // world to shadow map, [0, 1]³
  vec4 eye;  // homogeneous: a point (w = 1), or the direction toward the eye of a parallel projection (w = 0)
  vec4 light;  // unit vector toward the light; w: size of a shadow texel [m]
  vec4 viewport;       // width, height [pixels]; z: samples per pixel
  vec4 visible;  // surfaces are drawn if dot(visible.xyz, position) <= visible.w
  vec4 effects;  // x: width of penumbras over distance; y: their samples; z: 1 for transparent materials
};

vec3 towards_eye(vec3 position) { return normalize(eye.xyz - position * eye.w); }

vec3 linear_from_srgb(vec3 color) {
  return mix(color / 12.92, pow((color + 0.055) / 1.055, vec3(2.4)), step(0.04045, color));
}

vec3 srgb_from_linear(vec3 color) {
  color = clamp(color, 0.0, 1.0);
  return mix(12.92 * color, 1.055 * pow(color, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, color));
}
