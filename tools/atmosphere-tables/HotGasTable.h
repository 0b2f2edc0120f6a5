#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace smat::tables {

/// A narrow-band table of one gas on its way to a file that irsg::NarrowBandTable reads.
struct HotGasTable {
    std::vector<double> wavenumbers_per_cm, temperatures_K;
    std::vector<std::vector<double>> k;               ///< [temperature][wavenumber], cm-1 atm-1
    std::vector<std::vector<double>> inverseSpacings; ///< likewise, cm

    /// All values 0.
    void resize();
    /// `head` names gas and law; `origin` are the other # lines. Throws InputError where the file
    /// cannot be written.
    void write(const std::filesystem::path& file, const std::string& head,
               const std::string& origin) const;
};

} // namespace smat::tables
