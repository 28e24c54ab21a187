#version 330 core
uniform vec2 middle;
uniform float radius;  // half the side of the square that the map covers
uniform sampler2D shadow_map;
uniform vec4 ink;
in vec2 place;
out vec4 color;
void main() {
  vec2 texel = (place - middle) / radius * 0.5 + 0.5;
  color = vec4(ink.rgb, ink.a * texture(shadow_map, texel).r);
}
