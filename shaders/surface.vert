layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in uint material;

uniform highp sampler2D materials;

out vec3 world;
out vec3 worldNormal;
out vec2 surfaceUv;
flat out vec4 surfaceMaterial;  // linear base colour, roughness

invariant gl_Position;

void main() {
  world = toWorld(position);
  // Normals go by the inverse transpose, which for a turn and a scale per axis divides by the squared scales.
  vec3 scaleSquared = instanceRowX.xyz * instanceRowX.xyz + instanceRowY.xyz * instanceRowY.xyz + instanceRowZ.xyz * instanceRowZ.xyz;
  vec3 n = normal.xyz / scaleSquared;
  worldNormal = vec3(dot(instanceRowX.xyz, n), dot(instanceRowY.xyz, n), dot(instanceRowZ.xyz, n));
  surfaceUv = uv;
  surfaceMaterial = texelFetch(materials, ivec2(int(material) & 255, int(material) >> 8), 0);
  gl_Position = worldToClip * vec4(world, 1.0);
}
