#include <algorithm>
#include <set>
#include <type_traits>

#include "irsg/signature/Findings.h"
#include "irsg/signature/LintEntries.h"

namespace irsg {

namespace {

Finding& missing(const std::string& entry, int faces, const std::string& model,
                 std::vector<Finding>& into) {
    Findings findings(into, entry);
    Finding& found = findings.error("", "no entry",
                                    "one for the " + std::to_string(faces) + " faces of " + model +
                                        " that carry this code");
    found.remedy = "add an entry, to be given its real values; or name a fallback in the project";
    return found;
}

template <typename Entry>
void lintMissing(const std::map<int, int>& faces, const std::optional<int>& fallback,
                 const std::map<int, Entry>& entries, const std::string& model,
                 std::map<int, Entry> SignatureDatabase::*table, std::string (*path)(int),
                 const std::string& kind, std::vector<Finding>& findings) {
    for (const auto& [index, count] : faces) {
        if (entries.contains(index) || (fallback && entries.contains(*fallback)))
            continue;
        missing(path(index), count, model, findings).repair = [index = index, table,
                                                               kind](SignatureDatabase& database) {
            Entry entry;
            entry.name = kind + std::to_string(index);
            if constexpr (std::is_same_v<Entry, TemperatureEntry>)
                entry.terms = TemperatureTerms::ofAmbient();
            entry.notes = "added by lint: black at ambient temperature, to be given its values";
            (database.*table).try_emplace(index, entry);
        };
    }
}

/// Entries that no face asks for. Index 0, the code of a face without one, is not missed.
template <typename Entry>
void lintUnused(const std::map<int, Entry>& entries, const std::set<int>& used,
                std::map<int, Entry> SignatureDatabase::*table, std::string (*path)(int),
                std::vector<Finding>& into) {
    for (const auto& [index, entry] : entries) {
        if (index == 0 || used.contains(index))
            continue;
        Findings findings(into, path(index));
        Finding& found =
            findings.warning("", "an entry that no face carries", "a face with its code");
        found.remedy = "delete the entry";
        found.removes = true;
        found.repair = [index = index, table](SignatureDatabase& database) {
            (database.*table).erase(index);
        };
    }
}

void lintUnusedSpectra(const SignatureDatabase& database, std::vector<Finding>& into) {
    for (const auto& [name, spectrum] : database.spectra) {
        const bool used = std::ranges::any_of(database.temperatures, [&](const auto& entry) {
            return entry.second.userSpectrum == name;
        });
        if (!used) {
            Findings findings(into, spectrumPath(name));
            Finding& found = findings.warning("", "a spectrum that no temperature names",
                                              "a temperature in the mode of user-defined spectra");
            found.remedy = "delete the spectrum";
            found.removes = true;
            found.repair = [name = name](SignatureDatabase& from) { from.spectra.erase(name); };
        }
    }
}

/// A gas has a temperature, so that its absorption is known.
void lintGasUse(const SignatureDatabase& database, const ModelUse& model,
                std::vector<Finding>& into) {
    for (const auto& [index, temperatures] : model.temperaturesOfMaterial) {
        const auto material = database.materials.find(index);
        if (material == database.materials.end() || !material->second.isGas())
            continue;
        for (const int temperature : temperatures) {
            const auto entry = database.temperatures.find(temperature);
            if (entry != database.temperatures.end() &&
                entry->second.mode == EmissionMode::userSpectrum) {
                Findings findings(into, materialPath(index));
                findings.error("",
                               "faces of temperature index " + std::to_string(temperature) +
                                   ", a user-defined spectrum",
                               "a gas with the temperature of eq. 7");
            }
        }
    }
}

} // namespace

void lintUse(const SignatureDatabase& database, const std::vector<ModelUse>& models,
             std::vector<Finding>& findings) {
    if (models.empty())
        return;
    std::set<int> temperatures;
    std::set<int> materials;
    for (const ModelUse& model : models) {
        lintMissing(model.temperatureFaces, model.fallbackTemperature, database.temperatures,
                    model.name, &SignatureDatabase::temperatures, temperaturePath, "temperature ",
                    findings);
        lintMissing(model.materialFaces, model.fallbackMaterial, database.materials, model.name,
                    &SignatureDatabase::materials, materialPath, "material ", findings);
        for (const auto& [index, faces] : model.temperatureFaces)
            temperatures.insert(index);
        for (const auto& [index, faces] : model.materialFaces)
            materials.insert(index);
        lintGasUse(database, model, findings);
        if (model.fallbackTemperature)
            temperatures.insert(*model.fallbackTemperature);
        if (model.fallbackMaterial)
            materials.insert(*model.fallbackMaterial);
        for (const std::string& remark : model.levelsOfDetail) {
            Findings ofModel(findings, "model");
            ofModel.warning(" " + model.name, remark, "a model without ranges of detail").remedy =
                "take the ranges out where the model is made; this program draws the highest "
                "detail at every range";
        }
        for (const std::string& shared : model.sharedPlanes) {
            Findings ofModel(findings, "model");
            ofModel.warning(" " + model.name, shared, "one face where there is one surface")
                .remedy =
                "give them one code, make one a subface of the other, or move it where the model "
                "is made";
        }
    }
    lintUnused(database.temperatures, temperatures, &SignatureDatabase::temperatures,
               temperaturePath, findings);
    lintUnused(database.materials, materials, &SignatureDatabase::materials, materialPath,
               findings);
    lintUnusedSpectra(database, findings);
}

} // namespace irsg
