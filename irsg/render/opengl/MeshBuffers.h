#pragma once

#include <cstddef>
#include <memory>

#include "irsg/geometry/mesh/Mesh.h"
#include "irsg/render/opengl/GlFunctions.h"

namespace irsg {

/// The arrays of a mesh in OpenGL's memory: vertices, and normals and places on a texture where it
/// has them. Lives on the context's thread.
class MeshBuffers {
  public:
    /// Of a mesh, uploaded where it is new to the process. They live as long as their mesh, until
    /// the next forgetGone().
    static const MeshBuffers& of(const std::shared_ptr<const Mesh>& mesh);
    static void forgetGone();

    explicit MeshBuffers(const Mesh& mesh);
    ~MeshBuffers();
    MeshBuffers(const MeshBuffers&) = delete;
    MeshBuffers& operator=(const MeshBuffers&) = delete;

    /// To be called before draw(), until unbind().
    void bind() const { glBindVertexArray(arrays_); }
    static void unbind() { glBindVertexArray(0); }
    void draw(std::size_t piece) const;

  private:
    struct Range {
        GLsizei corners;
        const void* first; ///< offset of the first index
        GLint vertices;    ///< number of the part's first vertex
    };
    std::vector<Range> pieces_;
    GLuint arrays_ = 0, buffers_[2] = {0, 0}; ///< vertices and what belongs to them; indices
};

} // namespace irsg
