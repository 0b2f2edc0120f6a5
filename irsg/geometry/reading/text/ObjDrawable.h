#pragma once

#include <unordered_map>
#include <vector>

#include <osg/Geometry>

namespace irsg {

/// What faces of a Wavefront object choose from.
struct ObjShape {
    std::vector<osg::Vec3d> vertices, normals;
    std::vector<osg::Vec2d> places; ///< texture coordinates
};

/// A corner of a face by its numbers, from 0; -1 where the face states none.
struct ObjCorner {
    int vertex = -1, place = -1, normal = -1;
    bool operator==(const ObjCorner&) const = default;
};

/// The faces of one group and material on their way to a drawable. Corners that are equal in all
/// numbers share a vertex.
class ObjDrawable {
  public:
    /// The shape must outlive the object; it may grow.
    explicit ObjDrawable(const ObjShape& shape) : shape_(&shape) {}

    /// Three corners or more. Where one has no normal all get that of the face.
    void add(const std::vector<ObjCorner>& face);
    /// With positions from an origin on.
    osg::ref_ptr<osg::Geometry> make(const osg::Vec3d& origin) const;

  private:
    struct Hash {
        std::size_t operator()(const ObjCorner& corner) const;
    };
    unsigned int index(const ObjCorner& corner, const osg::Vec3f& faceNormal);

    const ObjShape* shape_;
    std::vector<ObjCorner> corners_;
    std::vector<osg::Vec3f> normals_;
    std::unordered_map<ObjCorner, unsigned int, Hash> known_; ///< with normals that are stated
    std::vector<unsigned int> triangles_, quads_;
    bool anyPlace_ = false;
};

} // namespace irsg
