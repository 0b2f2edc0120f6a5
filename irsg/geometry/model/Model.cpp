#include "irsg/geometry/model/Model.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "irsg/core/Errors.h"
#include "irsg/core/FreedMemory.h"
#include "irsg/geometry/conversion/GeometryCollector.h"
#include "irsg/geometry/conversion/ModelLoader.h"
#include "irsg/geometry/conversion/SharedPlanes.h"
#include "irsg/geometry/mesh/LongEdges.h"
#include "irsg/geometry/mesh/MeshPieces.h"
#include "irsg/geometry/model/ModelPlacing.h"
#include "irsg/geometry/reading/NoFaces.h"

namespace irsg {
namespace {

/// Single precision places the vertices of a model at most so far off, of its diagonal.
constexpr double leastPrecision = 1e-5;

double stepAt_m(const BoundingBox& bounds) {
    double farthest = 0.0;
    for (const auto& corner : {bounds.min, bounds.max})
        farthest = std::max({farthest, std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)});
    return farthest * std::numeric_limits<float>::epsilon();
}

std::string shown(const Vec3& p) {
    char text[96];
    std::snprintf(text, sizeof text, "(%.10g, %.10g, %.10g)", p.x, p.y, p.z);
    return text;
}

} // namespace

struct Model::Impl {
    std::string name;
    std::filesystem::path file;
    std::shared_ptr<const Mesh> mesh;
    std::map<IrCodes, CodeUse> codes;
    BoundingBox bounds = BoundingBox::nowhere();
    std::vector<std::string> remarks, notes;
    std::vector<SharedPlane> sharedPlanes;
    ModelPlacing placing;
    Matrix4 fromFile;
    std::shared_ptr<const ModelCodes> beside = std::make_shared<ModelCodes>();

    /// Fills everything from a loaded graph; `faces` are the file's own counts where it has some.
    void fill(osg::Node& loaded, const FileAxes& axes, const std::map<IrCodes, int>& faces,
              const ModelOptions& options) {
        const std::string said = file.empty() ? name : file.string();
        placing = completed(options.placing, axes, said);
        fromFile = turnAndScale(placing);
        const auto origin = placing.origin.value_or(ModelOrigin{});
        if (origin.at == ModelOrigin::At::point)
            moveTo(fromFile.place(origin.point));
        SurfaceMesh surfaces = collected(loaded, said, options);
        bool moves = origin.at == ModelOrigin::At::centre || origin.at == ModelOrigin::At::base;
        if (!placing.origin && stepAt_m(bounds) > leastPrecision * bounds.diagonal_m()) {
            remarks.push_back("the model lies far from its origin: its centre at " +
                              shown(bounds.centre()) + " m becomes the origin");
            moves = true;
        }
        // Far off the bounds are as coarse as single precision: what is left goes in a second step.
        for (int step = 0; moves && step < 3; ++step) {
            const Vec3 centre = bounds.centre();
            const Vec3 to{centre.x, centre.y,
                          origin.at == ModelOrigin::At::base ? bounds.min.z : centre.z};
            if (length(to) <= std::numeric_limits<float>::epsilon() * bounds.diagonal_m())
                break;
            moveTo(to);
            surfaces = collected(loaded, said, options);
        }
        remarks.insert(remarks.end(), notes.begin(), notes.end());
        sharedPlanes = settleSharedPlanes(surfaces);
        for (const SharedPlane& shared : sharedPlanes)
            remarks.push_back(toText(shared));

        for (const auto& [key, count] : faces)
            codes[key].faces = count;
        auto made = std::make_shared<Mesh>(meshOf(surfaces.take()));
        made->longEdges = longEdges(*made);
        cutIntoPieces(*made);
        for (const Mesh::Part& part : made->parts) {
            auto& use = codes[part.codes];
            use.area_m2 += part.area_m2;
            if (faces.empty())
                use.faces += static_cast<int>(part.polygons);
        }
        mesh = std::move(made);
        remarkPrecision();
    }

    void moveTo(const Vec3& origin) {
        auto& [x, y, z, last] = fromFile.rows[3];
        x -= origin.x, y -= origin.y, z -= origin.z;
    }

    /// What is there, in model axes as they are now, its bounds and what there is to say of it.
    SurfaceMesh collected(osg::Node& loaded, const std::string& said, const ModelOptions& options) {
        SurfaceMesh mesh;
        GeometryCollector collector(mesh, fromFile, said, options);
        collector.collect(loaded);
        notes = collector.remarks();
        bounds = BoundingBox::nowhere();
        for (const auto& [kind, part] : mesh.parts())
            bounds.include(part.bounds);
        if (mesh.parts().empty()) {
            remarks.insert(remarks.end(), notes.begin(), notes.end());
            refuseWithoutFaces(said, remarks);
        }
        return mesh;
    }

    /// Vertices are single precision: far from the origin little is left for the shape.
    void remarkPrecision() {
        const double step_m = stepAt_m(bounds);
        if (step_m > leastPrecision * bounds.diagonal_m())
            remarks.push_back("the model lies " +
                              std::to_string(step_m / std::numeric_limits<float>::epsilon()) +
                              " m from its origin, where single precision places vertices to " +
                              std::to_string(step_m) + " m only");
    }
};

Model::Model(std::unique_ptr<Impl> parts) : impl_(std::move(parts)) {}
Model::~Model() = default;

std::shared_ptr<Model> Model::load(const std::filesystem::path& file, const ModelOptions& options) {
    auto model =
        ofGraph(loadGraphAsIs(file, purposeOf(options)), readModelCodes(file), file, options);
    // What was read of a large one is several times what is left.
    constexpr std::size_t manyFacets = 200'000;
    if (model->mesh()->facets() > manyFacets)
        giveBackFreedMemory();
    return model;
}

std::shared_ptr<Model> Model::ofGraph(const LoadedGraph& asIs, const ModelCodes& codes,
                                      const std::filesystem::path& file,
                                      const ModelOptions& options) {
    if (!asIs.node)
        throw LogicError("a model of no graph");
    LoadedGraph loaded = withCodes(asIs, codes, file);
    auto parts = std::make_unique<Impl>();
    parts->name = file.stem().string();
    parts->file = file;
    parts->remarks = std::move(loaded.remarks);
    parts->beside = std::make_shared<const ModelCodes>(codes);
    parts->fill(*loaded.node, loaded.axes, loaded.faces, options);
    return std::shared_ptr<Model>(new Model(std::move(parts)));
}

const std::string& Model::name() const {
    return impl_->name;
}
const std::filesystem::path& Model::file() const {
    return impl_->file;
}
const std::shared_ptr<const Mesh>& Model::mesh() const {
    return impl_->mesh;
}
const std::map<IrCodes, CodeUse>& Model::codes() const {
    return impl_->codes;
}
const std::shared_ptr<const ModelCodes>& Model::codesBeside() const {
    return impl_->beside;
}
const BoundingBox& Model::bounds() const {
    return impl_->bounds;
}
const std::vector<std::string>& Model::remarks() const {
    return impl_->remarks;
}

const std::vector<SharedPlane>& Model::sharedPlanes() const {
    return impl_->sharedPlanes;
}

const ModelPlacing& Model::placing() const {
    return impl_->placing;
}
const Matrix4& Model::fromFile() const {
    return impl_->fromFile;
}

BoundingBox Model::boundsOf(const std::function<bool(const IrCodes&)>& wanted) const {
    auto box = BoundingBox::nowhere();
    for (const Mesh::Part& part : impl_->mesh->parts)
        if (wanted(part.codes))
            box.include(part.bounds);
    return box;
}

} // namespace irsg
