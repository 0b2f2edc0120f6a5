#include "irsg/render/opengl/FragmentList.h"

#include <string>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

constexpr GLuint counterBinding = 0, fragmentsBinding = 1; // as in surface.frag.glsl
constexpr GLsizeiptr bytesPerVector = 16;

GLsizeiptr bytesFor(std::uint32_t entries, int vectorsPerEntry) {
    return static_cast<GLsizeiptr>(entries) * vectorsPerEntry * bytesPerVector;
}

} // namespace

FragmentList::~FragmentList() {
    if (counter_) {
        glDeleteBuffers(1, &counter_);
        glDeleteBuffers(1, &fragments_);
    }
}

void FragmentList::begin(std::uint32_t entries, int vectorsPerEntry) {
    if (!counter_) {
        glGenBuffers(1, &counter_);
        glGenBuffers(1, &fragments_);
    }
    const GLuint zero = 0;
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, counter_);
    glBufferData(GL_SHADER_STORAGE_BUFFER, sizeof zero, &zero, GL_DYNAMIC_READ);
    const GLsizeiptr needed = bytesFor(entries, vectorsPerEntry);
    if (needed > bytes_) {
        glBindBuffer(GL_SHADER_STORAGE_BUFFER, fragments_);
        glBufferData(GL_SHADER_STORAGE_BUFFER, needed, nullptr, GL_DYNAMIC_READ);
        bytes_ = needed;
    }
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, counterBinding, counter_);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, fragmentsBinding, fragments_);
}

std::uint32_t FragmentList::count() const {
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    GLuint count = 0;
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, counter_);
    glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof count, &count);
    return count;
}

void FragmentList::read(std::uint32_t entries, int vectorsPerEntry,
                        const std::function<void(std::span<const float>)>& take) const {
    if (entries == 0)
        return take({});
    const GLsizeiptr bytes = bytesFor(entries, vectorsPerEntry);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, fragments_);
    const void* mapped = glMapBufferRange(GL_SHADER_STORAGE_BUFFER, 0, bytes, GL_MAP_READ_BIT);
    if (!mapped)
        throw InputError(Diagnostic{"OpenGL", "list of fragments", std::to_string(bytes) + " bytes",
                                    "a driver that lets a storage buffer be read"});
    try {
        take({static_cast<const float*>(mapped), static_cast<std::size_t>(bytes) / sizeof(float)});
    } catch (...) {
        glUnmapBuffer(GL_SHADER_STORAGE_BUFFER);
        throw;
    }
    glUnmapBuffer(GL_SHADER_STORAGE_BUFFER);
}

} // namespace irsg
