#version 330 core
uniform sampler2D glyphs;
uniform int solid;  // 1: the whole rectangle
uniform vec4 ink;
in vec2 texel;
out vec4 color;
void main() {
  float coverage = solid == 1 ? 1.0 : texelFetch(glyphs, ivec2(texel), 0).r;
  color = vec4(ink.rgb, ink.a * coverage);
}
