#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "irsg/geometry/model/Model.h"

namespace irsg {

/// What a conversion did.
struct ConversionReport {
    /// Polygons per pair of codes as read and as written, every copy that instances draw and hidden
    /// ones included. Where they differ, concave polygons were cut into triangles.
    std::map<IrCodes, long> polygonsRead, polygonsWritten;
    int drawablesRead = 0, drawablesWritten = 0;
    std::map<IrCodes, long> facesThatClose; ///< see ConversionOptions
    ModelPlacing
        placing; ///< how what was read became metres and the axes of a model, all but origin
    std::vector<std::string> remarks;
};

/// How a conversion reads its input.
struct ConversionOptions {
    /// Meshes of these materials get faces where they are open, so that shells about gas are zones.
    std::set<int> closed = {};
    /// Up, nose and unit of the input, in place of what its file states. The origin stays that of
    /// the file.
    ModelPlacing placing = {};
};

/// Reads a model and writes it as .osgt, .osgb, .ive, .osg or .osgx with its codes as a
/// ShapeAttributeList (IRColor, IRMaterial) in the UserData of each drawable, so that the stock
/// viewer shows the file and the codes survive. Visible appearance, levels of detail, switches and
/// hidden faces stay; external references become part of the file. Drawables of OpenFlight files
/// are merged where neither state nor codes differ. The file is read back before it is written:
/// unless its codes and their areas are those of the input, and its corners where they were to 1e-7
/// of the extent of all, an InputError is thrown. Throws InputError
/// for an input that cannot be read, a kind of output that loses codes and a place that cannot be
/// written. A stop that is asked for before the end leaves `out` as it was and gives an empty
/// report. None of these kinds of output states a unit or axes: they are written in metres with x
/// to starboard, y to the nose and z up, as Model::load reads them, by the transformation that it
/// would apply to the input. Remarks state what was turned and scaled, and what the input leaves
/// open. InputError where open meshes cannot be closed and where nose and up lie along one line;
/// LogicError for a placing with an origin.
ConversionReport convertModel(const std::filesystem::path& in, const std::filesystem::path& out,
                              const std::stop_token& stop = {},
                              const ConversionOptions& options = {});

} // namespace irsg
