in vec2 screenUv;
out vec4 color;

void main() { color = vec4(mix(backgroundBottom.rgb, backgroundTop.rgb, smoothstep(0.0, 1.0, screenUv.y)) + dither(), 1.0); }
