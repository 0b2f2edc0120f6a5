#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "irsg/radiometry/Spectrum.h"
#include "irsg/signature/EntityState.h"
#include "irsg/signature/SignatureDatabase.h"

namespace irsg {

/// One thing a person should look at.
struct Finding {
    enum class Severity {
        warning, ///< possible, but not likely to be meant
        error    ///< physically wrong: such a database is neither loaded nor saved
    };
    /// Changes nothing where the entry it is about is gone.
    using Repair = std::function<void(SignatureDatabase&)>;

    Severity severity = Severity::error;
    std::string entry; ///< "materials.3" (EntryPath.h), "title", "notes", or "model"
    std::string place; ///< the entry and where in it: "materials.3.emissivity at 4.2 um"
    std::string value;
    std::string reason;   ///< "expected a value from 0 to 1", with why where that is not plain
    std::string remedy;   ///< what would repair it; may be empty
    Repair repair;        ///< does what `remedy` says; empty where a person has to choose
    bool removes = false; ///< `repair` deletes something: only a person may ask for it

    bool isError() const { return severity == Severity::error; }
};

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

/// Checks the physics of a database.
///
/// Errors: emissivity, transmissivity or their sum outside [0, 1] at a node of either, N below 0,
/// numbers that are not finite, names of spectra and components that do not exist, negative
/// factors, angles outside 0 to 180 degrees, loops over anything but time, 0 K or less, texts that
/// are not UTF-8; with a model, codes without an entry.
///
/// Warnings, the suspicion named: temperatures outside 200 to 4000 K at rest in air of 288.15 K and
/// outside 100 to 4000 K over the tables and the states given; degrees Celsius for K; percent for
/// fractions; nm or cm-1 for um; km for m of altitude; radians for degrees; m/s for Mach;
/// brightness temperatures outside 200 to 4000 K, with the unit that would repair them (W cm-2
/// against W m-2, per cm-1 against per um); curves that become a Planck curve only when the density
/// per cm-1 is told from that per um; loops that jump; spectra that do not cover the band; tables
/// that hold their end value in the states given; entries that nothing uses; levels of detail;
/// faces of different codes in one plane.
///
/// Findings come in the order of the database; equal databases give equal findings.
std::vector<Finding> lint(const SignatureDatabase& database, const LintScope& scope = {});
std::vector<Finding> lint(const SignatureDatabase& database, const SpectralRange& band);

/// Repairs what can be repaired without removing anything, and looks again until nothing is left to
/// repair. Returns the findings that were repaired, in order.
std::vector<Finding> repairAll(SignatureDatabase& database, const LintScope& scope = {});

} // namespace irsg
