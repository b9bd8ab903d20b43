// The whole viewport, with the line of sight through every pixel.
out vec2 screenUv;     // 0 to 1, from the bottom left
out vec4 nearPoint;    // homogeneous: where the line of sight meets the near and the far plane
out vec4 farPoint;

void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
  screenUv = corner;
  vec2 clip = corner * 2.0 - 1.0;
  nearPoint = clipToWorld * vec4(clip, -1.0, 1.0);
  farPoint = clipToWorld * vec4(clip, 1.0, 1.0);
  gl_Position = vec4(clip, 0.0, 1.0);
}
