uniform vec3 top, bottom;
in float height;
layout(location = 0) out vec4 pixel_color;

// Mixed in the encoding, in which equal steps look equal.
void main() { pixel_color = vec4(mix(bottom, top, smoothstep(0.0, 1.0, height)), 1.0); }
