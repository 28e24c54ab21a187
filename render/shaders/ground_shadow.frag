#version 330 core
uniform vec2 middle;
uniform float radius;  // half the side of the square that the map covers
uniform sampler2D shadow_map;
in vec2 place;
out vec4 color;
void main() {
  vec2 texel = (place - middle) / radius * 0.5 + 0.5;
  color = vec4(0.24, 0.28, 0.34, 0.5 * texture(shadow_map, texel).r);
}
