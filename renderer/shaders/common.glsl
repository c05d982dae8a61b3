// Shared by all programs. The block mirrors ViewBlock in view.h.
layout(std140) uniform View {
  mat4 view_projection;
  mat4 shadow_matrix;  // world to shadow map, [0, 1]³
  vec4 eye;            // homogeneous: a place (w = 1), or the direction towards the eye of a parallel projection (w = 0)
  vec4 light;          // unit vector towards the light; w: size of a shadow texel [m]
  vec4 viewport;       // width, height [pixels]; z: samples per pixel
  vec4 visible;        // surfaces are drawn where dot(visible.xyz, position) <= visible.w
};

uniform sampler2DShadow shadow_map;

vec3 towards_eye(vec3 position) { return normalize(eye.xyz - position * eye.w); }

vec3 linear_from_srgb(vec3 color) {
  return mix(color / 12.92, pow((color + 0.055) / 1.055, vec3(2.4)), step(0.04045, color));
}

vec3 srgb_from_linear(vec3 color) {
  color = clamp(color, 0.0, 1.0);
  return mix(12.92 * color, 1.055 * pow(color, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, color));
}

// Share of the light that arrives, averaged over 3×3 bilinear samples. Moving off the surface avoids self-shadowing.
float light_visibility(vec3 position, vec3 normal) {
  vec3 place = (shadow_matrix * vec4(position + 2.0 * light.w * normal, 1.0)).xyz;
  vec2 texel = 1.3 / vec2(textureSize(shadow_map, 0));
  float sum = 0.0;
  for (int i = -1; i <= 1; ++i) {
    for (int j = -1; j <= 1; ++j) sum += texture(shadow_map, vec3(place.xy + vec2(i, j) * texel, place.z));
  }
  return sum / 9.0;
}

// Light from a bright sky, a dimmer ground and one lamp; about 1 for a face turned to the lamp.
float illumination(vec3 normal, float visibility) {
  float sky = mix(0.27, 0.47, 0.5 + 0.5 * normal.y);
  return sky + 0.68 * max(dot(normal, light.xyz), 0.0) * visibility;
}
