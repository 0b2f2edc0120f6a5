#include "tests/support/HeldByContext.h"

#include "irsg/render/opengl/GlFunctions.h"
#include "irsg/render/opengl/MeshBuffers.h"
#include "irsg/render/opengl/OffscreenContext.h"

namespace irsg::test {

namespace {

/// Names are given in ascending order: those up to the next one are all there ever were.
template <typename Generate, typename Delete, typename Is>
int alive(Generate generate, Delete remove, Is is) {
    GLuint next = 0;
    generate(1, &next);
    remove(1, &next);
    int count = 0;
    for (GLuint name = 1; name < next; ++name) {
        count += is(name);
    }
    return count;
}

} // namespace

HeldByContext heldByContext() {
    HeldByContext held;
    OffscreenContext::shared().run([&] {
        MeshBuffers::forgetGone();
        held.textures = alive(glGenTextures, glDeleteTextures, glIsTexture);
        held.buffers = alive(glGenBuffers, glDeleteBuffers, glIsBuffer);
        held.framebuffers = alive(glGenFramebuffers, glDeleteFramebuffers, glIsFramebuffer);
        held.vertexArrays = alive(glGenVertexArrays, glDeleteVertexArrays, glIsVertexArray);
    });
    return held;
}

} // namespace irsg::test
