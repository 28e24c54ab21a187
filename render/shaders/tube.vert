#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 view;
out vec3 place;
out vec3 outward;
void main() {
  place = position;
  outward = normal;
  gl_Position = view * vec4(position, 1.0);
}
