#version 330 compatibility
// A triangle that covers the viewport; positions come in clip space.

void main() {
    gl_Position = gl_Vertex;
}
