#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "irsg/signature/Distribution.h"
#include "irsg/signature/SignatureDatabase.h"

namespace irsg {

/// What a scaling multiplies (report section 11).
enum class ScalingKind {
    temperature, ///< the temperature in K of one index; user-defined spectra have none
    emissivity   ///< the emission of one material; see ApparentRadiance.h for what reflection does
};

/// Scale of one index of a database.
struct ScalingEntry {
    Distribution distribution;
    std::string documentation;
    bool operator==(const ScalingEntry&) const = default;
};
using ScalingTable = std::map<int, ScalingEntry>;

/// What stands beside a model in its two scaling files.
struct Scalings {
    ScalingTable temperatures, emissivities;

    const ScalingTable& of(ScalingKind kind) const {
        return kind == ScalingKind::temperature ? temperatures : emissivities;
    }
    bool empty() const { return temperatures.empty() && emissivities.empty(); }
    bool operator==(const Scalings&) const = default;
};

/// "ship(temperaturesScalings).xml" or "ship(emissivitiesScalings).xml" beside ship.flt.
std::filesystem::path scalingFile(const std::filesystem::path& model, ScalingKind kind);
/// True where at least one of the two is there.
bool hasScalingFiles(const std::filesystem::path& model);

/// Both files beside a model; one that is not there scales nothing. Throws InputError with the
/// diagnostics of both.
Scalings loadScalings(const std::filesystem::path& model);
/// Reads a parameter file whose parameters are named after indices. A `vector3` holds min, max and
/// number of the distribution; a `vector` may hold the parameters of the distribution behind them
/// (this program's own addition). Throws InputError naming every diagnostic with its line: names
/// that are no indices, numbers that no distribution can have, temperature scales that are not
/// above 0, emissivity scales below 0.
ScalingTable readScalingFile(const std::filesystem::path& file, ScalingKind kind);
/// The file of a table. A distribution with parameters of its own becomes a `vector`.
std::string scalingXml(const ScalingTable& table);

/// Writes the two files of a model with scales of 1 for every entry of the database, each only
/// where it is not there: what somebody wrote is never touched. Returns the files that it made.
/// Throws InputError where one cannot be written.
std::vector<std::filesystem::path> createScalingFiles(const std::filesystem::path& model,
                                                      const SignatureDatabase& database);

/// The scales of draw number `draw` for the entity number `owner` of a scene, by index. Every index
/// of either kind has a random sequence of its own: adding one changes no other's draws.
std::map<int, double> sampledScales(const ScalingTable& table, ScalingKind kind, std::uint64_t seed,
                                    std::uint32_t owner, std::uint64_t draw);

} // namespace irsg
