// Depth alone, exactly as surface.vert has it.
layout(location = 0) in vec3 position;

invariant gl_Position;

void main() {
  vec3 world = toWorld(position);
  gl_Position = worldToClip * vec4(world, 1.0);
}
