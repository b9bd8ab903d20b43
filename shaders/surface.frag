in vec3 world;
in vec3 worldNormal;
in vec2 surfaceUv;
flat in vec4 surfaceMaterial;
#ifdef HAS_IMAGE
uniform sampler2D image;
#endif
out vec4 color;

void main() {
  vec3 n = normalize(worldNormal);
  vec3 viewer = towardsViewer(world);
  if (dot(n, viewer) < 0.0) n = -n;
  vec3 albedo = surfaceMaterial.rgb;
#ifdef HAS_IMAGE
  albedo *= texture(image, surfaceUv).rgb;
#endif
  float facing = dot(n, sun.xyz);
  vec3 light = ambientLight(world, n);
  if (facing > 0.0) light += kSunLight * (facing * sunVisibility(world, n));
  color = vec4(toSrgb(toneMap(albedo * light)) + dither(), 1.0);
}
