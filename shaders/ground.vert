out vec3 world;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  vec2 xz = ground.xy + corner * ground.w;
  world = vec3(xz.x, ground.z, xz.y);
  gl_Position = worldToClip * vec4(world, 1.0);
}
