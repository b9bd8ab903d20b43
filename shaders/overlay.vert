// Four vertices a shape: the corners around it, with room for soft edges.
layout(location = 0) in vec2 startPx;
layout(location = 1) in vec2 endPx;
layout(location = 2) in vec4 measures;  // half width, softness, dash (px); what is left of the opacity where the model hides it
layout(location = 3) in uint kind;
layout(location = 4) in vec4 color;
layout(location = 5) in vec4 leanAndDepths;   // lean at start and end; window depths there

uniform vec3 viewport;  // width and height in CSS px, device pixels per CSS pixel

out vec2 local;             // px: along from the start, across from the axis
flat out vec4 shape;        // length, half width, softness, dash (px)
flat out vec2 shapeLean;
flat out vec3 shapeHiding;  // window depths at start and end; what is left where it is hidden
flat out uint shapeKind;
flat out vec4 shapeColor;

void main() {
  vec2 axis = endPx - startPx;
  float len = length(axis);
  vec2 along = len > 0.0 ? axis / len : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  float room = 1.0 / viewport.z;
  vec2 corner = vec2(gl_VertexID & 1, (gl_VertexID >> 1) & 1);
  local = vec2(mix(-room, len + room, corner.x), mix(-1.0, 1.0, corner.y) * (measures.x + room));
  shape = vec4(len, measures.xyz);
  shapeLean = leanAndDepths.xy;
  shapeHiding = vec3(leanAndDepths.zw, measures.w);
  shapeKind = kind;
  shapeColor = color;
  vec2 px = startPx + along * local.x + across * local.y;
  gl_Position = vec4(px.x / viewport.x * 2.0 - 1.0, 1.0 - px.y / viewport.y * 2.0, 0.0, 1.0);
}
