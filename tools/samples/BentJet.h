#pragma once

#include <filesystem>

#include "irsg/gas/RoundJet.h"
#include "tools/samples/GasZones.h"

namespace smat {

/// A hot jet that wind bends and its own heat lifts.
struct BentJet {
    irsg::RoundJet nozzle; ///< its co-flow is not read
    irsg::Vec3 place;      ///< of the nozzle, m; z up
    irsg::Vec3 along;      ///< unit vector of the gas there
    irsg::Vec3 wind_m_s;   ///< across `along`, in part at least

    struct Flow {
        irsg::PlumeTable table; ///< over the distance along the axis
        PlumeAxis axis;
        irsg::Vec3 across; ///< normal to the plane in which it bends
    };
    /// Sections of one state each carry mass, momentum and heat on, and take in air by the greater
    /// of two laws (J. H. W. Lee and V. Cheung 1990, J. Environ. Eng. 116, 1085): at 0.1 of the
    /// velocity that they have beyond the wind along them, or as much wind as their projected area
    /// meets. Across a section is a bell whose axis has twice the mean part of exhaust, about a
    /// core of the nozzle's gas as long as that would be more than all, as wide as keeps its flow.
    /// The table ends where the axis has the part `nozzle.endsAt`; of gases it has what the exhaust
    /// holds more than the air.
    Flow flow() const;
};

/// Writes a table as `smat-batch plume` reads it.
void savePlumeTable(const irsg::PlumeTable& table, const std::filesystem::path& file);

} // namespace smat
