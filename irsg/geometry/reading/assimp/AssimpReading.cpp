#include "irsg/geometry/reading/assimp/AssimpReading.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>
#include <string_view>

#include <assimp/BaseImporter.h>
#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/scene.h>
#include <osg/MatrixTransform>
#include <osgDB/FileNameUtils>

#include "irsg/core/AppendUnique.h"
#include "irsg/core/Errors.h"
#include "irsg/geometry/reading/NoFaces.h"
#include "irsg/geometry/reading/assimp/AssimpFiles.h"
#include "irsg/geometry/reading/assimp/AssimpGraph.h"
#include "irsg/geometry/reading/assimp/AssimpStates.h"
#include "irsg/geometry/reading/sandbox/DeclaredContents.h"
#include "irsg/geometry/reading/sandbox/GltfFile.h"
#include "irsg/geometry/reading/text/ModelText.h"

namespace irsg {

namespace {

namespace fs = std::filesystem;

/// What Assimp warns of while an object lives.
class Warnings {
  public:
    Warnings() {
        Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0);
        Assimp::DefaultLogger::get()->attachStream(new Stream(lines_),
                                                   Assimp::Logger::Warn | Assimp::Logger::Err);
    }
    ~Warnings() { Assimp::DefaultLogger::kill(); }
    Warnings(const Warnings&) = delete;
    Warnings& operator=(const Warnings&) = delete;

    const std::vector<std::string>& lines() const { return lines_; }

  private:
    struct Stream : Assimp::LogStream {
        explicit Stream(std::vector<std::string>& into) : lines(into) {}
        void write(const char* message) override {
            constexpr std::size_t most = 20;
            std::string line = message;
            while (!line.empty() && (line.back() == '\n' || line.back() == ' '))
                line.pop_back();
            // "Warn,  T0: " says nothing to anybody.
            if (const auto colon = line.find(": "); colon < 16)
                line.erase(0, colon + 2);
            // Whether all was read is found out here; normals that are missing are told elsewhere.
            for (const char* known :
                 {"unsupported, newer format version", "failed to resolve vertex layer element"})
                if (line.find(known) != line.npos)
                    return;
            if (lines.size() < most && !line.empty())
                appendUnique(lines, line);
        }
        std::vector<std::string>& lines;
    };
    std::vector<std::string> lines_;
};

/// An importer that knows the readers of one extension alone: others would look into the file.
class OneImporter {
  public:
    explicit OneImporter(const std::string& extension) {
        for (std::size_t i = importer_.GetImporterCount(); i-- > 0;) {
            const std::string known =
                " " + std::string(importer_.GetImporterInfo(i)->mFileExtensions) + " ";
            if (known.find(" " + extension + " ") != known.npos)
                continue;
            auto* other = importer_.GetImporter(i);
            importer_.UnregisterLoader(other);
            others_.emplace_back(other);
        }
        // Axes and unit stay those of the file.
        importer_.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
        importer_.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);
        for (const char* unused :
             {AI_CONFIG_IMPORT_FBX_READ_ANIMATIONS, AI_CONFIG_IMPORT_FBX_READ_CAMERAS,
              AI_CONFIG_IMPORT_FBX_READ_LIGHTS})
            importer_.SetPropertyBool(unused, false);
    }
    Assimp::Importer& get() { return importer_; }

  private:
    std::vector<std::unique_ptr<Assimp::BaseImporter>> others_;
    Assimp::Importer importer_;
};

class AssimpModel {
  public:
    AssimpModel(const fs::path& place, const fs::path& file)
        : place_(place),
          file_(file),
          extension_(osgDB::getLowerCaseFileExtension(file.string())),
          isGltf_(extension_ == "gltf" || extension_ == "glb") {}

