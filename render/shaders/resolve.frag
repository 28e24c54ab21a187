#version 330 core
uniform sampler2DMS picture;
uniform int scale;
uniform int samples;
uniform float opacity;
out vec4 color;
void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * scale;
  vec4 sum = vec4(0.0);
  for (int j = 0; j < scale; ++j)
    for (int i = 0; i < scale; ++i)
      for (int s = 0; s < samples; ++s) sum += texelFetch(picture, first + ivec2(i, j), s);
  color = sum / float(scale * scale * samples) * opacity;
}
