// The ground seen edge-on, as in an elevation: a line through its middle, and a faint shade under it.
out vec2 local;  // -1 to 1 along; device px below the line

const float kShadePx = 36.0;

void main() {
  float along = float(gl_VertexID & 1) * 2.0 - 1.0;
  vec3 world = vec3(ground.x, ground.z, ground.y) + groundAcross.xyz * along;
  vec4 clip = worldToClip * vec4(world, 1.0);
  float down = (gl_VertexID >> 1) == 1 ? kShadePx * viewport.z : -2.0 * viewport.z;
  local = vec2(along, down);
  gl_Position = clip + vec4(0.0, -down * 2.0 / viewport.y * clip.w, 0.0, 0.0);
}
