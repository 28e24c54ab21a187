#version 330 core
// The rectangle of a text's bitmap: left, top, width, height in pixels, y downwards.
uniform vec4 box;
uniform vec2 size;
out vec2 texel;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  texel = corner * box.zw;
  gl_Position = vec4((box.xy + texel) / size * vec2(2.0, -2.0) + vec2(-1.0, 1.0), 0.0, 1.0);
}
