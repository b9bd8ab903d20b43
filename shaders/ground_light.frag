// Sun and sky on the ground. The sun's penumbra widens with the distance of what casts it (percentage-closer soft shadows).
in vec2 screenUv;
uniform vec4 square;         // middle (x, z), half size, height
uniform mat4 worldToShadow;
uniform vec3 sunDisc;        // penumbra in the map's units (u, v) per metre from what casts it; metres of the map's depth
uniform vec2 sharpest;        // least penumbra, in the map's units
uniform sampler2DShadow shadowMap;
uniform highp sampler2D shadowDepths;
uniform sampler2D groundSky;
out vec4 shares;

const int kBlockerSamples = 24;
const int kSamples = 48;

// Point i of n spread evenly over the unit disc (a Vogel spiral).
vec2 onDisc(int i, int n) {
  float r = sqrt((float(i) + 0.5) / float(n));
  float angle = float(i) * 2.3999632;
  return r * vec2(cos(angle), sin(angle));
}

void main() {
  vec2 xz = square.xy + (screenUv * 2.0 - 1.0) * square.z;
  vec3 at = (worldToShadow * vec4(xz.x, square.w, xz.y, 1.0)).xyz;
  at.z = min(at.z - 0.0005, 1.0);
  vec2 perDepth = sunDisc.xy * sunDisc.z;
  vec2 widest = at.z * perDepth;
  float blockers = 0.0;
  float depthSum = 0.0;
  for (int i = 0; i < kBlockerSamples; ++i) {
    float depth = textureLod(shadowDepths, clamp(at.xy + onDisc(i, kBlockerSamples) * widest, 0.0, 1.0), 0.0).r;
    if (depth < at.z) {
      blockers += 1.0;
      depthSum += depth;
    }
  }
  float sunShare = 1.0;
  if (blockers > 0.0) {
    // Never sharper than a texel of this texture can show.
    vec2 radius = max((at.z - depthSum / blockers) * perDepth, sharpest);
    float lit = 0.0;
    for (int i = 0; i < kSamples; ++i) lit += textureLod(shadowMap, vec3(clamp(at.xy + onDisc(i, kSamples) * radius, 0.0, 1.0), at.z), 0.0);
    sunShare = lit / float(kSamples);
  }
  // A tent over the coarse map of the sky takes the steps out of it; away from the model, where it is nearly open, a wider one.
  float lod = 2.5 * smoothstep(0.45, 0.90, textureLod(groundSky, screenUv, 2.0).r);
  vec2 texel = exp2(lod) / vec2(textureSize(groundSky, 0));
  float skyShare = 0.0;
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      float weight = (2.0 - abs(float(x))) * (2.0 - abs(float(y))) / 16.0;
      skyShare += weight * textureLod(groundSky, screenUv + vec2(x, y) * texel, lod).r;
    }
  }
  // Towards its edge the square merges into open ground.
  vec2 fromMiddle = abs(screenUv * 2.0 - 1.0);
  float open = smoothstep(0.75, 1.0, max(fromMiddle.x, fromMiddle.y));
  shares = vec4(sunShare, mix(skyShare, 1.0, open), 0.0, 1.0);
}
