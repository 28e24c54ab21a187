#version 330 core
in vec2 place;
flat in vec4 segment;
flat in vec3 light;
out float shadow;
void main() {
  vec2 along = segment.zw - segment.xy;
  float length_squared = dot(along, along);
  float t = length_squared > 0.0 ? clamp(dot(place - segment.xy, along) / length_squared, 0.0, 1.0) : 0.0;
  float beyond = max(length(place - segment.xy - t * along) - 0.5 * light.x, 0.0) / light.y;
  shadow = light.z * exp(-1.6 * beyond * beyond);
}
