#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "irsg/radiometry/Spectrum.h"
#include "irsg/signature/EntityState.h"

namespace irsg {

/// What one model asks of its database.
struct ModelUse {
    std::string name;                    ///< the model's file, for messages
    std::map<int, int> temperatureFaces; ///< faces that carry each temperature index
    std::map<int, int> materialFaces;
    std::map<int, std::set<int>> temperaturesOfMaterial = {}; ///< that its faces carry
    std::optional<int> fallbackTemperature = {}; ///< entries that stand in for codes without one
    std::optional<int> fallbackMaterial = {};
    /// What the loader had to do about levels of detail: a range of a level that ends before the
    /// sensor empties the picture in programs that obey it.
    std::vector<std::string> levelsOfDetail = {};
    /// Faces of different codes in one plane, of which the order in the file decides.
    std::vector<std::string> sharedPlanes = {};
};

/// A state that the entity of the database takes in an analysis.
struct SweptState {
    std::string analysis; ///< its name, for messages
    EntityState state;
};

/// What a database is checked against, beside itself.
struct LintScope {
    std::vector<SpectralRange> bands = {}; ///< that spectra should cover
    std::vector<ModelUse> models = {};
    std::vector<SweptState> states = {};
};

} // namespace irsg