    LoadedGraph read() {
        // What the file says of itself comes first: most damage is found there, and named better.
        if (isGltf_)
            gltf_ = readGltfFile(place_, file_);
        else if (extension_ == "fbx")
            stated_ = readFbxFile(place_, file_);
        else if (extension_ == "dae")
            stated_ = readColladaFile(place_, file_);
        else
            stated_ = readXFile(place_, file_);
        OneImporter importer(extension_);
        import(importer.get());

        LoadedGraph loaded;
        AssimpStates states(*scene_, file_, isGltf_ || extension_ == "x");
        if (isGltf_)
            takeGltf(loaded.axes);
        else
            takeDeclared(loaded.axes);
        AssimpGraph graph(*scene_, states, transforms_, file_.string());
        loaded.node = graph.make();
        if (extension_ == "x")
            loaded.node = turnedUpright(*loaded.node);
        loaded.remarks = std::move(remarks_);
        for (const auto& more : {states.remarks(), graph.remarks()})
            appendUnique(loaded.remarks, more);
        compare(graph, loaded.remarks);
        return loaded;
    }

  private:
    [[noreturn]] void refuse(std::string position, std::string value, std::string expected) const {
        throw InputError(
            {file_.string(), std::move(position), std::move(value), std::move(expected)});
    }

    void import(Assimp::Importer& importer) {
        std::string bytes = stated_.text ? std::move(*stated_.text) : readModelBytes(place_, file_);
        auto* files = new AssimpFiles(file_, std::move(bytes)); // the importer's from now on
        importer.SetIOHandler(files);
        std::string complaint;
        {
            const Warnings warnings;
            scene_ = importer.ReadFile(file_.string(), 0);
            complaint = importer.GetErrorString();
            for (const std::string& line : warnings.lines())
                appendUnique(remarks_, line);
        }
        appendUnique(remarks_, files->remarks());
        if (complaint.find("bad_alloc") != complaint.npos)
            throw std::bad_alloc();
        if (scene_ && scene_->mRootNode)
            return;
        for (const std::string& line : remarks_)
            if (complaint.find(line) == complaint.npos && line.find(complaint) == line.npos)
                complaint += (complaint.empty() ? "" : "; ") + line;
        refuse("", "a file that Assimp cannot read as a model (" + complaint + ")",
               "a whole model file of type ." + extension_);
    }

    aiNode& root() const { return *scene_->mRootNode; }

    /// Nodes in double, and each mesh as long as the file says.
    void takeGltf(FileAxes& axes) {
        axes = {1.0, ModelAxis::plusY, ModelAxis::plusZ,
                "the format: glTF is in metres, with y up and the front along z"};
        appendUnique(remarks_, gltf_.remarks);
        for (unsigned int i = 0; i < scene_->mNumMaterials; ++i)
            if (i >= gltf_.materials)
                scene_->mMaterials[i]->RemoveProperty(AI_MATKEY_NAME);
        if (gltf_.roots.size() == 1) {
            takeNode(root(), gltf_.roots.front());
        } else {
            checkChildren(root(), gltf_.roots);
            root().mName = aiString(); // Assimp's own
            for (std::size_t i = 0; i < gltf_.roots.size(); ++i)
                takeNode(*root().mChildren[i], gltf_.roots[i]);
        }
    }

    void checkChildren(const aiNode& node, const std::vector<std::size_t>& stated) const {
        if (node.mNumChildren != stated.size())
            refuse("node '" + std::string(node.mName.C_Str()) + "'",
                   std::to_string(node.mNumChildren) + " nodes below it that were read",
                   std::to_string(stated.size()) + ", which the file has");
    }

    void takeNode(aiNode& node, std::size_t number) {
        const GltfFile::Node& stated = gltf_.nodes[number];
        node.mName = aiString(stated.name);
        transforms_.emplace(&node, stated.transform);
        if (stated.mesh) {
            const GltfFile::Mesh& mesh = gltf_.meshes[*stated.mesh];
            if (node.mNumMeshes != mesh.primitives.size())
                refuse("nodes." + std::to_string(number),
                       std::to_string(node.mNumMeshes) + " lists of faces that were read",
                       std::to_string(mesh.primitives.size()) + ", which the file has");
            for (unsigned int i = 0; i < node.mNumMeshes; ++i)
                if (node.mMeshes[i] < scene_->mNumMeshes)
                    takeMesh(*scene_->mMeshes[node.mMeshes[i]], mesh, *stated.mesh, i);
        }
        checkChildren(node, stated.children);
        for (unsigned int i = 0; i < node.mNumChildren; ++i)
            takeNode(*node.mChildren[i], stated.children[i]);
    }

