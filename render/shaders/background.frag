#version 330 core
uniform float height;
out vec4 color;
void main() {
  float up = gl_FragCoord.y / height;
  color = vec4(mix(vec3(0.902, 0.918, 0.937), vec3(0.984, 0.988, 0.992), smoothstep(0.0, 1.0, up)), 1.0);
}
