#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "irsg/geometry/reading/ModelValues.h"

namespace irsg {

/// A unit in which files are.
struct ModelUnit {
    double unit_m;
    const char* symbol;
    const char* name;
};
/// In the order in which a guess believes them.
inline constexpr ModelUnit modelUnits[] = {
    {1.0, "m", "metres"},     {0.01, "cm", "centimetres"}, {0.001, "mm", "millimetres"},
    {0.0254, "in", "inches"}, {0.3048, "ft", "feet"},      {1000.0, "km", "kilometres"}};

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
