// Adds up the sixteen texels of each scope that visibility.frag gave it.
uniform highp usampler2D parts;
layout(location = 0) out uvec4 counts;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  counts = uvec4(0u);
  for (int i = 0; i < 16; ++i) counts += texelFetch(parts, ivec2(texel.x * 16 + i, texel.y), 0);
}
