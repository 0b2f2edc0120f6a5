#include "tests/support/HeldByContext.h"

#include <osg/GLExtensions>
#include <osg/GLObjects>
#include <osg/GraphicsContext>
#include <osg/RenderInfo>

#include "irsg/core/Errors.h"
#include "irsg/render/opengl/OffscreenContext.h"

namespace irsg::test {

HeldByContext heldByContext() {
    HeldByContext held;
    OffscreenContext::shared().run([&](osg::RenderInfo& info) {
        osg::flushAllDeletedGLObjects(info.getContextID());
        auto* gl = info.getState()->get<osg::GLExtensions>();
        // Names are given in ascending order: those up to the next one are all there ever were.
        GLuint next = 0;
        glGenTextures(1, &next);
        glDeleteTextures(1, &next);
        for (GLuint name = 1; name < next; ++name) {
            held.textures += glIsTexture(name);
        }
        gl->glGenBuffers(1, &next);
        gl->glDeleteBuffers(1, &next);
        for (GLuint name = 1; name < next; ++name) {
            held.buffers += gl->glIsBuffer(name);
        }
        GLboolean(GL_APIENTRY * isFramebuffer)(GLuint) = nullptr;
        if (!osg::setGLExtensionFuncPtr(isFramebuffer, "glIsFramebuffer")) {
            throw LogicError("no glIsFramebuffer");
        }
        gl->glGenFramebuffers(1, &next);
        gl->glDeleteFramebuffers(1, &next);
        for (GLuint name = 1; name < next; ++name) {
            held.framebuffers += isFramebuffer(name);
        }
        held.contexts =
            static_cast<int>(osg::GraphicsContext::getAllRegisteredGraphicsContexts().size());
    });
    return held;
}

} // namespace irsg::test
