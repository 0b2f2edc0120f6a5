#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "irsg/gas/FieldWalls.h"
#include "irsg/gas/GasByTemperature.h"
#include "irsg/gas/PlumeBand.h"
#include "irsg/gas/PlumeField.h"
#include "irsg/gas/PlumeTable.h"

namespace irsg {

/// Uniform gas from a temperature on: the gas within a surface of FieldWalls, but for that of the
/// next zone.
struct FieldZone {
    GasLayer gas;
    double from_K = 0.0;
};

/// So many zones between temperatures that part emission and absorption of a field evenly, the
/// outermost first, each of the mean of its gas.
std::vector<FieldZone> fieldZones(const GasByTemperature& gas, std::size_t count);

/// A direction from which a plume is seen.
struct PlumeView {
    std::string name;
    GasVector towards{}; ///< unit vector towards the sensor, along the axes of the field
};
/// "side", "quarter", "tail" as of a table, and "above" and "high quarter", of a plume whose first
/// axis goes downstream and whose third one goes up.
std::vector<PlumeView> plumeViews();

/// Radiant intensity of a field in a band, along parallel lines of sight from several sides. Each
/// goes on from plane to plane of the grid; gas of nearly one state is summed as one.
class FieldIntensities {
  public:
    /// `fineness` times as many lines each way.
    FieldIntensities(const PlumeField& field, FieldWalls walls, const PlumeBand& band,
                     const std::vector<PlumeView>& views, int fineness = 1);
    /// Of zones that end at surfaces of the walls.
    std::vector<PlumeZonesError> errorsOf(const std::vector<FieldZone>& zones) const;
    const FieldWalls& walls() const { return walls_; }

  private:
    /// A line of sight through a place, and the area for which it stands.
    struct Sight {
        GasVector through_m{};
        double area_m2 = 0.0;
        /// Temperatures of the walls between which they are linear, those nearest the sensor first.
        struct Look {
            float at_m = 0.0F, at_K = 0.0F;
        };
        std::vector<Look> looks;
    };
    struct View {
        PlumeView of;
        std::vector<Sight> sights;
        double intensity_W_sr = 0.0;
    };
    void sumField(const PlumeField& field, View& view) const;
    void lookAtWalls(View& view) const;

    FieldWalls walls_;
    PlumeBand band_;
    std::vector<View> views_;
};

} // namespace irsg
