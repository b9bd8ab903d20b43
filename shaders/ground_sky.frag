// The share of the sky's light that a point of the ground gets.
in vec2 screenUv;
uniform vec4 square;  // middle (x, z), half size, height
out vec4 share;

void main() {
  vec2 xz = square.xy + (screenUv * 2.0 - 1.0) * square.z;
  vec3 world = vec3(xz.x, square.w, xz.y);
  float light = 0.0;
  float all = 0.0;
  for (int i = 0; i < mapCount.x; ++i) {
    light += seesSky(i, world, 0.004) * mapDirection[i].y;
    all += mapDirection[i].y;
  }
  share = vec4(light / all);
}
