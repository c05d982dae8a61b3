in vec2 place;
flat in vec3 center;
flat in float radius;
flat in vec4 color;
layout(location = 0) out vec4 pixel_color;
layout(location = 1) out int pixel_id;

// Returns a number in 0..1, different for each pixel and puff (interleaved gradient noise: Jimenez 2014).
float noise() {
  vec2 at = gl_FragCoord.xy + 64.0 * fract(center.xy + center.zz);
  return fract(52.9829189 * fract(dot(at, vec2(0.06711056, 0.00583715))));
}

// Returns another number in 0..1, independent of noise().
float chance() {
  uint n = uint(gl_FragCoord.x) * 73856093u ^ uint(gl_FragCoord.y) * 19349663u ^
           floatBitsToUint(center.x + 3.7 * center.y + 5.3 * center.z) * 83492791u;
  n = (n ^ (n >> 15)) * 0x2c1b3c6du;
  n = (n ^ (n >> 12)) * 0x297a2d39u;
  return float((n >> 12) & 0xffffu) / 65535.0;
}

// Returns a smooth random value in 0..1 on the puff, at two scales.
float billows() {
  float sum = 0.0, scale = 1.7;
  for (int i = 0; i < 2; ++i) {
    vec2 at = scale * place + 31.0 * fract(7.31 * center.xz + center.yy + float(i)), cell = floor(at), t = at - cell;
    t = t * t * (3.0 - 2.0 * t);
    vec4 random = fract(43.7585 * fract((cell.x + vec4(0, 1, 0, 1)) * 0.1031 + (cell.y + vec4(0, 0, 1, 1)) * 0.3719) * 97.13);
    sum += mix(mix(random.x, random.y, t.x), mix(random.z, random.w, t.x), t.y) / float(1 << i);
    scale *= 2.3;
  }
  return sum / 1.5;
}

// Puffs fade softly at bodies and ground, by the part of the puff in front of the background, whose distance is in the
// occlusion map. A parallel projection has no distances.
#ifdef PLAIN_LIGHT
float share_before_bodies() { return 1.0; }
#else
float share_before_bodies() {
  vec2 at = gl_FragCoord.xy / viewport.xy * vec2(textureSize(occlusion_map, 0));
  float behind = texelFetch(occlusion_map, ivec2(at), 0).g - 1.0 / gl_FragCoord.w;
  return eye.w == 0.0 ? 1.0 : clamp(1.3 * behind / radius, 0.0, 1.0);
}
#endif

// Denser toward the center, with light from all sides. Many faint puffs overlap, and rounding would shift their hue; so
// each pixel has few stronger ones instead, whose colors vary by what rounding takes.
void main() {
  float density = max(1.0 - dot(place, place), 0.0);
  if (density == 0.0) discard;
#ifdef PLAIN_LIGHT
  vec3 light_here = vec3(0.48 + 0.35 * light_visibility(center, light.xyz));
#else
  vec3 light_here = ambient_light(vec3(0, 1, 0)) + 0.5 * direct_light() * light_visibility(center, light.xyz);
#endif
  const float kSteps = 32.0;
  light_here *= 0.9 + 0.25 * place.y;  // lit from above
  float thickness = color.a * density * smoothstep(0.0, 1.1, density + billows() - 0.45);
  float alpha = floor(kSteps * share_before_bodies() * thickness + noise()) / kSteps;
  vec3 shown = reflected(mix(color.rgb, vec3(1.0), 0.45), light_here);
  pixel_color = vec4(shown + (chance() - 0.5) / (255.0 * max(alpha, 1.0 / kSteps)), alpha);
  pixel_id = -1;
}
