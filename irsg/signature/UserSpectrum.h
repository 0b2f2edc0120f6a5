#pragma once

#include <string>
#include <vector>

#include "irsg/radiometry/Spectrum.h"

namespace irsg {

/// One measured or modelled component of an imported spectrum, L_j of eq. 6.
struct SpectrumComponent {
    std::string name;  ///< "CO2(T4)"
    Spectrum radiance; ///< W m-2 sr-1 um-1 over um, zero outside its axis

    bool operator==(const SpectrumComponent&) const = default;
};

/// A user-defined spectrum: components on one shared axis, as imported (report table 18).
struct UserSpectrum {
    std::string name;
    /// The air between the source and this distance is inside the measurement already, m.
    double referenceDistance_m = 0.0;
    /// The unit of the file it came from, kept to be shown: "W cm-2 sr-1 (cm-1)-1".
    std::string importedUnit;
    std::string notes;
    std::vector<SpectrumComponent> components;
    /// What all components are multiplied with: the correction of a measurement whose curves stay
    /// as they were imported.
    double calibrationFactor = 1.0;

    const SpectrumComponent* find(const std::string& component) const;
    bool operator==(const UserSpectrum&) const = default;
};

} // namespace irsg
