// Surroundings made of formulas, in linear light: a studio with a lamp, two softboxes and a window, or a clear sky with
// a sun. Smooth faces mirror environment() and lamp_light(); rough ones a blurred version; all faces are lit by
// ambient_light().
const vec3 kLampLight = vec3(1.00, 0.97, 0.91), kSunLight = vec3(1.62, 1.38, 1.04);  // on a face toward it
const vec3 kCeiling = vec3(0.34, 0.35, 0.36), kWalls = vec3(0.17, 0.175, 0.18);  // of the studio
const vec3 kFillAxis = vec3(0.78, 0.42, 0.46), kRimAxis = vec3(0.30, 0.40, -0.866);
const vec3 kFill = vec3(0.86, 0.93, 1.00), kRim = vec3(1.9, 1.86, 1.80);
const vec3 kWindowAxis = vec3(-0.46, 0.24, 0.855), kDay = vec3(2.2, 2.35, 2.6);  // narrow: seen in panes, lights little
const vec3 kZenith = vec3(0.12, 0.23, 0.47), kHorizon = vec3(0.52, 0.61, 0.71);

bool is_sky() { return effects.w > 0.5; }

// Mean of a strip of half width `size` over a window of half width `blur` around a place.
float strip(float place, float size, float blur) {
  return smoothstep(-blur, blur, size - place) + smoothstep(-blur, blur, size + place) - 1.0;
}

// Light of a rectangular softbox around an axis, from a direction.
float softbox(vec3 direction, vec3 axis, vec2 size, float blur) {
  vec3 right = normalize(vec3(axis.z, 0.0, -axis.x)), up = cross(axis, right);
  float ahead = dot(direction, axis);
  vec2 place = vec2(dot(direction, right), dot(direction, up)) / max(ahead, 0.05);
  return step(0.05, ahead) * strip(place.x, size.x, blur) * strip(place.y, size.y, blur);
}

// Light of a window of two by three panes.
vec3 window_light(vec3 direction, float blur) {
  const vec2 kSize = vec2(0.17, 0.36);
  vec3 right = normalize(vec3(kWindowAxis.z, 0.0, -kWindowAxis.x)), up = cross(kWindowAxis, right);
  vec2 place = vec2(dot(direction, right), dot(direction, up)) / max(dot(direction, kWindowAxis), 0.05);
  vec2 pane = 2.0 * kSize / vec2(2.0, 3.0), within = abs(fract((place + kSize) / pane) - 0.5);
  vec2 bar = smoothstep(vec2(0.5), vec2(0.44), within);
  return kDay * softbox(direction, kWindowAxis, kSize, blur) * mix(bar.x * bar.y, 0.8, smoothstep(0.01, 0.1, blur));
}

// Light of the lamp or the sun that a face of that roughness (0: smooth, 1: dull) mirrors.
vec3 lamp_light(vec3 direction, float roughness) {
  float blur = 0.03 + 0.9 * roughness;
  if (!is_sky()) return 6.0 * kLampLight * softbox(direction, light.xyz, vec2(0.24), blur);
  float size = 0.02 + blur * blur;
  return kSunLight / size * 0.35 * exp((dot(direction, light.xyz) - 1.0) / (0.5 * size));
}

float corner_value(ivec2 place) {
  uint n = uint(place.x) * 73856093u ^ uint(place.y) * 19349663u;
  n = (n ^ (n >> 15)) * 0x2c1b3c6du;
  return float((n >> 12) & 0xffffu) / 65535.0;
}

// Returns a smooth random value in -1/2..1/2 on a plane.
float speckle(vec2 place) {
  ivec2 cell = ivec2(floor(place));
  vec2 t = place - floor(place);
  t = t * t * (3.0 - 2.0 * t);
  float near = mix(corner_value(cell), corner_value(cell + ivec2(1, 0)), t.x);
  return mix(near, mix(corner_value(cell + ivec2(0, 1)), corner_value(cell + ivec2(1, 1)), t.x), t.y) - 0.5;
}

// Light from a direction but for the lamp's.
vec3 environment(vec3 direction, float roughness) {
  float horizon = 0.06 + 0.6 * roughness, above = smoothstep(-horizon, horizon, direction.y);
  vec3 ground = surroundings.rgb;
  if (is_sky()) {
    float height = max(direction.y, 0.0);
    vec3 sky = mix(kHorizon, kZenith, 1.0 - exp(-4.2 * height));
    float near_sun = max(dot(direction, light.xyz), 0.0);
    sky += vec3(0.30, 0.24, 0.15) * near_sun * near_sun * near_sun;
    return surroundings.w * mix(ground, sky, above);
  }
  float blur = 0.04 + 0.9 * roughness;
  vec3 room = mix(kWalls, kCeiling, smoothstep(-0.2, 1.0, direction.y));
  room += kFill * softbox(direction, kFillAxis, vec2(0.35, 0.62), blur);
  room += kRim * softbox(direction, kRimAxis, vec2(0.75, 0.16), blur);
  room += window_light(direction, blur - 0.03);  // sharper than softboxes: panes show its bars
  return surroundings.w * mix(ground, room, above);
}

// Light on a dull face from all sides but the lamp's.
vec3 ambient_light(vec3 normal) {
  float up = 0.5 + 0.5 * normal.y;
  if (is_sky()) return surroundings.w * mix(surroundings.rgb, vec3(0.27, 0.34, 0.46), up);
  float fill = max(0.3 + 0.7 * dot(normal, kFillAxis), 0.0), rim = max(dot(normal, kRimAxis), 0.0);
  vec3 room = mix(surroundings.rgb, vec3(0.30, 0.305, 0.315), up);
  return surroundings.w * (room + 0.16 * kFill * fill + 0.14 * kRim * rim);
}

vec3 direct_light() { return is_sky() ? kSunLight : kLampLight; }
