#version 430 compatibility
// One vertex of a terrain.

uniform mat4 clipFromModel; // composed in double on the CPU

out vec2 place; // in the texture

void main() {
    gl_Position = clipFromModel * gl_Vertex;
    place = gl_MultiTexCoord0.xy;
}
