#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float value;
uniform mat4 view;
uniform vec4 tile;  // of the picture that is drawn: scale and shift
out vec3 place;
out vec3 outward;
out float level;
void main() {
  place = position;
  outward = normal;
  level = value;
  gl_Position = view * vec4(position, 1.0);
  gl_Position.xy = gl_Position.xy * tile.xy + gl_Position.w * tile.zw;
}
