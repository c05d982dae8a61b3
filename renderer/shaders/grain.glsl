// Fracture surfaces: patterns in a body's own coordinates, so that they move with it and continue from piece to piece.
// Details smaller than a pixel fade to the mean.
const int kStones = 1, kClay = 2, kSand = 3, kCrystals = 4, kFacets = 5, kVeins = 6, kRings = 7,
          kBricks = 8, kCast = 9;  // Grain

struct Matter {
  vec3 tint;  // factor on the material's color
  vec3 slope;  // perturbation of the normal
};

uint hash(ivec3 place) {
  uint n = uint(place.x) * 73856093u ^ uint(place.y) * 19349663u ^ uint(place.z) * 83492791u;
  n = (n ^ (n >> 15)) * 0x2c1b3c6du;
  n = (n ^ (n >> 12)) * 0x297a2d39u;
  return n ^ (n >> 15);
}

vec4 lattice_value(ivec3 place) {
  uint n = hash(place);
  return vec4(n & 255u, (n >> 8) & 255u, (n >> 16) & 255u, n >> 24) / 255.0 - 0.5;
}

// Returns four smooth random values at a point, each in -1/2..1/2.
vec4 noise(vec3 place) {
  ivec3 cell = ivec3(floor(place));
  vec3 t = place - floor(place);
  t = t * t * (3.0 - 2.0 * t);
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 8; ++i) {
    ivec3 corner = ivec3(i & 1, (i >> 1) & 1, i >> 2);
    vec3 share = mix(1.0 - t, t, vec3(corner));
    sum += share.x * share.y * share.z * lattice_value(cell + corner);
  }
  return sum;
}

// Returns the visibility of a pattern with `pixel` cells per pixel.
float seen(float pixel) { return 1.0 - smoothstep(0.25, 0.8, pixel); }

#ifdef GRAIN
// Rotates lattices against faces and each other, so that no face shows one.
const mat3 kTurn = mat3(0.36, 0.48, -0.80, -0.80, 0.60, 0.0, 0.48, 0.64, 0.60);

// Round stones of three sizes, one per cell, large before small. `fill`: radius of the largest, up to 1/2; `tones`:
// variation of colors by channel; `pit`: tone below which there is a pore instead of a stone.
void lay_stones(inout Matter matter, vec3 place, float pixel, vec4 warp, float fill, vec3 tones, float pit) {
  for (int size = 0; size < 3; ++size) {
    float scale = size == 0 ? 4.3 : size == 1 ? 2.1 : 1.0;
    vec3 there = scale * place + 0.3 * warp.xyz + 17.0 * float(size);
    place = kTurn * place;
    ivec3 cell = ivec3(floor(there));
    vec4 random = lattice_value(cell);
    float radius = fill * (0.9 + 0.2 * random.w);
    vec3 away = there - vec3(cell) - 0.5 - (1.0 - 2.0 * radius) * random.xyz;
    float width = max(scale * pixel, 0.03);
    float cover = smoothstep(-width, width, radius - length(away)) * seen(scale * pixel);
    float tone = fract(37.0 * random.w + 0.5) - 0.5;
    bool is_pit = tone < pit;
    matter.tint = mix(matter.tint, is_pit ? vec3(0.66) : 1.0 + tone * tones, cover);
    matter.slope = mix(matter.slope, (is_pit ? -0.5 : 0.5) * transpose(kTurn) * away / radius, 0.7 * cover);
  }
}

// Space-filling grains: cells of points (Worley 1996). One in four is dark. `contrast`: of their colors; `tilt`: of
// their faces, as a slope.
void grow_crystals(inout Matter matter, vec3 place, float pixel, float contrast, float tilt) {
  ivec3 first = ivec3(floor(place - 0.5));
  vec4 nearest = vec4(0.0), second = vec4(0.0);
  float distance = 9.0, second_distance = 9.0;
  for (int i = 0; i < 8; ++i) {
    ivec3 cell = first + ivec3(i & 1, (i >> 1) & 1, i >> 2);
    vec4 random = lattice_value(cell);
    float there = length(place - vec3(cell) - 0.5 - 0.7 * random.xyz);
    if (there < distance) {
      second = nearest;
      second_distance = distance;
      nearest = random;
      distance = there;
    } else if (there < second_distance) {
      second = random;
      second_distance = there;
    }
  }
  float other = 0.5 - 0.5 * smoothstep(0.0, max(pixel, 0.02), second_distance - distance);
  vec4 grain = mix(nearest, second, other);
  vec3 pale = 1.25 + (fract(29.0 * nearest.w) - 0.5) * vec3(0.55, 0.40, 0.35);
  vec3 color = mix(pale, vec3(0.52, 0.51, 0.53), 1.0 - smoothstep(-0.27, -0.23, grain.w));
  matter.tint *= mix(vec3(1.0), color, contrast * seen(pixel));
  matter.slope += tilt * seen(pixel) * grain.xyz;
}

// Veins along the zero set of smooth noise, with varying width.
void draw_veins(inout Matter matter, vec3 place, float pixel) {
  vec4 large = noise(place), small = noise(2.7 * place + 5.0);
  float away = abs(large.x + 0.45 * small.x), width = 0.012 + 0.06 * max(large.y + 0.5 * small.y, 0.0);
  float vein = (1.0 - smoothstep(0.0, width + pixel, away)) * width / (width + pixel) * seen(pixel);
  matter.tint *= (1.0 + seen(pixel) * (0.03 + 0.10 * large.z)) * (1.0 - vein * vec3(0.42, 0.40, 0.36));
}

