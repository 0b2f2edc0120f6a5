#include "irsg/render/opengl/FloatTarget.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

void allocate(GLuint texture, GLint internalFormat, GLenum format, int width, int height) {
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, internalFormat, width, height, 0, format, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

struct PlaneFormat {
    GLint internal;
    GLenum format;
};

PlaneFormat formatOf(int channels) {
    switch (channels) {
    case 1:
        return {GL_R32F, GL_RED};
    case 2:
        return {GL_RG32F, GL_RG};
    case 4:
        return {GL_RGBA32F, GL_RGBA};
    }
    throw LogicError("a plane of a float target has 1, 2 or 4 channels");
}

} // namespace

FloatTarget::FloatTarget(std::vector<int> channels)
    : channels_(std::move(channels)), colour_(channels_.size(), 0) {}

FloatTarget::~FloatTarget() {
    release();
}

void FloatTarget::release() {
    if (!framebuffer_)
        return;
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteTextures(1, &depth_);
    glDeleteTextures(static_cast<GLsizei>(colour_.size()), colour_.data());
    framebuffer_ = 0;
    width_ = height_ = 0;
}

void FloatTarget::reserve(int width, int height) {
    if (width <= width_ && height <= height_)
        return;
    const int newWidth = std::max(width, width_);
    const int newHeight = std::max(height, height_);
    release();

    glGenFramebuffers(1, &framebuffer_);
    glGenTextures(1, &depth_);
    glGenTextures(static_cast<GLsizei>(colour_.size()), colour_.data());
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    std::vector<GLenum> buffers;
    for (GLuint texture : colour_) {
        const GLenum attachment = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size());
        const PlaneFormat plane = formatOf(channels_[buffers.size()]);
        allocate(texture, plane.internal, plane.format, newWidth, newHeight);
        glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture, 0);
        buffers.push_back(attachment);
    }
    allocate(depth_, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, newWidth, newHeight);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_, 0);
    glDrawBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());

    width_ = newWidth;
    height_ = newHeight;
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw InputError(
            Diagnostic{"OpenGL", "float render target",
                       std::to_string(newWidth) + " x " + std::to_string(newHeight),
                       "a driver that renders into float planes with 32-bit float depth"});
}

std::size_t FloatTarget::bytes() const {
    constexpr int depthChannels = 1;
    const auto perSample = static_cast<std::size_t>(
        std::accumulate(channels_.begin(), channels_.end(), depthChannels));
    return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * perSample *
           sizeof(float);
}

void FloatTarget::bind(int width, int height) const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, width, height);
}

void FloatTarget::clear() const {
    glDepthMask(GL_TRUE);
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClearDepth(0.0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void FloatTarget::read(int plane, int width, int height, std::vector<float>& into) const {
    const int channels = channels_[static_cast<std::size_t>(plane)];
    into.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                static_cast<std::size_t>(channels));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    glReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(plane));
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width, height, formatOf(channels).format, GL_FLOAT, into.data());
}

} // namespace irsg
