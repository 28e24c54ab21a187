#version 330 core
// Light above, a shade darker where the ground is. The darker part is even, so that the grid's pixels repeat and the
// PNG stays small.
uniform float height;
out vec4 color;
void main() {
  float up = gl_FragCoord.y / height;
  color = vec4(mix(vec3(0.925, 0.937, 0.953), vec3(0.984, 0.988, 0.992), smoothstep(0.45, 0.95, up)), 1.0);
}