// Growth rings around a distant pith, darker toward their ends, with fibers. `fiber`: along the grain, unit length.
void grow_rings(inout Matter matter, vec3 place, vec3 fiber, float pixel) {
  vec3 across = place - 0.96 * fiber * dot(fiber, place);
  vec4 fibers = noise(4.0 * across);
  float rings = length(place - fiber * dot(fiber, place) + vec3(5.3, 3.1, 6.7)) + 0.5 * noise(0.35 * across).x;
  float t = fract(rings);
  float late = smoothstep(0.25, 0.9, t) * (1.0 - smoothstep(0.94, 1.0, t)) - 0.37;
  matter.tint *= 1.0 - late * seen(pixel) * vec3(0.30, 0.40, 0.50) + 0.45 * seen(2.0 * pixel) * fibers.w;
  matter.slope += 1.2 * seen(2.0 * pixel) * (fibers.xyz - fiber * dot(fiber, fibers.xyz));
}

// Share of joints within a pixel, exact along one axis: joints of that share of the period surround whole numbers.
float joints_within(float place, float share, float pixel) {
  vec2 ends = place + 0.5 * share + vec2(-0.5, 0.5) * pixel;
  vec2 sums = share * floor(ends) + min(fract(ends), share);
  return (sums.y - sums.x) / pixel;
}

// Bricks in running bond, courses along y, with mortar between them; `size`: length of a brick with a joint. Joints in the plane
// of a face are not seen in it. `facing`: normal of the face at rest.
void lay_bricks(inout Matter matter, vec3 rest, float size, float pixel, vec3 color, vec3 facing) {
  const vec3 kBrick = vec3(1.0, 0.31, 0.5), kMortar = vec3(0.70, 0.675, 0.63);
  const float kJoint = 0.024, kBevel = 0.03;
  vec3 place = rest / (size * kBrick), share = 2.0 * kJoint / kBrick, width = max(pixel, 0.012) / kBrick;
  place.xz += 0.5 * mod(floor(place.y), 2.0);
  vec3 joints;
  for (int i = 0; i < 3; ++i) {
    joints[i] = joints_within(place[i], share[i], width[i]);
    float other = joints_within(place[i] + 0.5, share[i], width[i]);  // in the next course
    if (i != 1) joints[i] = mix(joints[i], other, 0.5 * smoothstep(0.5, 1.5, width.y));
  }
  joints = mix(joints, share, smoothstep(0.5, 0.95, width.y));  // no moiré of courses that pixels hardly resolve
  vec3 bricks = mix(1.0 - joints, vec3(1.0), step(0.7, abs(facing)));
  float brick = bricks.x * bricks.y * bricks.z;
  vec3 within = fract(place) - 0.5;
  vec3 away = (0.5 - abs(within)) * kBrick + 9.0 * step(0.7, abs(facing));
  float nearest = min(away.x, min(away.y, away.z)), joints_seen = 1.0 - smoothstep(0.14, 0.4, width.y);
  vec3 across = sign(within) * step(away, vec3(nearest));
  vec4 random = lattice_value(ivec3(floor(place)));
  vec3 tone = 1.0 + vec3(0.34, 0.38, 0.36) * random.x + vec3(0.0, 0.10, 0.12) * random.y;
  vec3 joint = kMortar * (1.0 + 0.12 * random.z * joints_seen) / max(color, 0.05);
  matter.tint *= mix(joint, mix(vec3(1.0), tone, seen(width.y)), brick);
  matter.slope += joints_seen * 1.2 * across * (1.0 - smoothstep(kJoint, kJoint + kBevel, nearest)) * brick;
}

// `rest`: the point [m]; `size`: of the grain [m]; `pixel`: width of a pixel [m].
void add_grain(inout Matter matter, int kind, vec3 rest, float size, vec3 fiber, float pixel, vec4 warp, vec3 color,
               vec3 facing) {
  vec3 place = kTurn * rest / size;
  pixel /= size;
  if (kind == kStones) lay_stones(matter, place, pixel, warp, 0.47, vec3(0.62, 0.56, 0.48), -0.5);
  if (kind == kClay) lay_stones(matter, place, pixel, warp, 0.34, vec3(0.45, 0.50, 0.55), -0.3);
  if (kind == kSand) lay_stones(matter, place, pixel, warp, 0.45, vec3(0.34, 0.31, 0.26), -0.5);
  if (kind == kCrystals) grow_crystals(matter, place + 0.5 * warp.xyz, pixel, 0.7, 0.6);
  if (kind == kFacets) grow_crystals(matter, place + 0.5 * warp.xyz, pixel, 0.3, 0.9);
  if (kind == kVeins) {
    grow_crystals(matter, 5.0 * place, 5.0 * pixel, 0.12, 0.5);
    draw_veins(matter, 0.35 * place, 0.35 * pixel);
  }
  if (kind == kBricks) lay_bricks(matter, rest, size, pixel, color, facing);
  if (kind == kCast) lay_stones(matter, place, pixel, warp, 0.24, vec3(0.10), -0.36);
  if (kind == kRings) grow_rings(matter, rest / size, normalize(fiber + vec3(1e-6, 0.0, 0.0)), pixel);
}
#endif
