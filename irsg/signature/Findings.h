#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "irsg/core/Errors.h"
#include "irsg/signature/EntryPath.h"
#include "irsg/signature/Finding.h"

namespace irsg {

/// The findings about one entry, gathered while it is looked at. The finding returned is valid
/// until the next one is made; its repair is filled in there.
class Findings {
  public:
    Findings(std::vector<Finding>& into, std::string entry)
        : into_(into), entry_(std::move(entry)) {}

    const std::string& entry() const { return entry_; }

    /// `place` is that in the entry: ".emissivity", or empty for the entry itself.
    Finding& error(const std::string& place, std::string value, const std::string& expected) {
        return add(Finding::Severity::error, place, std::move(value), expected);
    }
    Finding& warning(const std::string& place, std::string value, const std::string& expected) {
        return add(Finding::Severity::warning, place, std::move(value), expected);
    }

  private:
    Finding& add(Finding::Severity severity, const std::string& place, std::string value,
                 const std::string& expected) {
        return into_.emplace_back(Finding{.severity = severity,
                                          .entry = entry_,
                                          .place = entry_ + place,
                                          .value = std::move(value),
                                          .reason = "expected " + expected,
                                          .remedy = "",
                                          .repair = {}});
    }

    std::vector<Finding>& into_;
    std::string entry_;
};

/// A number above 0 with three digits.
inline std::string rounded(double value) {
    const double scale = std::pow(10.0, 2.0 - std::floor(std::log10(value)));
    return numberText(std::round(value * scale) / scale);
}

/// Repairs of one entry, which do nothing where it is gone.
inline Finding::Repair onMaterial(int index, std::function<void(Material&)> change) {
    return [index, change = std::move(change)](SignatureDatabase& database) {
        if (const auto entry = database.materials.find(index); entry != database.materials.end())
            change(entry->second);
    };
}
inline Finding::Repair onTemperature(int index, std::function<void(TemperatureEntry&)> change) {
    return [index, change = std::move(change)](SignatureDatabase& database) {
        if (const auto entry = database.temperatures.find(index);
            entry != database.temperatures.end()) {
            change(entry->second);
        }
    };
}
inline Finding::Repair onSpectrum(const std::string& name,
                                  std::function<void(UserSpectrum&)> change) {
    return [name, change = std::move(change)](SignatureDatabase& database) {
        if (const auto entry = database.spectra.find(name); entry != database.spectra.end())
            change(entry->second);
    };
}

} // namespace irsg
