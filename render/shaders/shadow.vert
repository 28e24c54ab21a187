#version 330 core
// A box on the ground around one piece of the cable, an instance each, in metres.
layout(location = 0) in vec4 ends;
layout(location = 1) in vec3 form;  // radius, blur, strength
uniform vec2 middle;
uniform float reach;
out vec2 place;
flat out vec4 segment;
flat out vec3 light;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  float around = form.x + 2.0 * form.y;
  place = mix(min(ends.xy, ends.zw) - around, max(ends.xy, ends.zw) + around, corner);
  segment = ends;
  light = form;
  gl_Position = vec4((place - middle) / reach, 0.0, 1.0);
}
