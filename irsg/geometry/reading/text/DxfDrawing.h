#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <osg/Matrixd>

#include "irsg/geometry/reading/FileAxes.h"

namespace irsg {

/// The surfaces of a drawing in the exchange format of AutoCAD (.dxf).
struct DxfDrawing {
    struct Face {
        std::string layer;
        std::vector<osg::Vec3d> corners; ///< three or more
    };
    /// A place at which a block stands once more.
    struct Insertion {
        std::string block;
        osg::Matrixd matrix; ///< from the block's positions, for row vectors
    };
    struct Block {
        std::vector<Face> faces;
        std::vector<Insertion> insertions;
    };
    Block model;                         ///< what no block holds
    std::map<std::string, Block> blocks; ///< by their names in lower case
    FileAxes axes;
    std::vector<std::string> remarks;
};

/// Reads 3DFACE, SOLID, TRACE, POLYLINE of meshes and of faces, and INSERT with its rows and
/// columns, all with their layers and, where they are flat, with the plane that they state. The
/// unit is that of $INSUNITS. What has no faces (lines, texts, dimensions) and what hides its faces
/// in another language (3DSOLID, BODY, REGION, SURFACE) is counted in a remark. `text` is a
/// plainText(). Throws InputError, with the line, for what is no drawing, for a drawing without its
/// end, numbers that are none and faces of vertices that there are not.
DxfDrawing readDxfDrawing(std::string_view text, const std::string& file);

} // namespace irsg
