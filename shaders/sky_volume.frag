// How much sky a point of the grid sees, and from where: spherical harmonics of its visibility, up to the first order.
uniform vec3 firstPoint;   // of this slice
uniform float spacing;
out vec4 coefficients;

void main() {
  vec3 world = firstPoint + vec3((gl_FragCoord.xy - 0.5) * spacing, 0.0);
  float open = 0.0;
  vec3 towards = vec3(0.0);
  for (int i = 0; i < mapCount.x; ++i) {
    float seen = seesSky(i, world, 0.002);
    open += seen;
    towards += seen * mapDirection[i].xyz;
  }
  // The constant coefficient is open / 2n, the others are 3 towards / 2n; stored so that each fills its byte.
  float n = float(mapCount.x);
  coefficients = vec4(0.5 + towards / n, open / n);
}
