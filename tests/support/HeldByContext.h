#pragma once

namespace irsg::test {

/// Objects alive in the context that all generators share.
struct HeldByContext {
    int textures = 0, buffers = 0, framebuffers = 0, vertexArrays = 0;
};

/// Now, after what was given back is deleted.
HeldByContext heldByContext();

} // namespace irsg::test
