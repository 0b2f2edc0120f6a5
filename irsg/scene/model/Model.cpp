#include "irsg/scene/model/Model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <osg/Geode>
#include <osg/Group>

#include "irsg/radiometry/Errors.h"
#include "irsg/scene/model/GeometryCollector.h"
#include "irsg/scene/model/ModelLoader.h"
#include "irsg/scene/model/SurfaceMesh.h"

namespace irsg {
namespace {

/// Turns the axis the nose points along onto +y; z stays up.
osg::Matrixd toModelAxes(NoseAxis nose) {
    switch (nose) {
    case NoseAxis::plusX: // (x, y) -> (-y, x)
        return {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    case NoseAxis::minusX: // (x, y) -> (y, -x)
        return {0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    case NoseAxis::minusY:
        return {-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    case NoseAxis::plusY:
        break;
    }
    return osg::Matrixd::identity();
}

} // namespace

struct Model::Impl {
    std::string name;
    std::filesystem::path file;
    osg::ref_ptr<osg::Group> graph;
    std::map<IrCodes, CodeUse> codes;
    std::map<IrCodes, BoundingBox> boxes;
    BoundingBox bounds = BoundingBox::nowhere();
    std::vector<std::string> remarks;

    /// Fills everything from a loaded graph; `faces` are the file's own counts where it has some.
    void fill(osg::Node& loaded, const std::map<IrCodes, int>& faces, const ModelOptions& options) {
        SurfaceMesh mesh;
        GeometryCollector collector(mesh, toModelAxes(options.noseAxis),
                                    file.empty() ? name : file.string(), options.forceTwoSided);
        collector.collect(loaded);
        const auto said = collector.remarks();
        remarks.insert(remarks.end(), said.begin(), said.end());
        if (mesh.parts().empty())
            throw InputError({file.empty() ? name : file.string(), "",
                              "a model without any visible face that has an area",
                              "at least one triangle"});

        for (const auto& [key, count] : faces)
            codes[key].faces = count;
        graph = new osg::Group;
        graph->setName(name);
        osg::ref_ptr<osg::Geode> geode = new osg::Geode;
        graph->addChild(geode);
        for (const auto& [key, part] : mesh.parts()) {
            geode->addDrawable(SurfaceMesh::drawable(key, part));
            auto& use = codes[key.codes];
            use.area_m2 += part.area_m2;
            if (faces.empty())
                use.faces += static_cast<int>(part.polygons);
            boxes.try_emplace(key.codes, BoundingBox::nowhere()).first->second.include(part.bounds);
            bounds.include(part.bounds);
        }
        remarkPrecision();
    }

    /// Vertices are single precision: far from the origin little is left for the shape.
    void remarkPrecision() {
        double farthest = 0.0;
        for (const auto& corner : {bounds.min, bounds.max})
            farthest =
                std::max({farthest, std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)});
        const double step_m = farthest * std::numeric_limits<float>::epsilon();
        if (step_m > 1e-5 * bounds.diagonal_m())
            remarks.push_back("the model lies " + std::to_string(farthest) +
                              " m from its origin, where single precision places vertices to " +
                              std::to_string(step_m) + " m only");
    }
};

Model::Model(std::unique_ptr<Impl> parts) : impl_(std::move(parts)) {}
Model::~Model() = default;

std::shared_ptr<Model> Model::load(const std::filesystem::path& file, const ModelOptions& options) {
    auto loaded = loadGraph(file, LoadPurpose::infrared);
    auto parts = std::make_unique<Impl>();
    parts->name = file.stem().string();
    parts->file = file;
    parts->remarks = std::move(loaded.remarks);
    parts->fill(*loaded.node, loaded.faces, options);
    return std::shared_ptr<Model>(new Model(std::move(parts)));
}

std::shared_ptr<Model> Model::fromGraph(osg::Node* graph, const std::string& name,
                                        const ModelOptions& options) {
    if (!graph)
        throw LogicError("Model::fromGraph without a graph");
    auto parts = std::make_unique<Impl>();
    parts->name = name;
    parts->fill(*graph, {}, options);
    return std::shared_ptr<Model>(new Model(std::move(parts)));
}

const std::string& Model::name() const {
    return impl_->name;
}
const std::filesystem::path& Model::file() const {
    return impl_->file;
}
osg::Node* Model::graph() const {
    return impl_->graph.get();
}
const std::map<IrCodes, CodeUse>& Model::codes() const {
    return impl_->codes;
}
const BoundingBox& Model::bounds() const {
    return impl_->bounds;
}
const std::vector<std::string>& Model::remarks() const {
    return impl_->remarks;
}

BoundingBox Model::boundsOf(const std::function<bool(const IrCodes&)>& wanted) const {
    auto box = BoundingBox::nowhere();
    for (const auto& [codes, part] : impl_->boxes)
        if (wanted(codes))
            box.include(part);
    return box;
}

} // namespace irsg
