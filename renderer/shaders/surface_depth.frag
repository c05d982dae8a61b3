const int kClear = 64;  // TriangleFlag
uniform usamplerBuffer flags;
uniform bool skips_clear;

// What lets light through casts no shadow.
void main() {
  if (skips_clear && (int(texelFetch(flags, gl_PrimitiveID).r) & kClear) != 0) discard;
}
