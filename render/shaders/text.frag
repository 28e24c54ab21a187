#version 330 core
uniform sampler2D glyphs;
uniform int solid;  // 1: the whole rectangle; 2: the texture's own colours
uniform vec4 ink;
in vec2 texel;
out vec4 color;
void main() {
  if (solid == 2) {
    color = texelFetch(glyphs, ivec2(texel), 0);
    return;
  }
  float coverage = solid == 1 ? 1.0 : texelFetch(glyphs, ivec2(texel), 0).r;
  color = vec4(ink.rgb, ink.a * coverage);
}
