uniform samplerBuffer materials;
uniform int drawn_part;  // a DrawnPart: not_clear or clear
flat in ivec4 labels;

void main() {
  bool clear = texelFetch(materials, 16 * (labels.w & 0xffff) + 10).r > 0.0;
  if ((drawn_part == 4) != clear) discard;
}
