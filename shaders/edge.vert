// Four vertices an edge: the corners around it on screen. Edges that are not to be inked collapse to nothing.
layout(location = 0) in vec3 a;
layout(location = 1) in vec3 b;
layout(location = 2) in vec4 normalA;
layout(location = 3) in vec4 normalB;
layout(location = 4) in float width;  // of the narrower face (m); negative: a round surface's edge

out vec2 local;            // device px: along, across
flat out vec2 stroke;      // device px: length, half width
flat out float strength;

const vec4 kNowhere = vec4(2.0, 2.0, 2.0, 1.0);

// Clip position of a point, drawn a little nearer along its line of sight, so that the faces beside the edge do not hide it.
vec4 toClip(vec3 world) {
  vec4 clip = worldToClip * vec4(world, 1.0);
  float metresPerPx = max(clip.w, 0.0) / viewport.w;
  return worldToClip * vec4(world + towardsViewer(world) * metresPerPx * 0.9, 1.0);
}

void main() {
  local = vec2(0.0);
  stroke = vec2(0.0);
  strength = 0.0;
  gl_Position = kNowhere;
  vec3 middle = (a + b) * 0.5;
  vec3 viewer = towardsViewer(middle);
  bool frontA = dot(normalA.xyz, viewer) > 0.0;
  bool frontB = dot(normalB.xyz, viewer) > 0.0;
  bool contour = frontA != frontB;
  if (!contour && (width < 0.0 || !frontA)) return;

  vec4 clipA = toClip(a);
  vec4 clipB = toClip(b);
  // What lies before the near plane is cut away.
  float beyondA = clipA.z + clipA.w;
  float beyondB = clipB.z + clipB.w;
  if (beyondA <= 0.0 && beyondB <= 0.0) return;
  if (beyondA < 0.0) clipA = mix(clipA, clipB, beyondA / (beyondA - beyondB) * 1.0001);
  if (beyondB < 0.0) clipB = mix(clipB, clipA, beyondB / (beyondB - beyondA) * 1.0001);
  vec2 pxA = clipA.xy / clipA.w * 0.5 * viewport.xy;
  vec2 pxB = clipB.xy / clipB.w * 0.5 * viewport.xy;
  float len = length(pxB - pxA);
  if (len < 1e-3) return;

  // What would run together on screen fades out.
  float ratio = viewport.z;
  float pxPerMetre = viewport.w / mix(clipA.w, clipB.w, 0.5);
  float widthPx = width < 0.0 ? 1e3 : width * pxPerMetre / ratio;
  float halfWidth = (contour ? 0.62 : 0.5) * ratio;
  strength = contour ? 0.62 * smoothstep(0.6, 3.0, widthPx) : 0.34 * smoothstep(1.5, 7.0, widthPx);
  if (strength <= 0.004) return;

  vec2 along = (pxB - pxA) / len;
  vec2 across = vec2(-along.y, along.x);
  bool atB = (gl_VertexID & 1) == 1;
  float side = (gl_VertexID & 2) == 2 ? 1.0 : -1.0;
  local = vec2(atB ? len + 0.5 : -0.5, side * (halfWidth + 0.5));
  stroke = vec2(len, halfWidth);
  vec4 clip = atB ? clipB : clipA;
  vec2 offset = along * (atB ? 0.5 : -0.5) + across * local.y;
  gl_Position = clip + vec4(offset * 2.0 / viewport.xy * clip.w, 0.0, 0.0);
}
