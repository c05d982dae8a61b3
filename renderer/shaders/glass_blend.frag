// View through transparent materials, and their reflections. The background is sampled at an offset, to mimic
// refraction.
const float kBend = 0.012;  // of a ray through a slanted face, in heights of the picture

uniform sampler2D opaque_picture, opaque_distance, depth_sums, light_sums, face_sums;
layout(location = 0) out vec4 pixel_color;

ivec2 neighbor(ivec2 pixel, int i) {
  return clamp(pixel + ivec2(i % 3, i / 3) - 1, ivec2(0), textureSize(light_sums, 0) - 1);
}

// Returns the optical depth of a pixel. At a seam between two polygons some pixels miss a face. Neighbors with complete
// faces are then used; without any, nothing is absorbed.
vec3 optical_depth(ivec2 pixel, vec3 depth, float unpaired) {
  if (unpaired == 0.0) return max(depth, 0.0);
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 9; ++i) {
    ivec2 there = neighbor(pixel, i);
    bool paired = texelFetch(face_sums, there, 0).z == 0.0 && texelFetch(light_sums, there, 0).a > 0.0;
    if (paired) sum += vec4(max(texelFetch(depth_sums, there, 0).rgb, 0.0), 1.0);
  }
  return sum.a > 0.0 ? sum.rgb / sum.a : vec3(0.0);
}

// True if an opaque object at or next to a pixel is in front of the transparent material at distance `away` [m].
bool stands_before(ivec2 place, float away) {
  bool found = false;
  for (int i = 0; i < 9; ++i) {
    ivec2 there = neighbor(place, i);
    found = found || (texelFetch(light_sums, there, 0).a == 0.0 && texelFetch(opaque_distance, there, 0).r < away);
  }
  return found;
}

// Returns the offset at which the background is sampled, in fractions of the drawn part: at most its distance behind the
// faces, since rays are refracted by less than 45 degrees, and zero if something is in front of them.
vec2 bend(ivec2 pixel, vec2 size, vec4 face_sum, float faces) {
  float opaque_away = texelFetch(opaque_distance, pixel, 0).r, beyond = face_sum.w / faces;
  vec3 up = vec3(view_projection[0][1], view_projection[1][1], view_projection[2][1]);
  float most = 0.5 * length(up) * beyond / opaque_away;
  vec2 aside = kBend * viewport.w * face_sum.xy / faces;
  aside *= min(1.0, most / max(length(aside), 1e-6)) * vec2(size.y / size.x, 1.0);
  return stands_before(ivec2(gl_FragCoord.xy - aside * size), opaque_away - beyond) ? vec2(0.0) : aside;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 light_sum = texelFetch(light_sums, pixel, 0), depth_sum = texelFetch(depth_sums, pixel, 0);
  if (light_sum.a == 0.0) discard;
  vec2 size = vec2(textureSize(opaque_picture, 0));
  vec4 face_sum = texelFetch(face_sums, pixel, 0);
  vec2 place = gl_FragCoord.xy / size - bend(pixel, size, face_sum, light_sum.a);
  vec3 behind = light_displayed_as(texture(opaque_picture, place).rgb);
  float mirrored = 1.0 - exp(-depth_sum.a);
  vec3 seen = behind * exp(-optical_depth(pixel, depth_sum.rgb, face_sum.z)) * (1.0 - mirrored);
  pixel_color = vec4(displayed(seen + light_sum.rgb * mirrored / max(depth_sum.a, 1e-5)), 1.0);
}
