// What surfaces are made of, drawn from uv in metres. Everything is averaged over a pixel's footprint, and what is finer than a pixel fades to
// its mean, so that nothing shimmers when the camera moves. PATTERN is Material::Pattern. What a reduced picture leaves out stands in loops,
// because software rasterizers do not skip branches that are not taken.
#define PATTERN_PLAIN 0
#define PATTERN_BRICK 1
#define PATTERN_PLASTER 2
#define PATTERN_PLANKS 3
#define PATTERN_ROOF_TILES 4
#define PATTERN_STONE 5
#define PATTERN_GLASS 6
#define PATTERN_METAL 7
#define PATTERN_GRASS 8
#define PATTERN_LEAVES 9
#define PATTERN_FABRIC 10

struct Surface {
  vec3 albedo;
  vec2 slope;       // of a relief, along the surface's axes (u, v)
  float roughness;
};

// Random numbers that belong to a cell, 0 to 1.
float hash(ivec2 cell) {
  uint h = uint(cell.x) * 0x9E3779B1u ^ uint(cell.y) * 0x85EBCA77u;
  h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
  h = (h ^ (h >> 12)) * 0x297A2D39u;
  return float((h ^ (h >> 15)) >> 8) / 16777216.0;
}

// Smooth noise of period one, 0 to 1.
float noise(vec2 p) {
  ivec2 cell = ivec2(floor(p));
  vec2 f = p - floor(p);
  f = f * f * (3.0 - 2.0 * f);
  return mix(mix(hash(cell), hash(cell + ivec2(1, 0)), f.x), mix(hash(cell + ivec2(0, 1)), hash(cell + ivec2(1, 1)), f.x), f.y);
}

// Share of a footprint that lies in the pulses [0, width) of period one.
float pulses(float x, float width, float footprint) {
  footprint = max(footprint, 1e-5);
  float high = x + 0.5 * footprint;
  float low = x - 0.5 * footprint;
  float integralHigh = floor(high) * width + min(fract(high), width);
  float integralLow = floor(low) * width + min(fract(low), width);
  return clamp((integralHigh - integralLow) / footprint, 0.0, 1.0);
}

// 1 where something of period one is well resolved, 0 where it is finer than a pixel.
float resolved(float footprint) { return 1.0 - smoothstep(0.3, 0.8, footprint); }

void brick(inout Surface s, vec2 uv, vec2 footprint) {
  const vec2 size = vec2(0.25, 0.083);
  const vec2 joint = vec2(0.012) / vec2(0.25, 0.083);
  vec2 p = uv / size;
  vec2 f = footprint / size;
  float course = floor(p.y);
  p.x += 0.5 * mod(course, 2.0);
  float mortar = max(pulses(p.y, joint.y, f.y), pulses(p.x, joint.x, f.x));
  float seen = resolved(max(f.x, f.y));
  float tone = hash(ivec2(int(floor(p.x)), int(course)));
  s.albedo *= mix(1.0, 0.82 + 0.34 * tone, seen);
  s.albedo = mix(s.albedo, vec3(0.58, 0.54, 0.49), mortar * 0.75);
}

void plaster(inout Surface s, vec2 uv, vec2 footprint) {
  float f = max(footprint.x, footprint.y);
  float size = 1.1;
  // A broad mottling, then grain that shows from near only.
  for (int layer = 0; layer < detail.y; ++layer) {
    float seen = resolved(f / size);
    float here = noise(uv / size);
    s.albedo *= 1.0 + 0.045 * (here - 0.5) * seen;
    if (layer > 0) s.slope += 0.15 * seen * vec2(noise(uv / size + vec2(0.3, 0.0)) - here, noise(uv / size + vec2(0.0, 0.3)) - here);
    size = 0.035;
  }
}

void planks(inout Surface s, vec2 uv, vec2 footprint) {
  const float board = 0.13;
  float x = uv.x / board;
  float f = footprint.x / board;
  float gap = pulses(x, 0.055, f);
  float tone = hash(ivec2(int(floor(x)), 7));
  s.albedo *= mix(1.0, 0.90 + 0.20 * tone, resolved(f));
  for (int layer = 1; layer < detail.y; ++layer) {
    float grain = noise(vec2(uv.x / 0.012 + tone * 40.0, uv.y / 0.45)) - 0.5;
    s.albedo *= 1.0 + 0.16 * grain * resolved(footprint.x / 0.02);
  }
  s.albedo *= 1.0 - 0.55 * gap;
}

