#include "irsg/signature/ScalingXml.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "irsg/core/Collect.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/karma/KarmaXml.h"
#include "irsg/signature/random/Philox.h"

namespace irsg {

namespace {

namespace fs = std::filesystem;

constexpr const char* emptyFile = R"(<?xml version="1.0" encoding="UTF-8" standalone="no" ?>
<data>
  <fileType>Parameters</fileType>
</data>
)";

std::optional<int> indexOf(const std::string& name) {
    int index = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), index);
    if (error != std::errc() || end != name.data() + name.size() || index < 0)
        return std::nullopt;
    return index;
}

/// Reads one parameter; what is wrong with it goes to `diagnostics`.
std::optional<ScalingEntry> entryOf(const KarmaXml& xml, const KarmaParameter& parameter,
                                    ScalingKind kind, std::vector<Diagnostic>& diagnostics) {
    const auto refuse = [&](std::string value, std::string expected) {
        diagnostics.push_back(xml.diagnostic(parameter, std::move(value), std::move(expected)));
    };
    const std::vector<double>& numbers = parameter.numbers;
    const bool isVector = parameter.kind == KarmaKind::vector3 ||
                          (parameter.kind == KarmaKind::vector && numbers.size() >= 3);
    if (!isVector) {
        refuse("a " + std::string(name(parameter.kind)) + " of " + std::to_string(numbers.size()) +
                   " numbers",
               "a vector3 of min, max and distribution");
        return std::nullopt;
    }
    const double number = numbers[2];
    if (!(number >= 0.0 && number < distributionKindCount && number == std::floor(number))) {
        refuse("distribution " + numberText(number),
               "a whole number from 0 to " + std::to_string(distributionKindCount - 1));
        return std::nullopt;
    }
    if (kind == ScalingKind::temperature && !(numbers[0] > 0.0))
        refuse("min " + numberText(numbers[0]), "a scale of temperatures above 0");
    if (kind == ScalingKind::emissivity && !(numbers[0] >= 0.0))
        refuse("min " + numberText(numbers[0]), "a scale of emissivities of at least 0");
    try {
        const auto which = static_cast<DistributionKind>(static_cast<int>(number));
        const std::vector<double> parameters(numbers.begin() + 3, numbers.end());
        return ScalingEntry{parameters.empty()
                                ? Distribution(which, numbers[0], numbers[1])
                                : Distribution(which, numbers[0], numbers[1], parameters),
                            parameter.documentation};
    } catch (const InputError& error) {
        for (const Diagnostic& diagnostic : error.diagnostics())
            refuse(diagnostic.value, diagnostic.expected);
        return std::nullopt;
    }
}

/// Writes a file that is not there yet; false where it is. Another program that makes it at the
/// same moment wins.
bool writtenIfAbsent(const fs::path& file, const std::string& text) {
    if (fs::exists(file))
        return false;
    try {
        FileReplacement replacement(file);
        replacement.write(text);
        replacement.commit(FileReplacement::Existing::refuse);
    } catch (const InputError&) {
        if (fs::exists(file))
            return false;
        throw;
    }
    return true;
}

} // namespace

fs::path scalingFile(const fs::path& model, ScalingKind kind) {
    const char* ending = kind == ScalingKind::temperature ? "(temperaturesScalings).xml"
                                                          : "(emissivitiesScalings).xml";
    return model.parent_path() / (model.stem().string() + ending);
}

bool hasScalingFiles(const fs::path& model) {
    return fs::exists(scalingFile(model, ScalingKind::temperature)) ||
           fs::exists(scalingFile(model, ScalingKind::emissivity));
}

Scalings loadScalings(const fs::path& model) {
    Scalings scalings;
    std::vector<Diagnostic> diagnostics;
    for (const ScalingKind kind : {ScalingKind::temperature, ScalingKind::emissivity}) {
        const fs::path file = scalingFile(model, kind);
        if (!fs::exists(file))
            continue;
        collect(diagnostics, [&] {
            (kind == ScalingKind::temperature ? scalings.temperatures : scalings.emissivities) =
                readScalingFile(file, kind);
        });
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    return scalings;
}

ScalingTable readScalingFile(const fs::path& file, ScalingKind kind) {
    const KarmaXml xml = KarmaXml::read(file);
    ScalingTable table;
    std::vector<Diagnostic> diagnostics;
    for (const KarmaParameter& parameter : xml.parameters()) {
        const auto index = indexOf(parameter.name);
        if (!index) {
            diagnostics.push_back(xml.diagnostic(parameter, "the name '" + parameter.name + "'",
                                                 "an index of the signature database"));
            continue;
        }
        if (auto entry = entryOf(xml, parameter, kind, diagnostics))
            if (!table.emplace(*index, std::move(*entry)).second)
                diagnostics.push_back(xml.diagnostic(
                    parameter, "index " + std::to_string(*index) + " again", "each index once"));
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    return table;
}

std::string scalingXml(const ScalingTable& table) {
    KarmaXml xml = KarmaXml::parse(emptyFile, "");
    for (const auto& [index, entry] : table) {
        const Distribution& d = entry.distribution;
        KarmaParameter parameter;
        parameter.name = std::to_string(index);
        parameter.kind = d.hasDefaultParameters() ? KarmaKind::vector3 : KarmaKind::vector;
        parameter.numbers = {d.minimum(), d.maximum(), static_cast<double>(d.kind())};
        if (parameter.kind == KarmaKind::vector)
            parameter.numbers.insert(parameter.numbers.end(), d.parameters().begin(),
                                     d.parameters().end());
        parameter.documentation = entry.documentation;
        xml.set(parameter);
    }
    return xml.text();
}

std::vector<fs::path> createScalingFiles(const fs::path& model, const SignatureDatabase& database) {
    ScalingTable temperatures, emissivities;
    for (const auto& [index, entry] : database.temperatures)
        temperatures[index].documentation =
            entry.name + (entry.mode == EmissionMode::userSpectrum
                              ? ": a user-defined spectrum, which no temperature scales"
                              : "");
    for (const auto& [index, material] : database.materials)
        emissivities[index].documentation = material.name;

    std::vector<fs::path> made;
    for (const auto& [kind, table] : {std::pair(ScalingKind::temperature, &temperatures),
                                      std::pair(ScalingKind::emissivity, &emissivities)}) {
        const fs::path file = scalingFile(model, kind);
        if (writtenIfAbsent(file, scalingXml(*table)))
            made.push_back(file);
    }
    return made;
}

std::map<int, double> sampledScales(const ScalingTable& table, ScalingKind kind, std::uint64_t seed,
                                    std::uint32_t owner, std::uint64_t draw) {
    std::map<int, double> scales;
    for (const auto& [index, entry] : table)
        scales[index] = entry.distribution.at(
            unitOf(seed, {static_cast<std::uint32_t>(kind), owner, index}, draw));
    return scales;
}

} // namespace irsg
