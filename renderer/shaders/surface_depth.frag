const int kClear = 64;  // TriangleFlag
uniform usamplerBuffer flags;
flat in int triangle;
uniform int drawn_part;  // a DrawnPart: not_clear or clear

void main() {
  bool clear = (int(texelFetch(flags, triangle).r) & kClear) != 0;
  if ((drawn_part == 4) != clear) discard;
}
