#pragma once

#include <optional>
#include <vector>

#include "irsg/geometry/model/FaceMesh.h"
#include "irsg/geometry/view/Matrix4.h"

namespace irsg {

/// Faces of a FaceMesh by their numbers, ascending, each once.
using FaceNumbers = std::vector<unsigned int>;

/// What becomes of faces that are chosen already.
enum class Choosing { anew, add, takeAway };
FaceNumbers chosen(const FaceNumbers& before, const FaceNumbers& more, Choosing how);

/// The face that a ray meets first, of those that are drawn on the side it comes from. In the axes
/// of the file; none where it meets nothing.
std::optional<unsigned int> faceAlong(const FaceMesh& mesh, const Vec3& eye, const Vec3& direction);

/// All that hangs together with a face by its corners.
FaceNumbers partOf(const FaceMesh& mesh, unsigned int face);
/// All of the face's material: of the same name, else of the same state.
FaceNumbers sameMaterialAs(const FaceMesh& mesh, unsigned int face);
/// What is reached from a face over edges at which the surface bends by no more than that.
FaceNumbers smoothFrom(const FaceMesh& mesh, unsigned int face, double most_rad);

/// A rectangle of a picture of a model.
struct FaceBox {
    /// From the axes of the file to the picture: x / w and y / w in pixels, w the depth before the
    /// eye.
    Matrix4 toPicture;
    Vec3 eye; ///< in the axes of the file
    double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
    bool hiddenToo = false; ///< also what others hide, and what looks away
};
/// Those whose middle lies in a box, and which are seen there.
FaceNumbers facesIn(const FaceMesh& mesh, const FaceBox& box);

} // namespace irsg
