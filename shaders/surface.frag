in vec3 world;
in vec3 worldNormal;
in vec2 surfaceUv;
flat in vec4 surfaceMaterial;
#ifdef HAS_IMAGE
uniform sampler2D image;
#endif
out vec4 color;

// What a mirror shows in direction r: sky over a soft skyline. Below the horizon the same once more, as in water: a pane that is seen
// from above would show nothing but paper otherwise.
vec3 surroundings(vec3 r) {
  float height = abs(r.y);
  vec3 sky = mix(vec3(0.88, 0.93, 0.97), vec3(0.40, 0.58, 0.82), sqrt(height));
  float around = atan(r.x, r.z);
  float skyline = 0.070 + 0.030 * sin(around * 5.0) + 0.018 * sin(around * 13.0 + 1.0);
  return mix(vec3(0.34, 0.39, 0.40), sky, smoothstep(skyline - 0.04, skyline + 0.04, height));
}

void main() {
  vec3 n = normalize(worldNormal);
  vec3 viewer = towardsViewer(world);
  if (dot(n, viewer) < 0.0) n = -n;
  vec3 flatNormal = n;
  Surface s = Surface(surfaceMaterial.rgb, vec2(0.0), surfaceMaterial.a);
#ifdef HAS_IMAGE
  s.albedo *= texture(image, surfaceUv).rgb;
#endif
  applyPattern(s, surfaceUv);
#if PATTERN == PATTERN_PLASTER || PATTERN == PATTERN_ROOF_TILES
  // u runs level, v up the slope.
  vec3 across = abs(n.y) > 0.998 ? vec3(1.0, 0.0, 0.0) : normalize(vec3(n.z, 0.0, -n.x));
  n = normalize(n - across * s.slope.x - cross(n, across) * s.slope.y);
#endif

  float facing = dot(n, sun.xyz);
  float sunShare = facing > 0.0 && dot(flatNormal, sun.xyz) > 0.0 ? sunVisibility(world, flatNormal) : 0.0;
  vec3 ambient = ambientLight(world, flatNormal, n);
#if PATTERN == PATTERN_LEAVES
  // Light comes through leaves as well.
  vec3 diffuse = s.albedo * (ambient + kSunLight * sunShare * (0.35 + 0.65 * max(facing, 0.0)));
#else
  vec3 diffuse = s.albedo * (ambient + kSunLight * sunShare * max(facing, 0.0));
#endif

  vec3 radiance = diffuse;
#if PATTERN == PATTERN_GLASS || PATTERN == PATTERN_METAL
  float grazing = pow(1.0 - clamp(dot(n, viewer), 0.0, 1.0), 5.0);
  vec3 mirrored = reflect(-viewer, n);
  // Reflections dim where the sky does: in reveals and under eaves.
  vec3 reflected = surroundings(mirrored) * clamp(0.35 + 0.9 * dot(ambient, vec3(0.5)), 0.0, 1.0);
#if PATTERN == PATTERN_GLASS
  radiance = mix(s.albedo * ambient * 0.7, reflected, 0.22 + 0.78 * grazing);
#else
  float sheen = 1.0 - s.roughness;
  radiance = mix(diffuse, reflected * mix(s.albedo, vec3(1.0), grazing), sheen * 0.55);
#endif
#endif
  if (s.roughness < 0.7 && sunShare > 0.0) {
    float power = exp2(9.0 * (1.0 - s.roughness) + 1.0);
    float glint = pow(max(dot(n, normalize(sun.xyz + viewer)), 0.0), power);
    radiance += kSunLight * sunShare * glint * (0.7 - s.roughness) * 0.5;
  }
  color = vec4(toSrgb(toneMap(radiance)) + dither(), 1.0);
}
