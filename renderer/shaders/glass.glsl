// Transparent materials as sums that need no order: optical depth adds up along the line of sight (Beer-Lambert law),
// and so do small fractions of reflected light. glass_blend.frag makes the picture.
const float kMatShare = 0.6;  // fraction of light from the rough faces of a crack
const float kInnerShare = 0.8;  // of light that the sides of a body reflect inside
const float kCaught = 0.6;  // fraction of the lamp's light at the edges of a pane

layout(location = 0) out vec4 depth_sum;  // rgb: optical depth from each face on, negative for left faces; a: reflected fractions
layout(location = 1) out vec4 light_sum;  // rgb: reflected light; a: 1 for each visible face
layout(location = 2) out vec4 face_sum;   // xy: slopes of the faces, across the line of sight; z: -1 for an entered face,
                                          // 1 for one that is left, seen or not; w: from each face to what is opaque [m]

uniform sampler2D opaque_distance;

// Distances count from the opaque object behind the faces: transparent parts beyond, next to or within it add up to
// nothing, whichever of their faces are hidden. A face that touches the object behind it reflects nothing, since the
// order of the two is arbitrary. `color`: of light after a distance `clear_depth` [m] in the material; `covered`: a
// point in the part of the pixel covered by the face.
void emit_glass(vec3 color, float clear_depth, vec3 covered, vec3 position, vec3 normal, bool rough) {
  const float kTouching = 5e-3;  // in distances from the eye: far above the rounding of depths
  float distance_here = length(eye.xyz - position);
  float touching = kTouching * distance_here + 2.0 * fwidth(distance_here);  // it varies within a pixel
  vec3 ray = -towards_eye(position);
  float away = length(eye.xyz - covered);
  float beyond = max(texelFetch(opaque_distance, ivec2(gl_FragCoord.xy), 0).r - away, 0.0);
  float visible_here = gl_FrontFacing ? float(beyond > 0.0) : smoothstep(0.0, touching, beyond);
  vec3 absorption = -log(max(linear_from_srgb(color), 1e-3)) / clear_depth;
  float share = mirrored_share(vec3(kDielectric), normal, ray, 0.0).x;
  vec3 direction = reflect(ray, normal), blurred = environment(direction, 0.1);
  vec3 mirrored = (rough ? blurred : environment(direction, 0.0)) + lamp_light(direction, rough ? 0.1 : 0.0);
  float cosine = abs(dot(normal, ray)), within = gl_FrontFacing ? 0.0 : 1.0 - smoothstep(0.2, 0.5, cosine);
  share = max(share, kInnerShare * within);  // sides mirror the inside: light is caught by total reflection
  vec3 inside = linear_from_srgb(color) * (blurred + kCaught * direct_light());
  if (rough) {  // light trapped in the pane leaves it here, in any direction
    float lit = 1.9 * kCaught * pow(abs(dot(normal, light.xyz)), 1.5);  // from either side; as much in the mean
    vec3 caught = linear_from_srgb(sqrt(color)) * (0.8 * ambient_light(normal) + lit * direct_light());
    mirrored = mix(mirrored, caught, 0.6);
    share = max(share, kMatShare);
  } else {
    mirrored = mix(mirrored, inside, within);
  }
  share *= visible_here;
  depth_sum = vec4(absorption * (gl_FrontFacing ? beyond : -beyond), share);
  light_sum = vec4(mirrored * share, visible_here);
  vec2 slope = (view_projection * vec4(normal + ray * dot(ray, normal), 0.0)).xy;
  face_sum = vec4(visible_here * slope, gl_FrontFacing ? -1.0 : 1.0, visible_here * beyond);
}
