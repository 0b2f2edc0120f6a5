#pragma once

#include <unordered_map>
#include <vector>

#include <osg/Geometry>

namespace irsg {

/// What faces of a file choose from.
struct FaceShape {
    std::vector<osg::Vec3d> vertices, normals;
    std::vector<osg::Vec2d> places;  ///< texture coordinates
    std::vector<osg::Vec4f> colours; ///< of the vertices, red to alpha; empty where there are none
};

/// A corner of a face by its numbers, from 0; -1 where the face states none.
struct FaceCorner {
    int vertex = -1, place = -1, normal = -1;
    bool operator==(const FaceCorner&) const = default;
};

/// The faces of one name, as a group, a layer or a material, on their way to a drawable. Corners
/// that are equal in all numbers share a vertex.
class FaceDrawable {
  public:
    /// The shape must outlive the object; it may grow.
    explicit FaceDrawable(const FaceShape& shape) : shape_(&shape) {}

    /// Three corners or more. Where one has no normal all get that of the face.
    void add(const std::vector<FaceCorner>& face);
    /// With positions from an origin on.
    osg::ref_ptr<osg::Geometry> make(const osg::Vec3d& origin) const;

  private:
    struct Hash {
        std::size_t operator()(const FaceCorner& corner) const;
    };
    /// White where not every vertex has one.
    osg::ref_ptr<osg::Vec4Array> colours() const;
    unsigned int index(const FaceCorner& corner, const osg::Vec3f& faceNormal);

    const FaceShape* shape_;
    std::vector<FaceCorner> corners_;
    std::vector<osg::Vec3f> normals_;
    std::unordered_map<FaceCorner, unsigned int, Hash> known_; ///< with normals that are stated
    std::vector<unsigned int> triangles_, quads_;
    bool anyPlace_ = false;
};

} // namespace irsg
