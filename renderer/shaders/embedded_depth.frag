uniform samplerBuffer materials;
uniform bool skips_clear;
flat in ivec4 labels;

// What lets light through casts no shadow.
void main() {
  if (skips_clear && texelFetch(materials, 11 * (labels.w & 0xffff) + 10).r > 0.0) discard;
}
