'use strict';

/** Poses of objects in a texture, two texels each: (x, y, z, visible), rotation. */
const kPlacing = `#version 300 es
precision highp float;
precision highp int;
uniform highp sampler2D poses;
uniform mat4 camera;
in vec3 position, normal;
in vec2 style;  // object, material
vec3 turned(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }
vec4 place(out vec4 rotation) {
  vec4 at = texelFetch(poses, ivec2(0, int(style.x)), 0);
  rotation = texelFetch(poses, ivec2(1, int(style.x)), 0);
  return vec4(turned(rotation, position) + at.xyz, at.w);
}
`;

const kObjectVertex = `${kPlacing}
uniform float selected;
uniform vec3 eye;
flat out int material;
flat out float chosen;
out vec3 world_normal, toward_eye;
void main() {
  vec4 rotation, at = place(rotation);
  world_normal = turned(rotation, normal);
  toward_eye = eye - at.xyz;
  material = int(style.y);
  chosen = style.x == selected ? 1.0 : 0.0;
  gl_Position = at.w > 0.0 ? camera * vec4(at.xyz, 1) : vec4(0, 0, 2, 1);
}`;

const kObjectFragment = `#version 300 es
precision highp float;
uniform highp sampler2D materials;  // two texels each: linear color and opacity, roughness
flat in int material;
flat in float chosen;
in vec3 world_normal, toward_eye;
out vec4 color;
const vec3 kSun = normalize(vec3(0.5, 0.9, 0.45));
vec3 encoded(vec3 c) { return mix(12.92 * c, 1.055 * pow(max(c, 0.0), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c)); }
void main() {
  vec3 v = normalize(toward_eye), n = normalize(world_normal);
  if (dot(n, v) < 0.0) n = -n;
  vec4 base = texelFetch(materials, ivec2(0, material), 0);
  vec3 sky = mix(vec3(0.30, 0.28, 0.26), vec3(0.62, 0.70, 0.80), 0.5 + 0.5 * n.y);
  float sun = max(dot(n, kSun), 0.0), shine = 1.0 - texelFetch(materials, ivec2(1, material), 0).r;
  float glint = shine * pow(max(dot(n, normalize(v + kSun)), 0.0), mix(8.0, 90.0, shine));
  float rim = shine * pow(1.0 - max(dot(n, v), 0.0), 4.0);
  vec3 lit = base.rgb * (sky + 0.75 * sun) + vec3(0.6 * glint + 0.5 * rim);
  lit = mix(lit, vec3(1.0, 0.42, 0.05) * (0.45 + 0.55 * dot(n, v)), 0.75 * chosen);
  float opacity = mix(clamp(base.a + rim * (1.0 - base.a) + glint, 0.0, 1.0), 1.0, chosen);
  color = vec4(encoded(lit) * opacity, opacity);
}`;

/** Shadows of objects on the ground. */
const kShadowVertex = `${kPlacing}
uniform float ground;
void main() {
  vec4 rotation, at = place(rotation);
  vec3 sun = normalize(vec3(0.5, 0.9, 0.45));
  float height = max(at.y - ground, 0.0);
  gl_Position = at.w > 0.0 ? camera * vec4(at.x - height * sun.x / sun.y, ground, at.z - height * sun.z / sun.y, 1)
                           : vec4(0, 0, 2, 1);
}`;
const kShadowFragment = `#version 300 es
precision highp float;
uniform float darkness;
out vec4 color;
void main() { color = vec4(0, 0, 0, darkness); }`;

/** Visible object, as a color. */
const kPickVertex = `${kPlacing}
flat out int object;
void main() {
  vec4 rotation, at = place(rotation);
  object = int(style.x) + 1;
  gl_Position = at.w > 0.0 ? camera * vec4(at.xyz, 1) : vec4(0, 0, 2, 1);
}`;
const kPickFragment = `#version 300 es
precision highp float;
flat in int object;
out vec4 color;
void main() { color = vec4(float(object & 255), float(object >> 8 & 255), float(object >> 16 & 255), 255) / 255.0; }`;

const kGroundVertex = `#version 300 es
precision highp float;
uniform mat4 camera;
uniform vec3 middle;
uniform float size;
in vec2 corner;
out vec2 place;
void main() {
  place = corner * size + middle.xz;
  gl_Position = camera * vec4(place.x, middle.y, place.y, 1);
}`;
const kGroundFragment = `#version 300 es
precision highp float;
uniform vec3 middle, line;
uniform float size, cell;
in vec2 place;
out vec4 color;
void main() {
  vec2 at = place / cell, width = fwidth(at), near = abs(fract(at - 0.5) - 0.5) / width;
  float strength = (1.0 - min(min(near.x, near.y), 1.0)) * (1.0 - smoothstep(0.2, 1.0, length(place - middle.xz) / size));
  strength *= 1.0 - smoothstep(0.2, 0.5, max(width.x, width.y));
  color = vec4(line, 1) * 0.5 * strength;
}`;
