in vec3 world;
uniform sampler2D groundLight;
out vec4 premultiplied;

void main() {
  float distanceShare = length(world.xz - ground.xy) / ground.w;
  float fade = groundFade.x * (1.0 - smoothstep(0.25, 1.0, distanceShare));
  vec2 onSquare = (world.xz - groundSquare.xy) / groundSquare.z;
  vec2 shares = vec2(1.0);
  if (max(abs(onSquare.x), abs(onSquare.y)) < 1.0) shares = texture(groundLight, onSquare * 0.5 + 0.5).rg;
  // Shade is laid over the background, cool where the sun is missing, neutral where the sky is.
  float sunShade = (1.0 - shares.r) * 0.34;
  float skyShade = (1.0 - shares.g) * 0.40;
  float shade = 1.0 - (1.0 - sunShade) * (1.0 - skyShade);
  vec3 tint = mix(vec3(0.24, 0.28, 0.36), vec3(0.22, 0.21, 0.20), skyShade / max(shade + 1e-4, sunShade + skyShade));
  premultiplied = vec4((tint + dither() * 2.0) * shade, shade) * fade;
}
