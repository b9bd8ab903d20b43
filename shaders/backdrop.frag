// Paper, and on it the ground: nothing but the shade that the model casts, fading out around it.
in vec2 screenUv;
in vec4 nearPoint;
in vec4 farPoint;
uniform sampler2D groundLight;
out vec4 color;

void main() {
  vec3 paper = mix(backgroundBottom.rgb, backgroundTop.rgb, smoothstep(0.0, 1.0, screenUv.y));
  vec3 start = nearPoint.xyz / nearPoint.w;
  vec3 along = farPoint.xyz / farPoint.w - start;
  if (eye.w > 0.0) start = eye.xyz;   // the ground reaches nearer than the near plane
  // Where the line of sight meets the ground, if it looks down.
  if (groundFade.x > 0.0 && along.y < 0.0) {
    vec2 at = start.xz + along.xz * ((ground.z - start.y) / along.y);
    vec2 fromMiddle = (at - ground.xy) / ground.w;
    float fade = groundFade.x * (1.0 - smoothstep(0.0625, 1.0, dot(fromMiddle, fromMiddle)));
    vec2 onSquare = (at - groundSquare.xy) / groundSquare.z;
    if (fade > 0.0 && max(abs(onSquare.x), abs(onSquare.y)) < 1.0) {
      vec2 shares = textureLod(groundLight, onSquare * 0.5 + 0.5, 0.0).rg;
      // Cool where the sun is missing, neutral where the sky is.
      float sunShade = (1.0 - shares.r) * 0.33;
      float skyShade = (1.0 - shares.g) * 0.40;
      float shade = 1.0 - (1.0 - sunShade) * (1.0 - skyShade);
      vec3 tint = mix(vec3(0.24, 0.28, 0.36), vec3(0.22, 0.21, 0.20), skyShade / max(sunShade + skyShade, 1e-4));
      paper = mix(paper, tint, shade * fade);
    }
  }
  color = vec4(paper + dither(), 1.0);
}
