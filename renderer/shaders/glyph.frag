in vec3 position;
in vec3 normal;
flat in vec3 color;
flat in float opacity;
flat in int id;

void main() {
  float size = length(normal);
  vec3 outwards = size > 0.0 ? normal / size : towards_eye(position);
  if (dot(outwards, towards_eye(position)) < 0.0) outwards = -outwards;
  float light_here = 0.25 + 0.85 * illumination(outwards, 1.0);
  emit(srgb_from_linear(linear_from_srgb(color) * light_here), opacity, id);
}
