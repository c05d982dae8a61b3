layout(location = 0) in vec3 corner;
layout(location = 1) in vec3 corner_normal;
layout(location = 2) in vec3 center;
layout(location = 3) in vec3 axis_x;
layout(location = 4) in vec3 axis_y;
layout(location = 5) in vec3 axis_z;
layout(location = 6) in vec3 glyph_color;
layout(location = 7) in float glyph_opacity;
layout(location = 8) in int glyph_id;
out vec3 position;
out vec3 normal;
flat out vec3 color;
flat out float opacity;
flat out int id;

void main() {
  position = center + corner.x * axis_x + corner.y * axis_y + corner.z * axis_z;
  // The cofactor matrix transforms normals even if an axis has no length.
  normal = corner_normal.x * cross(axis_y, axis_z) + corner_normal.y * cross(axis_z, axis_x) +
           corner_normal.z * cross(axis_x, axis_y);
  color = glyph_color;
  opacity = glyph_opacity;
  id = glyph_id;
  gl_Position = view_projection * vec4(position, 1.0);
}
