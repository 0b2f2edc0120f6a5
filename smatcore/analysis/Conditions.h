#pragma once

#include <string>
#include <vector>

#include "smatcore/analysis/AnalysisData.h"

namespace smat {

/// One of the conditions that a result holds under, as titles say it.
struct Condition {
    std::string key;  ///< of its setting: "camera.range"
    std::string text; ///< "range 900 m"

    bool operator==(const Condition&) const = default;
};

/// Band, range, aspect, altitude, air and time of a view with these settings.
std::vector<Condition> conditionsOf(const Settings& settings);
/// The same of a result, by its provenance, so that one that was opened from a file has them, too;
/// of a search for ranges its sensor and criterion in place of band and range.
/// What it varies is left out; a result without provenance has none, one of a tool that asks the
/// air alone (radiative output, temperature profile) that air.
std::vector<Condition> conditionsOf(const ResultTable& table);
/// The same of an image, by its attributes, where an analysis wrote it.
std::vector<Condition> conditionsOf(const irsg::RadianceImage& image);
/// The conditions that all results share: what differs is what tells them apart.
std::vector<Condition> sharedConditions(const std::vector<const ResultTable*>& results);
/// "3-5 µm · range 900 m · azimuth 60° · elevation 12° · altitude 1500 m · vacuum · time 0 s".
std::string lineOf(const std::vector<Condition>& conditions);

/// The settings of a result as its provenance tells them, defaults where it tells nothing; values
/// of other programs, which are none here, are left out.
Settings settingsOf(const ResultTable& table);

/// What tells each of several results apart from the others: "8-12 µm" and "3-5 µm", "ε 0.9" and
/// "ε 0.3" where entries of their signature databases differ. Empty texts where nothing that is
/// known differs, and of results of several kinds.
std::vector<std::string> distinguishingNames(const std::vector<const AnalysisData*>& results);

} // namespace smat
