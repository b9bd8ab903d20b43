// From radiance to the screen.

// A soft shoulder above middle tones, and a little less colour than film would give: drawings are quiet, and handles must stand out.
vec3 toneMap(vec3 color) {
  color = mix(vec3(dot(color, vec3(0.2126, 0.7152, 0.0722))), color, 0.86);
  const float start = 0.70;
  vec3 over = max(color - start, vec3(0.0));
  return min(color, vec3(start)) + (1.0 - start) * (vec3(1.0) - exp(-over / (1.0 - start)));
}

vec3 toSrgb(vec3 linear) {
  return mix(linear * 12.92, 1.055 * pow(max(linear, vec3(0.0)), vec3(1.0 / 2.4)) - 0.055, step(vec3(0.0031308), linear));
}

// Half a step of the 8-bit screen up or down, in a fine fixed pattern, so that gradients show no bands.
float dither() { return (fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0; }
