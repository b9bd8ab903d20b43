// The model seen from directions spread over the sky: depth maps in one atlas, 8 by 4 tiles (SkyLight::Maps).
layout(std140) uniform SkyMaps {
  vec4 mapU[32];
  vec4 mapV[32];
  vec4 mapDepth[32];
  vec4 mapDirection[32];
  ivec4 mapCount;
};
uniform sampler2DShadow skyMaps;

// Whether a point sees the sky in direction i: 0 to 1, filtered. `slack`: depth that is forgiven, as a share of the map's.
float seesSky(int i, vec3 world, float slack) {
  vec4 p = vec4(world, 1.0);
  vec3 at = vec3(dot(mapU[i], p), dot(mapV[i], p), dot(mapDepth[i], p));
  // The border of each tile is empty: what lies outside is looked up there.
  at.xy = clamp(at.xy, vec2(0.008), vec2(0.992));
  vec2 tile = vec2(float(i % 8), float(i / 8));
  return textureLod(skyMaps, vec3((tile + at.xy) / vec2(8.0, 4.0), min(at.z - slack, 1.0)), 0.0);
}
