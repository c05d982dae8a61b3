// Light at a point, for all fragment shaders. Software GL executes both sides of a branch, but loops only as often as
// some pixel needs: unused effects are loops of zero iterations. With PLAIN_LIGHT, for drafts, there is one lamp with
// hard shadows, and light has no color.
const float kNarrowest = 8e-4, kWidest = 0.03;  // penumbras, in widths of the shadow map

uniform sampler2DShadow shadow_map;
uniform sampler2DShadow clear_shadow_map;
uniform sampler2D shadow_depth;  // depths in shadow_map
uniform sampler2D occlusion_map;  // openness to the sky, distance from the eye

// An offset from the surface avoids self-shadowing.
vec3 place_in_shadow_map(vec3 position, vec3 normal) {
  return (shadow_matrix * vec4(position + 2.0 * light.w * normal, 1.0)).xyz;
}

// Light from a bright sky, a dimmer ground and one lamp; about 1 for a face toward the lamp.
float illumination(vec3 normal, float visibility) {
  float sky = mix(0.27, 0.47, 0.5 + 0.5 * normal.y);
  return sky + 0.68 * max(dot(normal, light.xyz), 0.0) * visibility;
}

#ifdef PLAIN_LIGHT
float light_visibility(vec3 position, vec3 normal) { return texture(shadow_map, place_in_shadow_map(position, normal)); }

float ambient_openness(vec3 position) { return 1.0; }

// As bright as in other qualities.
vec3 colored_illumination(vec3 normal, float visibility, float openness) {
  return vec3(1.45 * illumination(normal, visibility));
}

// Reflects light, both encoded: sRGB is nearly a power, and one power is enough.
vec3 reflected(vec3 color, vec3 light_here) { return min(color * pow(light_here.x, 1.0 / 2.2), 1.0); }
#else
const float kDielectric = 0.04;  // fraction of light that glass, glazes and stone reflect head-on

// Returns one of `count` points that cover the unit disc evenly (Vogel 1979).
vec2 disc_point(int i, int count) {
  float angle = 2.3999632 * float(i);
  return sqrt((float(i) + 0.5) / float(count)) * vec2(cos(angle), sin(angle));
}

// Rotates the points by a different angle in each pixel (Jimenez 2014, "Next generation post processing in Call of
// Duty"), so that few of them give fine grain instead of banding.
mat2 turn_here() {
  float angle = 6.2831853 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  return mat2(cos(angle), sin(angle), -sin(angle), cos(angle));
}

// Returns the sum over the 2×2 pixels that are shaded together.
float sum_of_quad(float value) {
  vec2 side = 1.0 - 2.0 * mod(floor(gl_FragCoord.xy), 2.0);
  float row = 2.0 * value + side.x * dFdx(value);
  return max(2.0 * row + side.y * dFdy(row), 0.0);
}

// Returns the visibility with a penumbra as wide as the occluder is distant (Fernando 2005, "Percentage-closer soft
// shadows"). The search is denser toward its center, where low objects cast narrow shadows, weights near occluders
// more, and skips those too low for their penumbra to reach this point. Neighboring pixels search together. `slope`: of
// the lit plane's depth.
float soft_visibility(vec3 place, vec2 slope) {
  const float kSure = 4.0;  // blockers needed by one search for a shadow to begin without a visible step
  int count = int(effects.y);
  mat2 turn = turn_here();
  float sum = 0.0, blockers = 0.0, found = 0.0;
  for (int i = 0; i < count / 2; ++i) {
    vec2 offset = turn * disc_point(i, count / 2);
    offset *= kWidest * dot(offset, offset);
    float there = textureLod(shadow_depth, place.xy + offset, 0.0).r;
    float height = place.z + dot(slope, offset) - there;
    if (height > 0.0 && effects.x * height + kNarrowest >= length(offset)) {
      float weight = 1.0 / (0.02 * kWidest + length(offset));
      sum += weight * height;
      blockers += weight;
      found += 1.0;
    }
  }
  sum = sum_of_quad(sum);
  blockers = sum_of_quad(blockers);
  found = sum_of_quad(found);
  if (blockers == 0.0) return 1.0;
  float penumbra = clamp(effects.x * sum / blockers, kNarrowest, kWidest);
  float lit = 0.0;
  for (int i = 0; i < count; ++i) {
    vec2 offset = penumbra * turn * disc_point(i, count);
    lit += texture(shadow_map, place + vec3(offset, dot(slope, offset)));
  }
  return mix(1.0, lit / float(count), min(found / kSure, 1.0));
}

