#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/samples/FlightWriter.h"

/// What the parts of the jet are made of: samples/tern/README.md has the list.
namespace smat::tern {

inline constexpr Look grey{136, 146, 154}, paleGrey{162, 170, 176}, darkGrey{84, 90, 96},
    dark{44, 46, 48}, gold{92, 84, 60}, burnt{96, 80, 70}, hot{120, 84, 64},
    gas{230, 190, 150, 0.85};

inline const FlightSurface skin{"skin", {1, 1}, false, grey};
inline const FlightSurface edge{"edge", {2, 1}, false, darkGrey};
inline const FlightSurface canopy{"canopy", {3, 2}, false, gold};
inline const FlightSurface frame{"frame", {4, 1}, false, darkGrey};
inline const FlightSurface radome{"radome", {5, 3}, false, darkGrey};
inline const FlightSurface belly{"belly", {6, 1}, false, paleGrey};
/// From the upper side of the body to the lower one.
inline const std::vector<FlightSurface> flank{{"side1", {7, 1}, false, grey},
                                              {"side2", {8, 1}, false, grey},
                                              {"side3", {9, 1}, false, paleGrey},
                                              {"side4", {10, 1}, false, paleGrey}};
inline const FlightSurface duct{"duct", {11, 4}, true, paleGrey};
inline const FlightSurface face{"face", {12, 5}, true, dark};
inline const FlightSurface cove{"cove", {13, 1}, true, dark};
inline const FlightSurface tail{"tail", {14, 1}, false, grey};

/// Steps of the engine bays' warmth towards the nozzles.
inline constexpr int baySteps = 24;
inline std::vector<FlightSurface> baysOf(std::int32_t first) {
    std::vector<FlightSurface> all;
    for (int i = 0; i < baySteps; ++i)
        all.push_back({"bay" + std::to_string(i + 1),
                       {first + i, i < baySteps - 7 ? 1 : 5},
                       false,
                       i < baySteps - 7 ? grey : darkGrey});
    return all;
}

/// The hot parts of an engine: with reheat they have other temperatures.
struct HotParts {
    std::vector<FlightSurface> bays;
    std::vector<FlightSurface> petals; ///< outside, from the nacelle to the exit
    FlightSurface lip, inside, liner, turbine, flameholder;
};
inline HotParts hotParts(std::int32_t first) {
    const auto metal = [&](const char* name, int number, bool twoSided, const Look& look) {
        return FlightSurface{name, {first + number, 5}, twoSided, look};
    };
    HotParts parts{baysOf(first),
                   {},
                   metal("lip", baySteps + 8, true, burnt),
                   metal("inside", baySteps + 9, true, hot),
                   metal("liner", baySteps + 10, true, hot),
                   metal("turbine", baySteps + 11, true, hot),
                   metal("holder", baySteps + 12, true, hot)};
    for (int i = 0; i < 8; ++i)
        parts.petals.push_back(
            metal(("petal" + std::to_string(i + 1)).c_str(), baySteps + i, true, burnt));
    return parts;
}

} // namespace smat::tern
