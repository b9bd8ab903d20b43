in vec2 local;
flat in vec4 shape;
flat in vec2 shapeLean;
flat in vec3 shapeHiding;
flat in uint shapeKind;
flat in vec4 shapeColor;
uniform vec3 viewport;
uniform highp sampler2D depths;  // of the picture below
uniform float hiderReach;        // kHiderReachPx
out vec4 premultiplied;

// How much of a pixel, whose middle is at x and which is 1 wide, lies in [low, high].
float overlap(float x, float low, float high) { return clamp(min(high, x + 0.5) - max(low, x - 0.5), 0.0, 1.0); }

// Whether the model is before the line here, and all around here.
bool hidden() {
  float depth = mix(shapeHiding.x, shapeHiding.y, clamp(local.x / max(shape.x, 1e-3), 0.0, 1.0));
  vec2 size = viewport.xy * viewport.z;
  vec2 at = gl_FragCoord.xy / size;
  if (texture(depths, at).r >= depth) return false;
  vec2 reach = vec2(hiderReach * viewport.z) / size;
  for (int i = 0; i < 8; ++i) {
    float turn = float(i) * 0.7854;
    if (texture(depths, at + reach * vec2(cos(turn), sin(turn))).r >= depth) return false;
  }
  return true;
}

void main() {
  float ratio = viewport.z;
  float len = shape.x;
  float halfWidth = shape.y;
  float softness = shape.z;
  float coverage;
  if (shapeKind == 0u) {
    if (softness > 0.0) {
      vec2 inside = vec2(min(local.x, len - local.x), halfWidth - abs(local.y));
      coverage = clamp(inside.x * ratio + 0.5, 0.0, 1.0) * smoothstep(0.0, softness, inside.y);
    } else {
      coverage = overlap(local.x * ratio, 0.0, len * ratio) * overlap(local.y * ratio, -halfWidth * ratio, halfWidth * ratio);
      if (shape.w > 0.0) {
        // The dash that is nearest, gaps as long as dashes.
        float period = 2.0 * shape.w;
        float fromMiddle = local.x - (floor(local.x / period) * period + 0.5 * shape.w);
        if (fromMiddle > shape.w) fromMiddle -= period;
        coverage *= overlap(fromMiddle * ratio, -0.5 * shape.w * ratio, 0.5 * shape.w * ratio);
      }
    }
  } else if (shapeKind == 2u) {
    // Each pixel belongs to the one piece between whose ends it lies: no seam is drawn twice, none is left out.
    bool inPiece = local.x >= shapeLean.x * local.y && local.x < len + shapeLean.y * local.y;
    float across = softness > 0.0 ? smoothstep(0.0, softness, halfWidth - abs(local.y))
                                  : overlap(local.y * ratio, -halfWidth * ratio, halfWidth * ratio);
    coverage = inPiece ? across : 0.0;
  } else if (shapeKind == 3u) {
    float inside = halfWidth - length(local - vec2(halfWidth, 0.0));
    coverage = softness > 0.0 ? smoothstep(0.0, softness, inside) : clamp(inside * ratio + 0.5, 0.0, 1.0);
  } else {
    // Distances inwards from the slanted sides and from the back.
    float slope = halfWidth / len;
    float side = (local.x * slope - abs(local.y)) * inversesqrt(1.0 + slope * slope);
    float back = len - local.x;
    coverage = softness > 0.0 ? smoothstep(0.0, softness, min(side, back))
                              : clamp(side * ratio + 0.5, 0.0, 1.0) * clamp(back * ratio + 0.5, 0.0, 1.0);
  }
  float opacity = shapeColor.a * coverage;
  if (opacity > 0.0 && shapeHiding.z < 1.0 && hidden()) opacity *= shapeHiding.z;
  if (opacity <= 0.0) discard;
  premultiplied = vec4(shapeColor.rgb * opacity, opacity);
}
