#version 330 core
// Grid lines that fade out with distance and have a constant width in the picture. Nothing between them: the picture's
// background is the ground's colour.
uniform vec2 middle;
uniform float radius;
uniform float grid;
uniform float line_width;
uniform vec4 ink;
in vec2 place;
out vec4 color;
// Coverage of lines at whole numbers; where they come closer than some widths, their mean.
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
  float opacity = ink.a * fade * max(0.35 * lines(place / grid), lines(place / (5.0 * grid)));
  color = vec4(ink.rgb * opacity, opacity);
}
