#version 330 core
// A box around one shape, an instance each; lengths in pixels, y downwards.
layout(location = 0) in vec4 ends;     // two points
layout(location = 1) in vec3 outline;  // half width, half stroke (0: filled), kind
uniform vec2 size;
uniform vec2 corner_of_canvas;
out vec2 position;
flat out vec4 segment;
flat out vec3 form;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  float reach = outline.x * 1.5 + outline.y + 1.0;
  position = mix(min(ends.xy, ends.zw) - reach, max(ends.xy, ends.zw) + reach, corner);
  segment = ends;
  form = outline;
  gl_Position = vec4((position - corner_of_canvas) / size * vec2(2.0, -2.0) + vec2(-1.0, 1.0), 0.0, 1.0);
}
