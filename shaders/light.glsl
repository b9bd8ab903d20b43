// Sun and sky on a surface. Radiance is in units in which a white wall in full sun is about 1.
uniform sampler2DShadow shadowMap;
uniform sampler3D skyVolume;

const vec3 kSunLight = vec3(1.00, 0.93, 0.82) * 1.22;
const vec3 kSkyLight = vec3(0.89, 0.945, 1.00) * 0.73;
const vec3 kBounceLight = vec3(1.00, 0.95, 0.88) * 0.48;

// Share of the sun that a point sees.
float sunVisibility(vec3 world, vec3 normal) {
  vec3 at = (worldToShadow * vec4(world + normal * (sun.w * 1.5), 1.0)).xyz;
  at.z = min(at.z, 1.0);
  vec2 texel = 1.0 / vec2(textureSize(shadowMap, 0));
  // Each look-up is filtered over four texels; a few of them over a disc make the edge soft.
  float lit = 0.0;
  for (int i = 0; i < detail.x; ++i) lit += textureLod(shadowMap, vec3(at.xy + shadowDisc[i].xy * texel, at.z), 0.0);
  return lit / float(detail.x);
}

// Light from the sky and from the ground, less what the model itself hides of them. `flatNormal`: of the surface without its relief.
vec3 ambientLight(vec3 world, vec3 flatNormal, vec3 normal) {
  vec4 c = textureLod(skyVolume, (world + flatNormal * skyOrigin.w - skyOrigin.xyz) * skyScale.xyz, 0.0);
  float open = c.a;                                                       // 1: all of the sky
  float skyShare = clamp(0.5 * open + dot(c.rgb - 0.5, normal), 0.0, 1.0);
  // What the ground throws back reaches where the sky does too, by and large.
  float groundShare = (0.5 - 0.5 * normal.y) * mix(0.35, 1.0, open);
  return kSkyLight * skyShare + kBounceLight * groundShare;
}
