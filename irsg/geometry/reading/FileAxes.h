#pragma once

#include <optional>
#include <string>

#include "irsg/geometry/reading/ModelValues.h"
#include "irsg/geometry/reading/text/UnitWords.h"

namespace irsg {

/// What a file says of itself, or its format of all files, about the numbers of the graph that is
/// handed over. Nothing is turned or scaled because of it: that is for whoever places the model.
struct FileAxes {
    std::optional<double> unit_m;   ///< one unit of the graph in metres, above 0
    std::optional<ModelAxis> up;    ///< which axis of the graph points up
    std::optional<ModelAxis> front; ///< and which to the front, where a format has a word for that
    std::string reason; ///< "the format glTF is in metres, y up"; empty where nothing is said
    /// A unit that a comment or a name in the file mentions, where its format has no place for one:
    /// for whoever guesses, and for nobody else.
    std::optional<UnitInWords> spokenUnit = {};
    /// Where the front of nearly all models of the format points, though no file has to keep to it:
    /// where nobody says anything else; a guess believes the shape before it.
    std::optional<ModelAxis> usualFront = {};

    bool operator==(const FileAxes&) const = default;
};

} // namespace irsg
