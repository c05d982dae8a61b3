// What is seen through clear matter, and what it mirrors. Background is looked up a little aside, as refraction has it.
const float kBend = 0.012;  // of a look through a slanted face, in heights of the picture

uniform sampler2D opaque_picture, depth_sums, light_sums, slope_sums;
layout(location = 0) out vec4 pixel_color;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 light_sum = texelFetch(light_sums, pixel, 0), depth_sum = texelFetch(depth_sums, pixel, 0);
  if (light_sum.a == 0.0) discard;
  vec2 size = vec2(textureSize(opaque_picture, 0));
  vec2 bend = kBend * texelFetch(slope_sums, pixel, 0).rg / light_sum.a * vec2(size.y / size.x, 1.0);
  vec3 behind = linear_from_srgb(texture(opaque_picture, gl_FragCoord.xy / size - bend).rgb);
  float mirrored = 1.0 - exp(-depth_sum.a);
  vec3 seen = behind * exp(-max(depth_sum.rgb, 0.0)) * (1.0 - mirrored);
  pixel_color = vec4(srgb_from_linear(seen + light_sum.rgb * mirrored / max(depth_sum.a, 1e-5)), 1.0);
}
