#pragma once

#include <cstddef>
#include <vector>

#include "irsg/gas/GasVector.h"
#include "irsg/gas/PlumeField.h"
#include "irsg/gas/PlumeTable.h"
#include "irsg/gas/RoundJet.h"

namespace irsg {

/// A hot jet that wind bends and its own heat lifts.
struct BentJet {
    static constexpr double standardGravity_m_s2 = 9.80665;

    RoundJet nozzle;                            ///< its co-flow is not read
    GasVector place_m{};                        ///< of the nozzle
    GasVector along{};                          ///< unit vector of the gas there
    GasVector wind_m_s{};                       ///< which way the wind blows
    GasVector up{0, 0, 1};                      ///< unit vector
    double gravity_m_s2 = standardGravity_m_s2; ///< 0: heat lifts nothing

    /// The jet at a distance along its axis, as one state across it.
    struct Section {
        double along_m = 0.0;
        GasVector place_m, along; ///< of the axis, and the unit vector along which it goes on
        double part = 1.0;        ///< of exhaust, mean by mass
        double velocity_m_s = 0.0;

        /// The part of exhaust on the axis.
        double onAxis() const;
    };
    /// Sections a hundredth of the nozzle's diameter apart carry mass, momentum and heat on, and
    /// take in air by the greater of two laws (J. H. W. Lee and V. Cheung 1990, J. Environ. Eng.
    /// 116, 1085): at 0.1 of the velocity that they have beyond the wind along them, or as much
    /// wind as their projected area meets. The last one is where the axis has the part
    /// `nozzle.endsAt`. InputError for what RoundJet refuses, for a wind that turns the jet within
    /// its own width or stops it, and for a jet of more than 3000 diameters.
    std::vector<Section> sections() const;

    struct Flow {
        PlumeTable table; ///< over the distance along the axis
        std::vector<Section> sections;

        /// Place and direction of the axis, held beyond its ends.
        Section axisAt(double along_m) const;
    };
    /// Across a section is a bell whose axis has twice the mean part of exhaust, about a core of
    /// the nozzle's gas as long as that would be more than all, as wide as keeps its flow. Of gases
    /// the table has what the exhaust holds more than the air, at so many places along and across.
    Flow flow(std::size_t alongNodes = 48, std::size_t acrossNodes = 28) const;
};

/// Gas about a bent axis in space, along the axes of the jet's vectors: at each place that of the
/// section that goes through it, of several the hottest. Before the nozzle and behind the last
/// section is no gas. About so many nodes, whose planes lie closer where the jet is thin.
PlumeField bentJetField(const BentJet::Flow& flow, std::size_t nodes = 800000);

} // namespace irsg
