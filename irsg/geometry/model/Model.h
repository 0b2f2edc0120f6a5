#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "irsg/geometry/reading/ModelValues.h"
#include "irsg/geometry/view/Vec3.h"

namespace osg {
class Matrixd;
class Node;
} // namespace osg

namespace irsg {

struct LoadedGraph;
struct ModelCodes;

/// A loaded model: geometry with its codes, in the axes of this program (x starboard, y nose, z
/// up). The graph is one Group with one Geode; its drawables are osg::Geometry, one for each
/// subface level, pair of codes and culling, sorted by these: a Vec3Array of vertices, a Vec3Array
/// of unit normals that agree with the winding of their faces, a Vec4Array of the file's colours
/// for a visible view, all per vertex, and one DrawElementsUInt of triangles, counter-clockwise
/// from the front. The only StateSets are those of the drawables and hold nothing but culling:
/// CullFace BACK on for draw type 0, GL_CULL_FACE off otherwise, and PolygonOffset (-n, -n) for
/// subfaces of level n, which lie in the plane of the face below them and follow it in the list.
/// UserData is a ShapeAttributeList with IRColor and IRMaterial. Two loads of a file give equal
/// graphs.
class Model {
  public:
    /// Loads .flt, .osgt, .osgb, .ive and the other models of OpenableFiles.h. An OpenFlight file
    /// is validated by the record scanner first. Throws InputError for a file that is missing,
    /// truncated, malformed (with the byte offset), unreadable or without faces.
    static std::shared_ptr<Model> load(const std::filesystem::path& file,
                                       const ModelOptions& options = {});
    /// The same of what was read already (loadGraphAsIs), with these codes beside it; the graph is
    /// left as it is, and nobody else may use it meanwhile.
    static std::shared_ptr<Model> ofGraph(const LoadedGraph& asIs, const ModelCodes& codes,
                                          const std::filesystem::path& file,
                                          const ModelOptions& options = {});
    /// Takes a graph made in memory; codes are read from its ShapeAttributeLists.
    static std::shared_ptr<Model> fromGraph(osg::Node* graph, const std::string& name,
                                            const ModelOptions& options = {});
    ~Model();

    const std::string& name() const;
    const std::filesystem::path& file() const;
    osg::Node* graph() const;
    const std::map<IrCodes, CodeUse>& codes() const;
    /// What was given beside those of the file; never null.
    const std::shared_ptr<const ModelCodes>& codesBeside() const;
    /// Of all geometry, model axes.
    const BoundingBox& bounds() const;
    /// Of the geometry whose codes are wanted; not valid() where there is none.
    BoundingBox boundsOf(const std::function<bool(const IrCodes&)>& wanted) const;
    /// What the loader had to do or could not keep: LODs overridden, normals made, files missing.
    const std::vector<std::string>& remarks() const;

    /// Where the order of its file decides what is drawn; the largest first.
    const std::vector<SharedPlane>& sharedPlanes() const;
    /// As the model was read, up, nose and unit set; the origin where it was asked for.
    const ModelPlacing& placing() const;
    /// Leads from the axes and the unit of the file to model axes, p' = p M.
    const osg::Matrixd& fromFile() const;

  private:
    struct Impl;
    explicit Model(std::unique_ptr<Impl> parts);
    std::unique_ptr<Impl> impl_;
};

} // namespace irsg
