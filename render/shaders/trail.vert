#version 330 core
layout(location = 0) in vec4 position;
layout(location = 1) in float opacity;
out float strength;
void main() {
  strength = opacity;
  gl_Position = position;
}
