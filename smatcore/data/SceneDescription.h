#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "irsg/scene/Scene.h"
#include "smatcore/data/StateOverride.h"

namespace smat {

/// A scene as it was loaded: checked, in radians, the first entity the target; with its sensor and
/// what results say of where it comes from.
struct SceneDescription : irsg::Scene {
    /// Of no air yet.
    SceneDescription() { environment = irsg::Environment(); }

    irsg::Sensor sensor;               ///< with the first of its bands
    std::vector<irsg::Band> moreBands; ///< of the sensor, in order, behind that one
    /// Entities whose database holds edits that its file does not.
    std::set<std::size_t> unsavedDatabases;
    std::vector<std::string> remarks; ///< what loading had to say, each said once
    /// What entities do by themselves, in their states already; empty: all do the same.
    std::vector<StateOverride> own;
    /// What was drawn of scaling files: "temperature 5 (exhaust): 1.03, uniform, 0.9 to 1.1".
    std::vector<std::string> sampledScales;

    StateOverride ownOf(std::size_t entity) const {
        return entity < own.size() ? own[entity] : StateOverride();
    }
    std::vector<irsg::Band> allBands() const {
        std::vector<irsg::Band> all{sensor.band};
        all.insert(all.end(), moreBands.begin(), moreBands.end());
        return all;
    }
    /// At least one.
    void setBands(const std::vector<irsg::Band>& bands) {
        sensor.band = bands.at(0);
        moreBands.assign(bands.begin() + 1, bands.end());
    }
};

} // namespace smat
