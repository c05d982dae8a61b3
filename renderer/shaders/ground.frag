uniform vec3 center, color;
uniform float radius, grid_spacing;  // [m]
uniform float grid_fade;  // fade of the finest lines, 0..1: at 1 the next ones take their place
uniform float opacity;
in vec3 position;
layout(location = 0) out vec4 pixel_color;

// Returns 1 on the lines of a square grid of unit spacing, one pixel wide; fades out before dense lines form moiré
// patterns.
float grid(vec2 place) {
  vec2 dx = dFdx(place), dy = dFdy(place);
  vec2 per_pixel = max(sqrt(dx * dx + dy * dy), 1e-6);
  vec2 pixels = abs(fract(place - 0.5) - 0.5) / per_pixel;
  vec2 lines = (1.0 - clamp(pixels - 0.1, 0.0, 1.0)) * (1.0 - smoothstep(0.1, 0.35, per_pixel));
  return max(lines.x, lines.y);
}

#ifdef PLAIN_LIGHT
vec3 lit(vec3 shown, float grain) {
  return reflected(shown, vec3(0.75 + 1.1 * light_visibility(position, vec3(0, 1, 0))));
}
#else
// Screed: dull, a little glossy at grazing angles, mottled at five scales; dark places are rougher.
float mottling(vec2 place) {
  vec2 dx = dFdx(place), dy = dFdy(place);
  float sum = 0.0, scale = 1.1;
  for (int i = 0; i < 5; ++i) {
    float pixel = scale * sqrt(max(dot(dx, dx), dot(dy, dy)));
    place = mat2(0.8, -0.6, 0.6, 0.8) * place;
    sum += (1.0 - smoothstep(0.3, 0.9, pixel)) * speckle(scale * place + 7.3 * float(i));
    scale *= 3.3;
  }
  return sum;
}

vec3 lit(vec3 shown, float grain) {
  const float kContrast = 0.14;
  vec3 up = vec3(0, 1, 0);
  float visibility = light_visibility(position, up), openness = ambient_openness(position);
  float worn = mottling(grain * position.xz);
  vec3 color = linear_from_srgb(shown) * (1.0 + kContrast * worn);
  return displayed(color * colored_illumination(up, visibility, openness) +
                   mirrored_light(vec3(0.02), position, up, 0.55 - 0.06 * worn, visibility, openness));
}
#endif

void main() {
  vec2 place = position.xz / grid_spacing;
  float fade_out = smoothstep(0.4, 1.0, grid_fade);
  float fine = 0.45 * (1.0 - fade_out) * grid(place), medium = mix(0.9, 0.45, fade_out) * grid(place / 10.0);
  float lines = max(max(fine, medium), 0.9 * grid(place / 100.0));
  float fade = 1.0 - smoothstep(0.2, 1.0, length(position.xz - center.xz) / radius);
  pixel_color = vec4(lit(color * (1.0 - 0.22 * lines), 8.0 / radius), fade * opacity);
}
