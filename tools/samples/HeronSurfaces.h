#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tools/samples/FlightWriter.h"

/// What the parts of the aircraft are made of: samples/heron/README.md has the list.
namespace smat::heron {

inline constexpr Look grey{150, 158, 166}, darkGrey{104, 110, 118}, pale{196, 200, 202},
    black{38, 38, 40}, glassy{60, 84, 104}, metal{176, 170, 160}, burnt{112, 92, 78},
    gas{230, 190, 150, 0.8}, turning{104, 110, 118, 0.6};

inline const FlightSurface skin{"skin", {1, 1}, false, grey};
inline const FlightSurface boot{"boot", {2, 10}, false, black};
inline const FlightSurface pane{"pane", {3, 2}, false, glassy};
inline const FlightSurface cowl{"cowl", {4, 1}, false, grey};
/// Steps of the cowls' warmth, with temperatures from `first` on; the last `sooted` are sooted.
inline std::vector<FlightSurface> cowlSteps(const std::string& name, int count, std::int32_t first,
                                            int sooted) {
    std::vector<FlightSurface> all;
    for (int i = 0; i < count; ++i) {
        const bool clean = i < count - sooted;
        all.push_back({name + std::to_string(i + 1),
                       {first + i, clean ? 1 : 12},
                       false,
                       clean ? grey : darkGrey});
    }
    return all;
}
/// From the front cowls to the rear ones, and from those to the nozzle.
inline const std::vector<FlightSurface> middleCowl = cowlSteps("cowl", 18, 41, 6);
inline const std::vector<FlightSurface> endCowl = cowlSteps("end", 9, 61, 9);
inline const FlightSurface pipe{"pipe", {5, 4}, true, burnt};
/// Temperature and material of the outermost zone of a plume; zones within and the gas in the pipe
/// follow.
inline constexpr std::int32_t firstGas = 71;
inline const FlightSurface disc{"disc", {9, 9}, true, turning};
inline const FlightSurface turbine{"turbine", {10, 4}, true, burnt};
inline const FlightSurface lip{"lip", {11, 4}, true, burnt};
inline const FlightSurface rearCowl{"rearcwl", {12, 12}, false, darkGrey};
inline const FlightSurface belly{"belly", {13, 1}, false, pale};
/// From the upper side of the body to the lower one.
inline const std::array<FlightSurface, 4> flank{{{"side1", {28, 1}, false, grey},
                                                 {"side2", {29, 1}, false, grey},
                                                 {"side3", {30, 1}, false, pale},
                                                 {"side4", {31, 1}, false, pale}}};
inline const FlightSurface tank{"tank", {14, 1}, false, grey};
inline const FlightSurface tankTop{"tanktop", {32, 1}, false, grey};
inline const FlightSurface spinner{"spinner", {15, 3}, false, metal};
inline const FlightSurface intake{"intake", {15, 1}, true, darkGrey};
inline const FlightSurface radome{"radome", {17, 11}, false, pale};
inline const FlightSurface window{"window", {18, 2}, false, glassy};
inline const FlightSurface turret{"turret", {19, 13}, false, black};
inline const FlightSurface tail{"tail", {20, 1}, false, grey};
inline const FlightSurface cove{"cove", {21, 1}, true, darkGrey};
inline const FlightSurface bareMetal{"bare", {1, 3}, false, metal};

} // namespace smat::heron
