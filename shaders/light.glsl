// Sun, sky and the way from light to the screen. Radiance is in units in which a white wall in full sun is about 1.
uniform sampler2DShadow shadowMap;

const vec3 kSunLight = vec3(1.00, 0.94, 0.84) * 1.05;
const vec3 kSkyLight = vec3(0.80, 0.90, 1.00) * 0.62;
const vec3 kBounceLight = vec3(1.00, 0.96, 0.90) * 0.38;

// Share of the sun's disc that a point sees. `facing`: cosine between its normal and the sun.
float sunVisibility(vec3 world, vec3 normal) {
  vec3 at = (worldToShadow * vec4(world + normal * (sun.w * 1.5), 1.0)).xyz;
  if (any(lessThan(at.xy, vec2(0.0))) || any(greaterThan(at.xy, vec2(1.0)))) return 1.0;
  vec2 texel = 1.0 / vec2(textureSize(shadowMap, 0));
  float lit = 0.0;
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) lit += texture(shadowMap, vec3(at.xy + vec2(x, y) * texel * 1.5, min(at.z, 1.0)));
  }
  return lit / 9.0;
}

// Light that comes in from all around, for a surface of that normal.
vec3 ambientLight(vec3 normal) { return mix(kBounceLight, kSkyLight, normal.y * 0.5 + 0.5); }

// From radiance to the screen: a soft shoulder above middle tones, then the sRGB curve.
vec3 toneMap(vec3 color) {
  const float start = 0.72;
  vec3 over = max(color - start, vec3(0.0));
  return min(color, vec3(start)) + (1.0 - start) * (vec3(1.0) - exp(-over / (1.0 - start)));
}

vec3 toSrgb(vec3 linear) {
  return mix(linear * 12.92, 1.055 * pow(max(linear, vec3(0.0)), vec3(1.0 / 2.4)) - 0.055, step(vec3(0.0031308), linear));
}

vec3 fromSrgb(vec3 c) { return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(vec3(0.04045), c)); }

// Half a step of the 8-bit screen up or down, in a fine fixed pattern, so that gradients show no bands.
float dither() { return (fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0; }
