#version 430 compatibility
// One sample of what only hides: its depth is all that is kept.

void main() {
}
