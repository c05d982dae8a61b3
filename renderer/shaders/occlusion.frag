// Openness of a point to the sky above its plane within `reach` (after McGuire et al. 2012, "Scalable ambient
// obscurance"). Each pixel of 4×4 rotates the samples by a different angle; occlusion_blur.frag averages.
const float kStrength = 1.7, kDarkest = 0.2, kFar = 6e4;

uniform sampler2D scene_depth;
uniform mat4 world_from_clip;
uniform float reach;  // [m]
uniform int samples;
layout(location = 0) out vec2 openness_and_distance;

// Returns the visible point at a pixel; w: its distance from the eye in perspective. The background is far away.
vec4 place_at(ivec2 pixel) {
  ivec2 size = textureSize(scene_depth, 0);
  ivec2 inside = clamp(pixel, ivec2(0), size - 1);
  vec3 unit = vec3((vec2(inside) + 0.5) / vec2(size), texelFetch(scene_depth, inside, 0).r);
  if (unit.z == 1.0) return vec4(kFar);
  vec4 place = world_from_clip * vec4(2.0 * unit - 1.0, 1.0);
  return vec4(place.xyz, 1.0) / place.w;
}

vec3 shorter(vec3 a, vec3 b) { return dot(a, a) < dot(b, b) ? a : b; }

// Computes the normal from the nearer neighbor on either side, so that outlines have the normal of one of their two
// surfaces.
vec3 normal_at(ivec2 pixel, vec3 place) {
  vec3 x = shorter(place - place_at(pixel - ivec2(1, 0)).xyz, place_at(pixel + ivec2(1, 0)).xyz - place);
  vec3 y = shorter(place - place_at(pixel - ivec2(0, 1)).xyz, place_at(pixel + ivec2(0, 1)).xyz - place);
  return normalize(cross(x, y));
}

float occlusion(ivec2 pixel, vec3 place, float pixels) {
  vec3 normal = normal_at(pixel, place);
  float turn = 2.3999632 * float(4 * (pixel.x & 3) + (pixel.y & 3));
  mat2 rotation = mat2(cos(turn), sin(turn), -sin(turn), cos(turn));
  float sum = 0.0;
  for (int i = 0; i < samples; ++i) {
    vec3 way = place_at(pixel + ivec2(round(pixels * (rotation * disc_point(i, samples))))).xyz - place;
    float square = dot(way, way);
    float rise = dot(way, normal) - 0.03 * reach;
    sum += max(1.0 - square / (reach * reach), 0.0) * max(rise, 0.0) * inversesqrt(max(square, 1e-12));
  }
  return 2.0 * sum / float(samples);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 here = place_at(pixel);
  vec3 up = vec3(view_projection[0][1], view_projection[1][1], view_projection[2][1]);
  float pixels = min(0.5 * float(textureSize(scene_depth, 0).y) * length(up) * reach / here.w, 100.0);
  bool covered = here.w < kFar && pixels > 1.5;
  float openness = covered ? 1.0 - kStrength * occlusion(pixel, here.xyz, pixels) : 1.0;
  openness_and_distance = vec2(max(openness, kDarkest), here.w);
}
