#include "irsg/render/opengl/MeshBuffers.h"

#include <map>

namespace irsg {

namespace {

struct Known {
    std::weak_ptr<const Mesh> mesh;
    std::unique_ptr<MeshBuffers> buffers;
};

/// Of all renderers of the process, which share one context.
std::map<const Mesh*, Known>& knownMeshes() {
    // Never destroyed: the context lives until the process ends.
    static auto* const known = new std::map<const Mesh*, Known>;
    return *known;
}

template <typename Element>
GLsizeiptr bytesOf(const std::vector<Element>& array) {
    return static_cast<GLsizeiptr>(array.size() * sizeof(Element));
}

/// Arrays of one kind, part after part, in the buffer that is bound to a target.
class Filling {
  public:
    Filling(GLenum target, GLsizeiptr offset) : target_(target), offset_(offset) {}
    template <typename Element>
    void add(const std::vector<Element>& array) {
        glBufferSubData(target_, offset_, bytesOf(array), array.data());
        offset_ += bytesOf(array);
    }

  private:
    GLenum target_;
    GLsizeiptr offset_;
};

const void* at(GLsizeiptr offset) {
    return reinterpret_cast<const void*>(offset);
}

} // namespace

const MeshBuffers& MeshBuffers::of(const std::shared_ptr<const Mesh>& mesh) {
    Known& known = knownMeshes()[mesh.get()];
    // Another mesh may lie where one did that is gone.
    if (known.mesh.expired()) {
        known.buffers = std::make_unique<MeshBuffers>(*mesh);
        known.mesh = mesh;
    }
    return *known.buffers;
}

void MeshBuffers::forgetGone() {
    std::erase_if(knownMeshes(), [](const auto& known) { return known.second.mesh.expired(); });
}

MeshBuffers::MeshBuffers(const Mesh& mesh) {
    GLsizeiptr vertices = 0, normals = 0, places = 0, indices = 0;
    std::vector<GLint> firstVertex;
    std::vector<GLsizeiptr> firstIndex;
    for (const Mesh::Part& part : mesh.parts) {
        firstVertex.push_back(static_cast<GLint>(vertices / GLsizeiptr{sizeof(Float3)}));
        firstIndex.push_back(indices);
        vertices += bytesOf(part.vertices);
        normals += bytesOf(part.normals);
        places += bytesOf(part.texturePlaces);
        indices += bytesOf(part.triangles);
    }
    for (const Mesh::Piece& piece : mesh.pieces)
        pieces_.push_back(
            {static_cast<GLsizei>(piece.count),
             at(firstIndex[piece.part] + static_cast<GLsizeiptr>(piece.first * sizeof(unsigned))),
             firstVertex[piece.part]});

    glGenVertexArrays(1, &arrays_);
    glGenBuffers(2, buffers_);
    glBindVertexArray(arrays_);
    glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
    glBufferData(GL_ARRAY_BUFFER, vertices + normals + places, nullptr, GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, indices, nullptr, GL_STATIC_DRAW);
    Filling toVertices(GL_ARRAY_BUFFER, 0), toNormals(GL_ARRAY_BUFFER, vertices),
        toPlaces(GL_ARRAY_BUFFER, vertices + normals), toIndices(GL_ELEMENT_ARRAY_BUFFER, 0);
    for (const Mesh::Part& part : mesh.parts) {
        toVertices.add(part.vertices);
        toNormals.add(part.normals);
        toPlaces.add(part.texturePlaces);
        toIndices.add(part.triangles);
    }
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, at(0));
    if (normals > 0) {
        glEnableClientState(GL_NORMAL_ARRAY);
        glNormalPointer(GL_FLOAT, 0, at(vertices));
    }
    if (places > 0) {
        glClientActiveTexture(GL_TEXTURE0);
        glEnableClientState(GL_TEXTURE_COORD_ARRAY);
        glTexCoordPointer(2, GL_FLOAT, 0, at(vertices + normals));
    }
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

MeshBuffers::~MeshBuffers() {
    glDeleteVertexArrays(1, &arrays_);
    glDeleteBuffers(2, buffers_);
}

void MeshBuffers::draw(std::size_t piece) const {
    const Range& range = pieces_[piece];
    glDrawElementsBaseVertex(GL_TRIANGLES, range.corners, GL_UNSIGNED_INT, range.first,
                             range.vertices);
}

} // namespace irsg
