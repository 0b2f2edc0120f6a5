#version 430 compatibility
// One vertex of a model. Matrices are composed in double on the CPU, relative to the camera, so that
// neither world coordinates of 6.4e6 m nor ranges of 1e7 m cost digits here.

uniform mat4 clipFromModel; // model to clip space
uniform mat4 eyeFromModel;  // model to eye space, m, a rotation and a translation; for directions and distances

out vec3 eyePosition; // m, not normalised: directions are taken per fragment
out vec3 eyeNormal;   // any length

void main() {
    gl_Position = clipFromModel * gl_Vertex;
    eyePosition = (eyeFromModel * gl_Vertex).xyz;
    eyeNormal = mat3(eyeFromModel) * gl_Normal;
}
