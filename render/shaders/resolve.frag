#version 330 core
uniform sampler2DMS picture;
uniform int scale;
uniform int samples;
out vec4 color;
void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * scale;
  vec3 sum = vec3(0.0);
  for (int j = 0; j < scale; ++j)
    for (int i = 0; i < scale; ++i)
      for (int s = 0; s < samples; ++s) sum += texelFetch(picture, first + ivec2(i, j), s).rgb;
  color = vec4(sum / float(scale * scale * samples), 1.0);
}
