// What is seen through clear matter, and what it mirrors. Background is looked up a little aside, as refraction has it.
const float kBend = 0.012;  // of a look through a slanted face, in heights of the picture

uniform sampler2D opaque_picture, depth_sums, light_sums, face_sums;
layout(location = 0) out vec4 pixel_color;

// Without the way from the eye to faces whose opposite is missing.
vec3 without_unpaired(vec3 depth, vec4 face_sum, float faces) {
  float sum = dot(depth, vec3(1.0));
  if (face_sum.z == 0.0 || sum == 0.0) return max(depth, 0.0);
  return depth / sum * max(sum - face_sum.z * face_sum.w / faces, 0.0);
}

// Optical depth of a pixel. Some faces have no opposite, which hides behind what is opaque, or which a seam between two
// polygons lets the pixel miss. Then neighbours tell, where they have all.
vec3 optical_depth(ivec2 pixel, vec3 depth, vec4 face_sum, float faces) {
  vec4 sum = vec4(0.0);
  for (int i = 0; i < (face_sum.z == 0.0 ? 0 : 9); ++i) {
    ivec2 there = pixel + ivec2(i % 3, i / 3) - 1;
    bool paired = texelFetch(face_sums, there, 0).z == 0.0 && texelFetch(light_sums, there, 0).a > 0.0;
    if (paired) sum += vec4(max(texelFetch(depth_sums, there, 0).rgb, 0.0), 1.0);
  }
  return sum.a > 0.0 ? sum.rgb / sum.a : without_unpaired(depth, face_sum, faces);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 light_sum = texelFetch(light_sums, pixel, 0), depth_sum = texelFetch(depth_sums, pixel, 0);
  if (light_sum.a == 0.0) discard;
  vec2 size = vec2(textureSize(opaque_picture, 0));
  vec4 face_sum = texelFetch(face_sums, pixel, 0);
  vec2 bend = kBend * face_sum.xy / light_sum.a * vec2(size.y / size.x, 1.0);
  vec3 behind = linear_from_srgb(texture(opaque_picture, gl_FragCoord.xy / size - bend).rgb);
  float mirrored = 1.0 - exp(-depth_sum.a);
  vec3 seen = behind * exp(-optical_depth(pixel, depth_sum.rgb, face_sum, light_sum.a)) * (1.0 - mirrored);
  pixel_color = vec4(srgb_from_linear(seen + light_sum.rgb * mirrored / max(depth_sum.a, 1e-5)), 1.0);
}
