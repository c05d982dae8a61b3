// Mean color of all transparent objects at a pixel; alpha is the remaining fraction of the background.
uniform sampler2D color_sums, weight_sums;
layout(location = 0) out vec4 pixel_color;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 sum = texelFetch(color_sums, pixel, 0);
  pixel_color = vec4(sum.rgb / max(texelFetch(weight_sums, pixel, 0).r, 1e-5), sum.a);
}
