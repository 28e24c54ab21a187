#version 330 core
// Coverage from the distance to the shape's edge: exact enough for edges that are straight on the scale of a pixel.
in vec2 position;
flat in vec4 segment;
flat in vec3 form;
out float coverage;
float distance_to_segment(vec2 p) {
  vec2 along = segment.zw - segment.xy;
  float length_squared = dot(along, along);
  float t = length_squared > 0.0 ? clamp(dot(p - segment.xy, along) / length_squared, 0.0, 1.0) : 0.0;
  return length(p - segment.xy - t * along);
}
float distance_to_box(vec2 p, float half_side) {
  vec2 d = abs(p) - half_side;
  return length(max(d, 0.0)) + min(max(d.x, d.y), 0.0);
}
// Equilateral, with its tip at the top and its middle at the origin; outside the corners, to the nearest side's line.
float distance_to_triangle(vec2 p, float inner_radius) {
  return max(p.y, 0.8660254 * abs(p.x) - 0.5 * p.y) - inner_radius;
}
void main() {
  float d;
  if (form.z < 0.5)
    d = distance_to_segment(position) - form.x;
  else if (form.z < 1.5)
    d = distance_to_box(position - segment.xy, form.x * 0.886);
  else if (form.z < 2.5)
    d = distance_to_box(mat2(0.70710678, 0.70710678, -0.70710678, 0.70710678) * (position - segment.xy), form.x * 0.886);
  else {
    vec2 p = position - segment.xy;
    d = distance_to_triangle(form.z < 3.5 ? p : form.z < 4.5 ? vec2(p.x, -p.y) : vec2(p.y, -p.x), form.x * 0.7);
  }
  if (form.y > 0.0) d = abs(d) - form.y;
  coverage = clamp(0.5 - d, 0.0, 1.0);
}