// Returns the fraction of the lamp's light transmitted by transparent materials.
float clear_visibility(vec3 place, vec2 slope) {
  const int kCount = 8;
  const float kKept = 0.3;  // transmitted by two faces and the material between
  float taken = 0.0;
  for (int i = 0; i < (effects.z == 0.0 ? 0 : kCount); ++i) {
    vec2 offset = 4.0 * kNarrowest * disc_point(i, kCount);
    taken += 1.0 - texture(clear_shadow_map, place + vec3(offset, dot(slope, offset)));
  }
  return 1.0 - kKept * taken / float(kCount);
}

// Returns the fraction of the lamp's light that arrives.
float light_visibility(vec3 position, vec3 normal) {
  vec3 place = place_in_shadow_map(position, normal);
  vec3 turned = normalize(mat3(shadow_matrix) * normal);
  if (turned.z >= 0.0) return 0.0;  // faces away
  vec2 slope = turned.xy / max(-turned.z, 0.2);
  return soft_visibility(place, slope) * clear_visibility(place, slope);
}

// Returns the visible fraction of the sky: a mean of the map's four nearest values, weighted toward those at the
// distance of the point.
float ambient_openness(vec3 position) {
  float away = (view_projection * vec4(position, 1.0)).w;
  ivec2 last = textureSize(occlusion_map, 0) - 1;
  vec2 place = gl_FragCoord.xy / viewport.xy * vec2(last + 1) - 0.5;
  ivec2 first = ivec2(floor(place));
  vec2 t = place - vec2(first);
  float sum = 0.0, weights = 0.0;
  for (int i = 0; i < 4; ++i) {
    ivec2 corner = ivec2(i & 1, i >> 1);
    vec2 there = texelFetch(occlusion_map, clamp(first + corner, ivec2(0), last), 0).rg;
    vec2 share = mix(1.0 - t, t, vec2(corner)) + 1e-3;
    float weight = share.x * share.y / (1e-3 + abs(there.y / away - 1.0));
    sum += weight * there.x;
    weights += weight;
  }
  return sum / weights;
}

// Illumination in color: the surroundings, scaled by their openness, and the lamp, of whose width objects close by cover a part.
vec3 colored_illumination(vec3 normal, float visibility, float openness) {
  float direct = max(dot(normal, light.xyz), 0.0) * visibility * mix(0.6, 1.0, openness);
  return ambient_light(normal) * openness + direct_light() * direct;
}

// Returns the fraction of light reflected by a face of a material that reflects `least` of what meets it head-on (Schlick 1994);
// rough faces reflect less at grazing angles (Lagarde 2011). `ray`: from the eye.
vec3 mirrored_share(vec3 least, vec3 normal, vec3 ray, float roughness) {
  float grazing = pow(1.0 - min(abs(dot(normal, ray)), 1.0), 5.0);
  return least + (max(vec3(1.0 - roughness), least) - least) * grazing;
}

// Returns what a face mirrors of its surroundings, scaled by their openness, and of the lamp.
vec3 mirrored_light(vec3 least, vec3 position, vec3 normal, float roughness, float visibility, float openness) {
  vec3 ray = -towards_eye(position), direction = reflect(ray, normal);
  vec3 light_there = openness * environment(direction, roughness) + visibility * lamp_light(direction, roughness);
  return mirrored_share(least, normal, ray, roughness) * light_there;
}

// Returns the reflected color.
vec3 reflected(vec3 color, vec3 light_here) { return displayed(linear_from_srgb(color) * light_here); }
#endif
