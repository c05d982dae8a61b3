in vec3 position;
flat in vec3 center;
flat in float radius;
flat in vec3 color;
flat in vec3 finish;  // metal, roughness, grain of stone
flat in vec4 rotation;  // quaternion
flat in int id;
layout(location = 0) out vec4 pixel_color;
layout(location = 1) out int pixel_id;

#ifdef PLAIN_LIGHT
vec3 lit(vec3 place, vec3 normal) {
  float gleam = pow(max(dot(reflect(-towards_eye(place), normal), light.xyz), 0.0), 40.0);
  float light_here = illumination(normal, light_visibility(place, normal));
  return srgb_from_linear(linear_from_srgb(color) * light_here + 0.12 * gleam);
}
#else
// Noise that turns with the ball, at three scales.
vec4 grain(vec3 place) {
  vec3 at = (place - center) / radius, turned = at + 2.0 * cross(-rotation.xyz, cross(-rotation.xyz, at) + rotation.w * at);
  float pixel = length(fwidth(at));
  vec4 sum = vec4(0.0);
  for (float scale = 3.0; scale < 60.0; scale *= 3.7) sum += seen(scale * pixel) * noise(scale * turned + scale);
  return sum;
}

vec3 lit(vec3 place, vec3 normal) {
  float visibility = light_visibility(place, normal), openness = ambient_openness(place);
  normal = normalize(normal + 0.25 * finish.z * grain(place).xyz);
  vec3 matter = linear_from_srgb(color) * (1.0 + 0.9 * finish.z * grain(place).w), least = mix(vec3(kDielectric), matter, finish.x);
  vec3 dull = matter * (1.0 - 0.9 * finish.x) * colored_illumination(normal, visibility, openness);
  return displayed(dull + mirrored_light(least, place, normal, finish.y, visibility, openness));
}
#endif

// Exact intersection of the pixel's ray with the sphere; alpha is the pixel's coverage at the outline.
void main() {
  vec3 direction = -towards_eye(position);
  vec3 offset = position - center;
  vec3 closest = offset - dot(offset, direction) * direction;
  float miss = length(closest);
  float coverage = clamp(0.5 + (radius - miss) / max(fwidth(miss), 1e-9), 0.0, 1.0);
  if (coverage < (viewport.z > 1.0 ? 0.05 : 0.5)) discard;
  vec3 surface = closest - sqrt(max(radius * radius - miss * miss, 0.0)) * direction;
  vec4 clip = view_projection * vec4(center + surface, 1.0);
  gl_FragDepth = clamp(0.5 + 0.5 * clip.z / clip.w, 0.0, 1.0);
  vec3 normal = normalize(surface);
  pixel_color = vec4(lit(center + surface, normal), coverage);
  pixel_id = id;
}
