// How much of each scope's box is seen, counted in samples of the model's depth: silhouette/scope_visibility.h says what counts. Sixteen texels a
// scope, side by side, share the columns of its box on screen; visibility_sum.frag adds them up.
uniform mat4 worldToClip;
uniform vec4 eye;        // w: distance of the near plane
uniform vec4 forward;    // unit, into the picture; w: 1 for a parallel projection
uniform float skin;
uniform ivec2 scopes;    // how many, and how many stand over each other
uniform highp sampler2D modelDepth;
uniform highp sampler2D boxes;   // four texels a scope: origin, and the three axes, as long as the box is
// Samples covered, of those seen, whether the box's middle is seen, and which of its edges are, a bit each (SeenEdges): a texel looks at one, so that sums are sets.
layout(location = 0) out uvec4 counts;

const int kColumns = 16;
// Samples looked at along either side of a box on screen, at most; of a larger one every second, third ...
const int kGrid = 64;
const int kEdges = 12;
const int kEdgePoints = 8;

vec3 directionTo(vec3 p) { return forward.w > 0.5 ? forward.xyz : normalize(p - eye.xyz); }

bool inFrontOfNear(vec3 p) { return dot(p - eye.xyz, forward.xyz) >= eye.w; }

// Whether a point, moved nearer by the skin, is not behind the model at a sample.
bool seenAt(vec3 p, ivec2 texel) {
  vec4 clip = worldToClip * vec4(p - directionTo(p) * skin, 1.0);
  return clip.z / clip.w * 0.5 + 0.5 <= texelFetch(modelDepth, texel, 0).r;
}

vec3 boxTexel(int scope, int i) {
  int texel = scope * 4 + i;
  int width = textureSize(boxes, 0).x;
  return texelFetch(boxes, ivec2(texel % width, texel / width), 0).xyz;
}

// As CpuVisibility has it: the ends are moved nearer and projected, and what lies between them lies between their clip coordinates.
bool edgeSeen(vec3 origin, mat3 edges, int edge) {
  int axis = edge / 4;
  vec3 from = origin + edges[(axis + 1) % 3] * float(edge & 1) + edges[(axis + 2) % 3] * float(edge >> 1 & 1);
  vec3 to = from + edges[axis];
  vec4 a = worldToClip * vec4(from - directionTo(from) * skin, 1.0), b = worldToClip * vec4(to - directionTo(to) * skin, 1.0);
  int points = 0, seen = 0;
  for (int i = 0; i < kEdgePoints; ++i) {
    vec4 clip = mix(a, b, (float(i) + 0.5) / float(kEdgePoints));
    vec3 ndc = clip.xyz / clip.w;
    if (!(clip.w > 0.0) || any(greaterThanEqual(abs(ndc.xy), vec2(1.0)))) continue;
    ++points;
    ivec2 texel = ivec2((ndc.xy * 0.5 + 0.5) * vec2(textureSize(modelDepth, 0)));
    if (ndc.z * 0.5 + 0.5 <= texelFetch(modelDepth, texel, 0).r) ++seen;
  }
  return 2 * seen >= points;
}

void main() {
  counts = uvec4(0u);
  ivec2 texel = ivec2(gl_FragCoord.xy);
  int scope = texel.x / kColumns * scopes.y + texel.y;
  int chunk = texel.x % kColumns;
  if (scope >= scopes.x) return;
  vec3 origin = boxTexel(scope, 0);
  mat3 edges = mat3(boxTexel(scope, 1), boxTexel(scope, 2), boxTexel(scope, 3));
  ivec2 size = textureSize(modelDepth, 0);

  if (chunk == 0) {
    vec3 middle = origin + edges * vec3(0.5);
    vec4 clip = worldToClip * vec4(middle, 1.0);
    vec2 ndc = clip.xy / clip.w;
    if (inFrontOfNear(middle) && all(lessThan(abs(ndc), vec2(1.0)))) {
      counts.z = seenAt(middle, ivec2((ndc * 0.5 + 0.5) * vec2(size))) ? 1u : 0u;
    }
  }
  if (chunk < kEdges && edgeSeen(origin, edges, chunk)) counts.w = 1u << chunk;

  // The samples that the box may cover: all when it reaches behind the near plane.
  vec2 low = vec2(size), high = vec2(0.0);
  bool crossesNear = false;
  for (int i = 0; i < 8; ++i) {
    vec3 corner = origin + edges * vec3(i & 1, (i >> 1) & 1, i >> 2);
    if (!inFrontOfNear(corner)) crossesNear = true;
    vec4 clip = worldToClip * vec4(corner, 1.0);
    vec2 at = (clip.xy / clip.w * 0.5 + 0.5) * vec2(size);
    low = min(low, at);
    high = max(high, at);
  }
  ivec2 first = crossesNear ? ivec2(0) : ivec2(clamp(floor(low), vec2(0.0), vec2(size)));
  ivec2 last = crossesNear ? size - 1 : ivec2(clamp(floor(high), vec2(-1.0), vec2(size - 1)));
  ivec2 span = last - first + 1;
  if (span.x <= 0 || span.y <= 0) return;
  ivec2 stride = (span + kGrid - 1) / kGrid;

  // The faces towards the viewer, three at most, each with the map from a sample to the point of the face that it shows.
  mat3 faceOfClip[3];
  mat3 faces[3];   // corner, and the two edges
  int faceCount = 0;
  for (int i = 0; i < 6; ++i) {
    int axis = i % 3;
    vec3 corner = i < 3 ? origin : origin + edges[axis];
    vec3 u = edges[(axis + 1) % 3], v = edges[(axis + 2) % 3];
    vec3 normal = cross(u, v) * (i < 3 ? -1.0 : 1.0);
    if (dot(normal, normal) == 0.0 || dot(normal, directionTo(corner + 0.5 * (u + v))) > 0.0) continue;
    mat3 clipOfFace = mat3((worldToClip * vec4(u, 0.0)).xyw, (worldToClip * vec4(v, 0.0)).xyw, (worldToClip * vec4(corner, 1.0)).xyw);
    if (determinant(clipOfFace) == 0.0 || faceCount == 3) continue;
    faceOfClip[faceCount] = inverse(clipOfFace);
    faces[faceCount] = mat3(corner, u, v);
    ++faceCount;
  }

  uint weight = uint(stride.x * stride.y);
  for (int column = chunk; column * stride.x < span.x; column += kColumns) {
    for (int row = 0; row * stride.y < span.y; ++row) {
      ivec2 at = min(first + ivec2(column, row) * stride + stride / 2, last);
      vec3 ndc = vec3((vec2(at) + 0.5) / vec2(size) * 2.0 - 1.0, 1.0);
      for (int i = 0; i < faceCount; ++i) {
        vec3 on = faceOfClip[i] * ndc;
        vec2 uv = on.xy / on.z;
        if (!(on.z > 0.0) || any(lessThan(uv, vec2(0.0))) || any(greaterThan(uv, vec2(1.0)))) continue;
        vec3 p = faces[i][0] + faces[i][1] * uv.x + faces[i][2] * uv.y;
        if (!inFrontOfNear(p)) continue;
        counts.x += weight;
        if (seenAt(p, at)) counts.y += weight;
        break;
      }
    }
  }
}
