#pragma once

#include <optional>
#include <vector>

#include <osg/Geode>
#include <osg/Group>
#include <osg/ref_ptr>

#include "gui/view/CodeColors.h"
#include "irsg/geometry/model/Model.h"

namespace smat::gui {

/// Faces by their codes: all that carry the temperature index, the material index, or both where
/// both are given.
struct FaceSelection {
    std::optional<int> temperature;
    std::optional<int> material;
    std::optional<int> model; ///< number in the project; of every model where it is not given

    bool empty() const { return !temperature && !material; }
    bool holds(int ofModel, const irsg::IrCodes& codes) const;
    bool operator==(const FaceSelection&) const = default;
};

/// A face under the mouse.
struct FaceHit {
    int model = 0; ///< number in the project; the target is 0
    irsg::IrCodes codes;
    irsg::Vec3 point_m; ///< in the world
    double distance_m = 0.0;
};

/// The faces of a model as the infrared renderer sees them, to be found and shown by their codes:
/// a copy of its mesh as OpenSceneGraph draws it, in model axes.
class ModelFaces {
  public:
    explicit ModelFaces(const irsg::Model& model);

    /// All drawables, without a state.
    osg::Geode* geode() const { return geode_; }
    /// What stands before an eye along a ray, nearest first, each face once; walls that are
    /// culled from behind are not there.
    struct Hit {
        irsg::IrCodes codes;
        irsg::Vec3 point_m; ///< in model axes
        double distance_m = 0.0;
    };
    std::vector<Hit> along(const irsg::Vec3& eye, const irsg::Vec3& direction) const;
    /// Tint and outline of the selected faces, to be drawn over them; null where there are none.
    osg::ref_ptr<osg::Group> marked(int model, const FaceSelection& selection,
                                    double devicePixelRatio) const;
    /// All faces, lit, each in the colour of its codes.
    osg::ref_ptr<osg::Group> colored(const CodeColors& colors) const;
    /// Edges of all faces.
    osg::ref_ptr<osg::Group> wireframe(double devicePixelRatio) const;
    const irsg::BoundingBox& bounds() const { return bounds_; }

  private:
    struct Surface {
        irsg::Mesh::Kind kind;
        osg::ref_ptr<osg::Array> normals;
    };
    const osg::Geometry* geometry(std::size_t surface) const;

    osg::ref_ptr<osg::Geode> geode_;
    std::vector<Surface> surfaces_; ///< by drawable
    irsg::BoundingBox bounds_;
};

} // namespace smat::gui
