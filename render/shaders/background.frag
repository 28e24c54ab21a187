#version 330 core
// Light above, a shade darker where the ground is. The darker part is even, so that the grid's pixels repeat and the
// PNG stays small.
uniform float height;  // of the picture, and how much of it is below what is drawn
uniform float bottom;
uniform vec4 above;
uniform vec4 below;
out vec4 color;
void main() {
  float up = (gl_FragCoord.y + bottom) / height;
  color = vec4(mix(below.rgb, above.rgb, smoothstep(0.45, 0.95, up)), 1.0);
}
