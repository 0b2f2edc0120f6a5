#version 430 compatibility
// One sample of a terrain: what its texel lies above the offset, that it is there, and how near.

in vec2 place;
in vec3 fromEye_m;

uniform sampler2D texels;     // linear numbers
uniform vec3 weightAndOffset; // x: 1, or 0 without a texture; y: offset

layout(location = 0) out vec2 plane0;  // texel - offset, coverage
layout(location = 1) out float plane1; // 1 / distance, m-1

void main() {
    plane0 = vec2(weightAndOffset.x * (texture(texels, place).r - weightAndOffset.y), 1.0);
    plane1 = 1.0 / max(length(fromEye_m), 1e-6);
}
