// Distance from the eye to opaque objects at each pixel [m].
uniform sampler2D opaque_depth;
uniform mat4 world_from_clip;
layout(location = 0) out float opaque_away;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 unit = vec3((vec2(pixel) + 0.5) / viewport.xy, texelFetch(opaque_depth, pixel, 0).r);
  vec4 place = world_from_clip * vec4(2.0 * unit - 1.0, 1.0);
  opaque_away = length(place.xyz / place.w - eye.xyz);
}