    void takeMesh(aiMesh& read, const GltfFile::Mesh& mesh, std::size_t number, unsigned int part) {
        const auto& stated = mesh.primitives[part];
        const std::string where =
            "meshes." + std::to_string(number) + ".primitives." + std::to_string(part);
        if (read.mNumVertices != stated.vertices || read.mNumFaces != stated.faces)
            refuse(where,
                   std::to_string(read.mNumVertices) + " vertices and " +
                       std::to_string(read.mNumFaces) + " faces that were read",
                   std::to_string(stated.vertices) + " and " + std::to_string(stated.faces) +
                       ", which the file has");
        read.mName = aiString(mesh.name);
        if (stated.scaledPlaces) {
            delete[] read.mTextureCoords[0];
            read.mTextureCoords[0] = nullptr;
            appendUnique(remarks_, "texture coordinates in whole numbers are left out");
        }
        checkExtent(read, stated, where);
    }

    /// Positions lie where the file says that they do.
    void checkExtent(const aiMesh& read, const GltfFile::Primitive& stated,
                     const std::string& where) {
        if (!stated.least || !stated.most || read.mNumVertices == 0)
            return;
        osg::Vec3d least(1e300, 1e300, 1e300), most = -least;
        for (unsigned int i = 0; i < read.mNumVertices; ++i)
            for (int axis = 0; axis < 3; ++axis) {
                const double value =
                    static_cast<double>(read.mVertices[i][static_cast<unsigned int>(axis)]);
                least[axis] = std::min(least[axis], value);
                most[axis] = std::max(most[axis], value);
            }
        const double size = (*stated.most - *stated.least).length();
        const double far = std::max(stated.least->length(), stated.most->length());
        const double mayDiffer = 1e-5 * size + 1e-6 * far;
        if (!((least - *stated.least).length() <= mayDiffer &&
              (most - *stated.most).length() <= mayDiffer))
            appendUnique(remarks_, where +
                                       ": positions do not reach from least to most as the file "
                                       "says: one of both is damaged");
    }

    /// .x has y up and turns to the left; Assimp mirrors it. What comes of it is turned to z up.
    static osg::ref_ptr<osg::Group> turnedUpright(osg::Node& graph) {
        osg::ref_ptr<osg::Group> root =
            new osg::MatrixTransform(osg::Matrixd(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1));
        root->addChild(&graph);
        return root;
    }

    void takeDeclared(FileAxes& axes) {
        axes = stated_.axes;
        appendUnique(remarks_, stated_.remarks);
        if (extension_ == "x") {
            if (std::string_view(root().mName.C_Str()) == "$dummy_root")
                root().mName = aiString(); // Assimp's own
            if (scene_->mNumAnimations > 0)
                appendUnique(remarks_,
                             std::to_string(scene_->mNumAnimations) +
                                 " animations are not played: parts are where the file puts them");
            return;
        }
        // What Assimp turned and scales is what the outermost node does: files have no other for
        // it.
        root().mTransformation = aiMatrix4x4();
        if (extension_ == "fbx")
            root().mName = aiString();
    }

    void compare(const AssimpGraph& graph, std::vector<std::string>& remarks) const {
        if (!(graph.placedPolygons() > 0.0))
            refuseWithoutFaces(file_.string(), remarks);
        if (stated_.placedPolygons && graph.placedPolygons() < *stated_.placedPolygons)
            refuse("", numberText(graph.placedPolygons()) + " polygons that were read",
                   numberText(*stated_.placedPolygons) + ", which the file has");
        if (stated_.corners && graph.corners() < *stated_.corners)
            appendUnique(remarks,
                         "of " + std::to_string(*stated_.corners) +
                             " corners of polygons in the file " + std::to_string(graph.corners()) +
                             " were read: the others belong to meshes that are placed nowhere");
    }

    const fs::path &place_, &file_;
    std::string extension_;
    bool isGltf_;
    GltfFile gltf_;
    DeclaredContents stated_;
    const aiScene* scene_ = nullptr;
    std::vector<std::string> remarks_;
    AssimpGraph::Transforms transforms_; ///< of glTF's nodes
};

} // namespace

LoadedGraph readWithAssimp(const fs::path& place, const fs::path& file) {
    return AssimpModel(place, file).read();
}

} // namespace irsg
