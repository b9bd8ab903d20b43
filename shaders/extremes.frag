// One step of the reduction of a mask to the first covered pixel, and the one after the last, of each row (axis 1,0) or column (axis 0,1).
// Eight texels become one. Nothing covered: 65535 and 0, which min and max pass over.
uniform ivec2 axis;
#ifdef FIRST_STEP
uniform highp sampler2D mask;
#else
uniform highp usampler2D extremes;
#endif
layout(location = 0) out uvec2 range;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  ivec2 start = texel * (ivec2(1) + 7 * axis);
#ifdef FIRST_STEP
  ivec2 size = textureSize(mask, 0);
#else
  ivec2 size = textureSize(extremes, 0);
#endif
  int left = min(8, axis.x * (size.x - start.x) + axis.y * (size.y - start.y));
  uvec2 found = uvec2(65535u, 0u);
  for (int i = 0; i < left; ++i) {
    ivec2 at = start + i * axis;
#ifdef FIRST_STEP
    if (texelFetch(mask, at, 0).r > 0.5) {
      uint along = uint(axis.x * at.x + axis.y * at.y);
      found = uvec2(min(found.x, along), along + 1u);
    }
#else
    uvec2 other = texelFetch(extremes, at, 0).rg;
    found = uvec2(min(found.x, other.x), max(found.y, other.y));
#endif
  }
  range = found;
}
