// Mean of 4×4 values, weighted toward those at a similar distance.
uniform sampler2D raw_occlusion;
layout(location = 0) out vec2 openness_and_distance;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy), last = textureSize(raw_occlusion, 0) - 1;
  float away = texelFetch(raw_occlusion, pixel, 0).g, sum = 0.0, weights = 0.0;
  for (int i = 0; i < 16; ++i) {
    vec2 there = texelFetch(raw_occlusion, clamp(pixel + ivec2(i & 3, i >> 2) - 2, ivec2(0), last), 0).rg;
    float weight = 1.0 / (1e-2 + abs(there.y / away - 1.0));
    sum += weight * there.x;
    weights += weight;
  }
  openness_and_distance = vec2(sum / weights, away);
}
