in vec3 world;
out vec4 premultiplied;

void main() {
  float distanceShare = length(world.xz - ground.xy) / ground.w;
  float fade = groundFade.x * (1.0 - smoothstep(0.25, 1.0, distanceShare));
  float shade = (1.0 - sunVisibility(world, vec3(0.0, 1.0, 0.0))) * 0.36;
  premultiplied = vec4(vec3(0.20, 0.23, 0.28) * shade, shade) * fade;
}
