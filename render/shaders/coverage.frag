#version 330 core
// Colours what a one-channel mask of the picture's size covers.
uniform sampler2D mask;
uniform vec4 ink;
out vec4 color;
void main() { color = vec4(ink.rgb, ink.a * texelFetch(mask, ivec2(gl_FragCoord.xy), 0).r); }
