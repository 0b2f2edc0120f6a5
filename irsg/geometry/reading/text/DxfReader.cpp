#include "irsg/geometry/reading/text/DxfReader.h"

#include <algorithm>
#include <map>
#include <utility>

#include <osg/Geode>
#include <osg/MatrixTransform>

#include "irsg/core/AppendUnique.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/geometry/reading/FarOrigin.h"
#include "irsg/geometry/reading/OpenableFiles.h"
#include "irsg/geometry/reading/text/DxfDrawing.h"
#include "irsg/geometry/reading/text/FaceDrawable.h"
#include "irsg/geometry/reading/text/ModelText.h"

namespace irsg {

namespace {

class DrawingGraph {
  public:
    DrawingGraph(DxfDrawing& drawing, const std::string& file) : drawing_(drawing), file_(file) {}

    osg::ref_ptr<osg::Node> make() { return groupOf(drawing_.model, 0).group; }

  private:
    struct Part {
        osg::ref_ptr<osg::Group> group;
        double faces = 0.0; ///< with all copies
    };

    Part groupOf(const DxfDrawing::Block& block, int level) {
        Part part{facesOf(block), static_cast<double>(block.faces.size())};
        for (const DxfDrawing::Insertion& insertion : block.insertions) {
            const Part* inner = blockOf(insertion.block, level);
            if (!inner || inner->faces == 0.0)
                continue;
            part.faces += inner->faces;
            if (part.faces > mostFaces_)
                refuse("copies of blocks that make more than " + numberText(mostFaces_) + " faces",
                       "fewer");
            osg::ref_ptr<osg::MatrixTransform> placed = new osg::MatrixTransform(insertion.matrix);
            placed->setName(insertion.block);
            placed->addChild(inner->group);
            part.group->addChild(placed);
        }
        return part;
    }

    const Part* blockOf(const std::string& name, int level) {
        if (const auto known = parts_.find(name); known != parts_.end()) {
            if (!known->second.group)
                refuse("the block \"" + name + "\" within itself", "blocks in a tree");
            return &known->second;
        }
        const auto block = drawing_.blocks.find(name);
        if (block == drawing_.blocks.end()) {
            appendUnique(drawing_.remarks,
                         "refers to the block \"" + name + "\", which is missing");
            return nullptr;
        }
        if (level >= mostBlockLevels)
            refuse("blocks in more than " + std::to_string(mostBlockLevels) + " levels", "fewer");
        parts_[name]; // begun
        Part part = groupOf(block->second, level + 1);
        return &(parts_[name] = std::move(part));
    }

    /// A drawable for each layer, counted from near itself where it lies far from zero.
    static osg::ref_ptr<osg::Group> facesOf(const DxfDrawing::Block& block) {
        FaceShape shape;
        osg::BoundingBoxd bounds;
        std::map<std::string, FaceDrawable> layers;
        std::vector<std::string> order;
        for (const DxfDrawing::Face& face : block.faces) {
            std::vector<FaceCorner> corners;
            for (const osg::Vec3d& corner : face.corners) {
                corners.push_back({static_cast<int>(shape.vertices.size()), -1, -1});
                shape.vertices.push_back(corner);
                bounds.expandBy(corner);
            }
            const auto [layer, added] = layers.try_emplace(face.layer, shape);
            if (added)
                order.push_back(face.layer);
            layer->second.add(corners);
        }
        const auto far = farOriginOf(bounds);
        const osg::Vec3d origin = far.value_or(osg::Vec3d());
        osg::ref_ptr<osg::Group> all = new osg::Group;
        osg::ref_ptr<osg::Group> near =
            far ? new osg::MatrixTransform(osg::Matrixd::translate(origin)) : all;
        if (far)
            all->addChild(near);
        for (const std::string& name : order) {
            osg::ref_ptr<osg::Geode> geode = new osg::Geode;
            geode->setName(name);
            geode->addDrawable(layers.at(name).make(origin));
            near->addChild(geode);
        }
        return all;
    }

    [[noreturn]] void refuse(std::string value, std::string expected) const {
        throw InputError({file_, "", std::move(value), std::move(expected)});
    }

    /// As GraphExtent counts what others read.
    static double mostFacesOf(const DxfDrawing& drawing) {
        double written = static_cast<double>(drawing.model.faces.size());
        for (const auto& [name, block] : drawing.blocks)
            written += static_cast<double>(block.faces.size());
        return std::max(2e6, 200.0 * written);
    }

    static constexpr int mostBlockLevels = 100;
    DxfDrawing& drawing_;
    const std::string& file_;
    const double mostFaces_ = mostFacesOf(drawing_);
    std::map<std::string, Part> parts_; ///< without a group while they are made
};

} // namespace

LoadedGraph readDxf(const std::filesystem::path& file) {
    std::string bytes = readFile(file, largestModel_B);
    const std::string name = file.string();
    if (bytes.starts_with("AutoCAD Binary DXF"))
        throw InputError({name, "byte 0", "a drawing in binary numbers", "a drawing as text"});
    const std::string text = plainText(std::move(bytes), name);
    if (const auto zero = text.find('\0'); zero != text.npos)
        throw InputError(
            {name, "byte " + std::to_string(zero), "a zero byte", "a drawing, which is a text"});
    DxfDrawing drawing = readDxfDrawing(text, name);
    LoadedGraph loaded;
    loaded.node = DrawingGraph(drawing, name).make();
    loaded.axes = std::move(drawing.axes);
    loaded.remarks = std::move(drawing.remarks);
    return loaded;
}

} // namespace irsg
