// What every shader of the picture knows of the frame: FrameBlock in src/render/frame_block.h says what each member is.
layout(std140) uniform Frame {
  mat4 worldToClip;
  mat4 worldToShadow;
  mat4 clipToWorld;
  vec4 eye;
  vec4 sun;
  vec4 viewport;
  vec4 ground;
  vec4 groundFade;
  vec4 groundAcross;
  vec4 groundSquare;
  vec4 skyOrigin;
  vec4 skyScale;
  vec4 backgroundTop;
  vec4 backgroundBottom;
  ivec4 detail;
  vec4 shadowDisc[9];
};

// Unit direction from a point to the viewer.
vec3 towardsViewer(vec3 world) { return normalize(eye.xyz - world * eye.w); }
