#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "irsg/scene/model/ModelValues.h"

namespace irsg {

/// What a model most likely is like, by what its file states and by its shape, for a person to
/// confirm.
struct PlacingGuess {
    ModelPlacing placing;             ///< everything set
    Vec3 size_m;                      ///< of the bounding box in model axes, so placed
    std::vector<std::string> reasons; ///< a sentence each: up, nose, unit, origin
};

/// Reads the file. Throws InputError as Model::load does.
PlacingGuess placingGuess(const std::filesystem::path& file);

} // namespace irsg
