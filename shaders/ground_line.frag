in vec2 local;
out vec4 premultiplied;

const vec3 kInk = vec3(0.20, 0.20, 0.21);
const float kWidthPx = 1.5;
const float kShadePx = 36.0;

void main() {
  float ends = 1.0 - smoothstep(0.55, 1.0, abs(local.x));
  // The line's upper side is the ground.
  float line = clamp(min(kWidthPx * viewport.z, local.y + 0.5) - max(0.0, local.y - 0.5), 0.0, 1.0);
  float below = local.y > 0.0 ? 1.0 - local.y / (kShadePx * viewport.z) : 0.0;
  float opacity = groundFade.y * ends * max(0.75 * line, 0.10 * below * below);
  premultiplied = vec4(kInk * opacity, opacity);
}
