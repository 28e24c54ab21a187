#version 330 core
// The square around the ground's disc; places in it in metres from the ground's origin.
uniform mat4 view;
uniform vec3 origin;
uniform vec3 across;
uniform vec3 forward;
uniform vec2 middle;
uniform float radius;
uniform vec4 tile;  // of the picture that is drawn: scale and shift
out vec2 place;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  place = middle + radius * corner;
  gl_Position = view * vec4(origin + place.x * across + place.y * forward, 1.0);
  gl_Position.xy = gl_Position.xy * tile.xy + gl_Position.w * tile.zw;
}
