#version 330 compatibility
// Lays one premultiplied plane under what has been gathered so far; the blend function does the rest:
// gathered += (1 - gathered alpha) * layer.

uniform sampler2D layer; // (A_pre, 0, 0, alpha), W m-2 sr-1 and 0..1

layout(location = 0) out vec4 plane0;

void main() {
    plane0 = texelFetch(layer, ivec2(gl_FragCoord.xy), 0);
}
