// The rows of the affine map from mesh to world, for every shader that draws a GpuScene.
layout(location = 4) in vec4 instanceRowX;
layout(location = 5) in vec4 instanceRowY;
layout(location = 6) in vec4 instanceRowZ;

vec3 toWorld(vec3 positionMesh) {
  vec4 p = vec4(positionMesh, 1.0);
  return vec3(dot(instanceRowX, p), dot(instanceRowY, p), dot(instanceRowZ, p));
}
