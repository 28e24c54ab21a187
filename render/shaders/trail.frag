#version 330 core
uniform vec4 ink;
in float strength;
out vec4 color;
void main() { color = vec4(ink.rgb, 1.0) * (ink.a * strength); }
