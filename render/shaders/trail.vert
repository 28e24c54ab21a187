#version 330 core
layout(location = 0) in vec4 position;
layout(location = 1) in float opacity;
uniform vec4 tile;  // of the picture that is drawn: scale and shift
out float strength;
void main() {
  strength = opacity;
  gl_Position = position;
  gl_Position.xy = gl_Position.xy * tile.xy + gl_Position.w * tile.zw;
}