void roofTiles(inout Surface s, vec2 uv, vec2 footprint) {
  const vec2 size = vec2(0.235, 0.34);
  vec2 p = uv / size;
  vec2 f = footprint / size;
  // Pantiles: the lower edge of each course is wavy and stands proud of the course below.
  float phase = 6.2831853 * p.x;
  float seenAcross = resolved(f.x);
  float v = p.y + 0.055 * cos(phase) * seenAcross;
  float tone = hash(ivec2(int(floor(p.x + 0.5)), int(floor(v))));
  float seen = resolved(max(f.x, f.y));
  s.albedo *= mix(1.0, 0.86 + 0.28 * tone, seen);
  s.slope.x += 0.36 * sin(phase) * seenAcross;
  // Its shadow, and the light on the edge itself.
  s.albedo *= 1.0 - 0.38 * pulses(v, 0.13, f.y);
  s.slope.y -= 0.12 * resolved(f.y);
  // The troughs are darker.
  s.albedo *= 1.0 - 0.13 * (1.0 - cos(phase)) * seenAcross - 0.13 * (1.0 - seenAcross);
}

void stone(inout Surface s, vec2 uv, vec2 footprint) {
  const float height = 0.24;
  float y = uv.y / height;
  float course = floor(y);
  float width = 0.38 + 0.22 * hash(ivec2(int(course), 3));
  float x = uv.x / width + hash(ivec2(int(course), 11));
  vec2 f = vec2(footprint.x / width, footprint.y / height);
  float joint = max(pulses(y, 0.045, f.y), pulses(x, 0.03, f.x));
  float tone = hash(ivec2(int(floor(x)), int(course)));
  s.albedo *= mix(1.0, 0.88 + 0.24 * tone, resolved(max(f.x, f.y)));
  for (int layer = 1; layer < detail.y; ++layer) {
    s.albedo *= 1.0 + 0.10 * (noise(uv / 0.11) - 0.5) * resolved(max(footprint.x, footprint.y) / 0.11);
  }
  s.albedo *= 1.0 - 0.34 * joint;
}

void grass(inout Surface s, vec2 uv, vec2 footprint) {
  float f = max(footprint.x, footprint.y);
  s.albedo *= 0.92 + 0.16 * noise(uv * 0.45);
  s.albedo *= 1.0 + 0.35 * (noise(uv / 0.06) - 0.5) * resolved(f / 0.06);
}

void leaves(inout Surface s, vec2 uv, vec2 footprint) {
  float f = max(footprint.x, footprint.y);
  s.albedo *= 1.0 + 0.30 * (noise(uv / 0.25) - 0.5) * resolved(f / 0.25);
}

void fabric(inout Surface s, vec2 uv, vec2 footprint) {
  vec2 p = uv / 0.006;
  float f = max(footprint.x, footprint.y) / 0.006;
  s.albedo *= 1.0 + 0.12 * resolved(f) * sin(6.2831853 * p.x) * sin(6.2831853 * p.y);
}

void applyPattern(inout Surface s, vec2 uv) {
  vec2 footprint = abs(dFdx(uv)) + abs(dFdy(uv));
#if PATTERN == PATTERN_BRICK
  brick(s, uv, footprint);
#elif PATTERN == PATTERN_PLASTER
  plaster(s, uv, footprint);
#elif PATTERN == PATTERN_PLANKS
  planks(s, uv, footprint);
#elif PATTERN == PATTERN_ROOF_TILES
  roofTiles(s, uv, footprint);
#elif PATTERN == PATTERN_STONE
  stone(s, uv, footprint);
#elif PATTERN == PATTERN_GRASS
  grass(s, uv, footprint);
#elif PATTERN == PATTERN_LEAVES
  leaves(s, uv, footprint);
#elif PATTERN == PATTERN_FABRIC
  fabric(s, uv, footprint);
#endif
}
