in vec2 screenUv;
out vec4 color;

void main() {
  float noise = (fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0;
  color = vec4(mix(backgroundBottom.rgb, backgroundTop.rgb, smoothstep(0.0, 1.0, screenUv.y)) + noise, 1.0);
}
