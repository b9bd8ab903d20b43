in vec2 local;
flat in vec2 stroke;
flat in float strength;
out vec4 premultiplied;

const vec3 kInk = vec3(0.13, 0.12, 0.13);

// How much of a pixel, whose middle is at x and which is 1 wide, lies in [low, high].
float overlap(float x, float low, float high) { return clamp(min(high, x + 0.5) - max(low, x - 0.5), 0.0, 1.0); }

void main() {
  float opacity = strength * overlap(local.x, 0.0, stroke.x) * overlap(local.y, -stroke.y, stroke.y);
  premultiplied = vec4(kInk * opacity, opacity);
}
