#version 430 compatibility
// One sample of a terrain: what its texel lies above the offset, and that it is there.

in vec2 place;

uniform sampler2D texels;     // linear numbers
uniform vec3 weightAndOffset; // x: 1, or 0 without a texture; y: offset

layout(location = 0) out vec2 plane0; // texel - offset, coverage

void main() {
    plane0 = vec2(weightAndOffset.x * (texture(texels, place).r - weightAndOffset.y), 1.0);
}
