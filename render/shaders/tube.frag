#version 330 core
// A broad light from above the camera's shoulder, one at the eye, sky and ground, and a soft highlight.
uniform vec4 color;
uniform int colored;  // 1: by the level, with the colours of a map of 256
uniform sampler2D map;
uniform vec4 eye;     // of parallel rays the way to it, with 0 as the last
uniform vec3 up;
uniform vec3 light;
in vec3 place;
in vec3 outward;
in float level;
out vec4 shaded;
void main() {
  vec3 n = normalize(outward);
  vec3 to_eye = normalize(eye.xyz - eye.w * place);
  float sky = 0.5 + 0.5 * dot(n, up);
  // Wraps around, and the eye lights too, so that a cable along the light's direction is not black.
  float lit = pow(0.5 + 0.5 * dot(n, light), 1.6);
  float facing = sqrt(max(dot(n, to_eye), 0.0));
  float glint = pow(max(dot(n, normalize(light + to_eye)), 0.0), 40.0);
  vec3 own = colored == 1 ? texture(map, vec2((255.0 * level + 0.5) / 256.0, 0.5)).rgb : color.rgb;
  vec3 tone = own * (mix(0.22, 0.34, sky) + 0.52 * lit + 0.36 * facing) + vec3(0.24) * glint;
  shaded = vec4(tone, 1.0);
}
