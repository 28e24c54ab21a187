#version 330 core
// A disc that fades out, with grid lines of constant width in the picture and the shadow.
uniform vec2 middle;
uniform float radius;
uniform float grid;
uniform float line_width;
uniform float shadow_reach;
uniform sampler2D shadow_map;
in vec2 place;
out vec4 color;
// Coverage of lines at whole numbers; where they come closer than two widths, their mean.
float lines(vec2 at) {
  vec2 step_per_pixel = max(fwidth(at), 1e-9);
  vec2 from_line = abs(fract(at - 0.5) - 0.5) / step_per_pixel;
  vec2 covered = clamp(0.5 * line_width + 0.5 - from_line, 0.0, 1.0);
  vec2 density = clamp(line_width * step_per_pixel, 0.0, 1.0);
  covered = mix(covered, density, smoothstep(0.25, 0.5, density));
  return max(covered.x, covered.y);
}
void main() {
  float fade = 1.0 - smoothstep(0.35, 1.0, distance(place, middle) / radius);
  float line = max(0.35 * lines(place / grid), lines(place / (5.0 * grid)));
  vec2 texel = (place - middle) / shadow_reach * 0.5 + 0.5;
  float inside = all(lessThan(abs(texel - 0.5), vec2(0.5))) ? 1.0 : 0.0;
  float shadow = inside * texture(shadow_map, texel).r;
  vec3 tone = mix(vec3(0.975, 0.980, 0.985), vec3(0.70, 0.735, 0.78), 0.6 * line);
  tone = mix(tone, vec3(0.24, 0.28, 0.34), 0.5 * shadow);
  color = vec4(tone, max(fade, 0.5 * shadow));
}
