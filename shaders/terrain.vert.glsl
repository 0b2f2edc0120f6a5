#version 430 compatibility
// One vertex of a terrain.

uniform mat4 clipFromModel; // composed in double on the CPU
uniform mat4 eyeFromModel;  // m

out vec2 place;     // in the texture
out vec3 fromEye_m; // in the axes of the eye

void main() {
    gl_Position = clipFromModel * gl_Vertex;
    place = gl_MultiTexCoord0.xy;
    fromEye_m = (eyeFromModel * gl_Vertex).xyz;
}
