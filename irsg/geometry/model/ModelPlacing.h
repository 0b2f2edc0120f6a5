#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "irsg/geometry/mesh/Mesh.h"
#include "irsg/geometry/model/PlacingGuess.h"
#include "irsg/geometry/reading/FileAxes.h"
#include "irsg/geometry/view/Matrix4.h"

namespace irsg {

struct LoadedGraph;

/// A placing with everything set but the origin: what is not set is as the file states it, or else
/// as ModelPlacing says. Throws InputError, naming `file`, where nose and up lie along one line and
/// for a unit that is none.
ModelPlacing completed(const ModelPlacing& placing, const FileAxes& axes, const std::string& file);

/// Leads from the file's axes and unit to those of a model, about the file's origin; of a placing
/// that is completed.
Matrix4 turnAndScale(const ModelPlacing& completed);

/// "inches", or "units of 0.5 m" where the unit has no name.
std::string unitName(double unit_m);

/// Looks at a graph as it was loaded. The plane of symmetry tells starboard from nose and up, the
/// longer of the two is the length, the end with a fin, or the higher and wider one, its tail; the
/// unit is the one that makes it 0.5 to 500 m long. Throws InputError as GeometryCollector does.
PlacingGuess guessPlacing(const LoadedGraph& graph, const std::string& file);

/// A model as its file has it, to try placings on before it is read for good.
struct ModelShape {
    std::vector<Float3> corners; ///< three of each triangle, in the axes and the unit of the file
    FileAxes axes;
    PlacingGuess guess;
};
/// Throws InputError as Model::load does.
ModelShape shapeOf(const std::filesystem::path& file);

} // namespace irsg
