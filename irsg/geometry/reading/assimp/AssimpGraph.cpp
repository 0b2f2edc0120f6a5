#include "irsg/geometry/reading/assimp/AssimpGraph.h"

#include <cmath>

#include <osg/Geometry>
#include <osg/MatrixTransform>

#include "irsg/core/Errors.h"
#include "irsg/geometry/reading/Triangulation.h"
#include "irsg/geometry/reading/sandbox/GraphExtent.h"

namespace irsg {

namespace {

osg::Vec3 vec3(const aiVector3D& v) {
    return {v.x, v.y, v.z};
}

/// For row vectors.
osg::Matrixd matrixOf(const aiMatrix4x4& m) {
    return {m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2,
            m.a3, m.b3, m.c3, m.d3, m.a4, m.b4, m.c4, m.d4};
}

/// Assimp cuts the transformation of an .fbx node into several nodes, whose names are its own.
std::string nameOf(const aiNode& node) {
    const std::string name = node.mName.C_Str();
    return name.find("_$AssimpFbx$_") == name.npos ? name : "";
}

osg::ref_ptr<osg::Vec3Array> arrayOf(const aiVector3D* values, unsigned int count) {
    osg::ref_ptr<osg::Vec3Array> array = new osg::Vec3Array(osg::Array::BIND_PER_VERTEX, count);
    for (unsigned int i = 0; i < count; ++i)
        (*array)[i] = vec3(values[i]);
    return array;
}

} // namespace

osg::ref_ptr<osg::Group> AssimpGraph::make() {
    return make(*scene_.mRootNode, 0);
}

osg::ref_ptr<osg::Group> AssimpGraph::make(const aiNode& node, int level) {
    if (level > mostLevels)
        throw InputError({file_, "",
                          "a graph of more than " + std::to_string(mostLevels) + " levels",
                          "a model in fewer levels"});
    const auto better = transforms_.find(&node);
    const osg::Matrixd matrix =
        better == transforms_.end() ? matrixOf(node.mTransformation) : better->second;
    for (int i = 0; i < 16; ++i)
        if (!std::isfinite(matrix.ptr()[i]))
            throw InputError({file_, "node '" + nameOf(node) + "'",
                              "a transformation with a number that is none", "finite numbers"});
    osg::ref_ptr<osg::Group> group =
        matrix.isIdentity() ? new osg::Group : new osg::MatrixTransform(matrix);
    group->setName(nameOf(node));
    for (unsigned int i = 0; i < node.mNumMeshes; ++i)
        group->addChild(&geode(node.mMeshes[i]));
    for (unsigned int i = 0; i < node.mNumChildren; ++i)
        group->addChild(make(*node.mChildren[i], level + 1));
    return group;
}

osg::Geode& AssimpGraph::geode(unsigned int mesh) {
    if (mesh >= scene_.mNumMeshes)
        throw InputError({file_, "", "mesh " + std::to_string(mesh),
                          "a number below " + std::to_string(scene_.mNumMeshes)});
    auto& known = geodes_[mesh];
    if (!known.geode) {
        known.geode = new osg::Geode;
        known.geode->setName(scene_.mMeshes[mesh]->mName.C_Str());
        known.geode->addDrawable(geometry(*scene_.mMeshes[mesh], known.polygons));
    }
    placed_ += known.polygons;
    return *known.geode;
}

osg::ref_ptr<osg::Geometry> AssimpGraph::geometry(const aiMesh& mesh, double& polygons) {
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setUseVertexBufferObjects(true);
    geometry->setVertexArray(arrayOf(mesh.mVertices, mesh.mNumVertices));
    if (mesh.mNormals)
        geometry->setNormalArray(arrayOf(mesh.mNormals, mesh.mNumVertices));
    osg::ref_ptr<osg::Vec4Array> colours;
    if (const aiColor4D* given = mesh.mColors[0]) {
        colours = new osg::Vec4Array(osg::Array::BIND_PER_VERTEX);
        for (unsigned int i = 0; i < mesh.mNumVertices; ++i)
            colours->push_back({given[i].r, given[i].g, given[i].b, given[i].a});
    } else {
        colours = new osg::Vec4Array(osg::Array::BIND_OVERALL, 1);
        colours->front() = osg::Vec4(1, 1, 1, 1);
    }
    geometry->setColorArray(colours);
    const unsigned int set = states_.placesOf(mesh.mMaterialIndex);
    if (const aiVector3D* given =
            set < AI_MAX_NUMBER_OF_TEXTURECOORDS ? mesh.mTextureCoords[set] : nullptr) {
        osg::ref_ptr<osg::Vec2Array> places = new osg::Vec2Array(osg::Array::BIND_PER_VERTEX);
        for (unsigned int i = 0; i < mesh.mNumVertices; ++i)
            places->push_back({given[i].x, given[i].y});
        geometry->setTexCoordArray(0, places);
    }
    geometry->setStateSet(states_.state(mesh.mMaterialIndex));

    std::vector<unsigned int> triangles, quads;
    std::vector<PolygonCorner> corners;
    for (unsigned int i = 0; i < mesh.mNumFaces; ++i) {
        const aiFace& face = mesh.mFaces[i];
        corners.clear();
        for (unsigned int j = 0; j < face.mNumIndices; ++j) {
            const unsigned int index = face.mIndices[j];
            if (index >= mesh.mNumVertices)
                throw InputError(
                    {file_, "mesh '" + std::string(mesh.mName.C_Str()) + "'",
                     "a face with vertex " + std::to_string(index),
                     "indices below the number of vertices, " + std::to_string(mesh.mNumVertices)});
            corners.emplace_back().position = osg::Vec3d(vec3(mesh.mVertices[index]));
        }
        corners_ += face.mNumIndices;
        if (face.mNumIndices < 3) {
            ++thin_;
            continue;
        }
        ++polygons;
        const auto add = [&](std::vector<unsigned int>& to) {
            to.insert(to.end(), face.mIndices, face.mIndices + face.mNumIndices);
        };
        if (face.mNumIndices == 3) {
            add(triangles);
            continue;
        }
        const auto cut = triangulate(corners);
        if (face.mNumIndices == 4 && cut.convex) {
            add(quads);
            continue;
        }
        empty_ += cut.triangles.empty();
        folded_ += cut.folded;
        for (const auto& triangle : cut.triangles)
            for (const auto corner : triangle)
                triangles.push_back(face.mIndices[corner]);
    }
    if (!triangles.empty())
        geometry->addPrimitiveSet(
            new osg::DrawElementsUInt(GL_TRIANGLES, triangles.begin(), triangles.end()));
    if (!quads.empty())
        geometry->addPrimitiveSet(new osg::DrawElementsUInt(GL_QUADS, quads.begin(), quads.end()));
    return geometry;
}

std::vector<std::string> AssimpGraph::remarks() const {
    std::vector<std::string> remarks;
    const auto say = [&](long count, const std::string& text) {
        if (count > 0)
            remarks.push_back(std::to_string(count) + " " + text);
    };
    say(thin_, "lines and points have no area and are left out");
    say(empty_, "polygons without area are left out");
    say(folded_, "polygons cross themselves");
    return remarks;
}

} // namespace irsg
