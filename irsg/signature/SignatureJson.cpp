#include <charconv>
#include <optional>
#include <string>

#include "irsg/signature/EntryJson.h"
#include "irsg/signature/JsonReader.h"
#include "irsg/signature/JsonText.h"
#include "irsg/signature/LintErrors.h"
#include "irsg/signature/MaterialCsv.h"
#include "irsg/signature/SignatureFile.h"

namespace irsg {

namespace {

using nlohmann::json;

constexpr const char* formatName = "smat-signature";

TemperatureTerms readTerms(const json& value, const std::string& path, JsonProblems& problems) {
    JsonObject object(value, path, problems);
    TemperatureTerms terms;
    terms.base_K = object.number("base_K", terms.base_K, true);
    terms.ambientFactor = object.number("ambientFactor", terms.ambientFactor, true);
    terms.recoveryFactor = object.number("recoveryFactor", terms.recoveryFactor);
    terms.ambientOffset_K = object.number("ambientOffset_K", terms.ambientOffset_K);
    terms.time = object.table("time_s");
    terms.power = object.table("power");
    terms.altitude = object.table("altitude_m");
    terms.mach = object.table("mach");
    object.finish();
    return terms;
}

ComponentFactors readFactors(const json& value, const std::string& path, JsonProblems& problems) {
    if (!value.is_array()) {
        problems.add(path, value, "a list [...] of component factors");
        return {};
    }
    ComponentFactors factors;
    for (std::size_t i = 0; i < value.size(); ++i) {
        JsonObject object(value[i], path + "[" + std::to_string(i) + "]", problems);
        ComponentFactor& factor = factors.emplace_back();
        factor.component = object.text("component", true);
        factor.constant = object.number("constant", factor.constant);
        factor.time = object.table("time_s");
        factor.angle = object.table("angle_deg");
        object.finish();
    }
    return factors;
}

TemperatureEntry readTemperature(const json& value, const std::string& path,
                                 JsonProblems& problems) {
    JsonObject object(value, path, problems);
    TemperatureEntry entry;
    entry.name = object.text("name", true);
    entry.notes = object.text("notes");
    entry.userSpectrum = object.text("userSpectrum");
    const std::string mode = object.text("mode", true);
    if (mode == "userSpectrum") {
        entry.mode = EmissionMode::userSpectrum;
    } else if (!mode.empty() && mode != "temperature") {
        problems.addText(object.pathOf("mode"), "'" + mode + "'",
                         "'temperature' or 'userSpectrum'");
    }
    const bool needsTerms = entry.mode == EmissionMode::temperature;
    if (const json* const terms = object.find("terms", needsTerms)) {
        entry.terms = readTerms(*terms, object.pathOf("terms"), problems);
    }
    if (const json* const factors = object.find("factors")) {
        entry.factors = readFactors(*factors, object.pathOf("factors"), problems);
    }
    object.finish();
    return entry;
}

/// A stated reflectivity is checked, not kept: it follows from the other two.
void checkReflectivity(const Material& material, const Spectrum& reflectivity,
                       const std::string& path, JsonProblems& problems) {
    std::vector<double> nodes_um = {1.0};
    for (const Spectrum* const each :
         {&material.emissivity, &material.transmissivity, &reflectivity}) {
        nodes_um.insert(nodes_um.end(), each->wavelengths_um().begin(),
                        each->wavelengths_um().end());
    }
    for (const double node_um : nodes_um) {
        const double derived = material.reflectivityAt(node_um);
        if (std::abs(reflectivity.at(node_um) - derived) > closureTolerance) {
            problems.addText(path + " at " + numberText(node_um) + " um",
                             numberText(reflectivity.at(node_um)),
                             "1 - emissivity - transmissivity = " + numberText(derived));
            return;
        }
    }
}

Material readMaterial(const json& value, const std::string& path, JsonProblems& problems) {
    JsonObject object(value, path, problems);
    Material material;
    material.name = object.text("name", true);
    material.notes = object.text("notes");
    material.emissivity = object.spectrum("emissivity", 1.0, true);
    material.transmissivity = object.spectrum("transmissivity", 0.0);
    material.nAngleFactor = object.number("nAngleFactor", material.nAngleFactor);
    if (object.find("reflectivity") != nullptr) {
        checkReflectivity(material, object.spectrum("reflectivity", 0.0),
                          object.pathOf("reflectivity"), problems);
    }
    object.finish();
    return material;
}

UserSpectrum readSpectrum(const json& value, const std::string& name, const std::string& path,
                          JsonProblems& problems) {
    JsonObject object(value, path, problems);
    UserSpectrum spectrum;
    spectrum.name = name;
    spectrum.referenceDistance_m = object.number("referenceDistance_m", 0.0);
    spectrum.importedUnit = object.text("importedUnit");
    spectrum.notes = object.text("notes");

    const json* const names = object.find("components", true);
    std::vector<std::string> components;
    if (names != nullptr && names->is_array()) {
        for (std::size_t i = 0; i < names->size(); ++i) {
            if ((*names)[i].is_string()) {
                components.push_back((*names)[i].get<std::string>());
            } else {
                problems.add(object.pathOf("components") + "[" + std::to_string(i) + "]",
                             (*names)[i], "text in quotes");
            }
        }
    } else if (names != nullptr) {
        problems.add(object.pathOf("components"), *names, "a list [...] of component names");
    }

    // The axis is checked once, by the first component.
    const auto columns = object.columns("radiance_W_m2_sr_um", components.size() + 1);
    object.finish();
    if (!columns) {
        return spectrum;
    }
    try {
        for (std::size_t i = 0; i < components.size(); ++i) {
            spectrum.components.push_back(
                {components[i], {(*columns)[0], (*columns)[i + 1], Spectrum::Outside::zero}});
        }
    } catch (const InputError& error) {
        problems.add(object.pathOf("radiance_W_m2_sr_um"), error);
    }
    return spectrum;
}

std::optional<int> indexOf(const std::string& key) {
    int index = 0;
    const char* const end = key.data() + key.size();
    const auto result = std::from_chars(key.data(), end, index);
    const bool whole = result.ec == std::errc{} && result.ptr == end;
    return whole && std::to_string(index) == key ? std::optional(index) : std::nullopt;
}

template <typename Entry, typename Read>
void readIndexed(JsonObject& root, const std::string& key, std::map<int, Entry>& into,
                 JsonProblems& problems, Read read) {
    const json* const entries = root.find(key, true);
    if (entries == nullptr) {
        return;
    }
    if (!entries->is_object()) {
        problems.add(key, *entries, "an object {...} of entries by index");
        return;
    }
    for (const auto& item : entries->items()) {
        const std::string path = key + "." + item.key();
        if (const auto index = indexOf(item.key())) {
            into[*index] = read(item.value(), path, problems);
        } else {
            problems.addText(path, "'" + item.key() + "'", "a whole number of 32 bits as index");
        }
    }
}

} // namespace

std::string signatureToJson(const SignatureDatabase& database) {
    throwOnLintErrors(database, database.title.empty() ? "signature database" : database.title);
    return draftToJson(database);
}

std::string draftToJson(const SignatureDatabase& database) {
    json root = {{"format", formatName},           {"version", signatureFileVersion},
                 {"title", database.title},        {"notes", database.notes},
                 {"temperatures", json::object()}, {"materials", json::object()},
                 {"spectra", json::object()}};
    for (const auto& [index, entry] : database.temperatures) {
        root["temperatures"][std::to_string(index)] = entryJson(entry);
    }
    for (const auto& [index, material] : database.materials) {
        root["materials"][std::to_string(index)] = entryJson(material);
    }
    for (const auto& [name, spectrum] : database.spectra) {
        root["spectra"][name] = entryJson(spectrum);
    }
    return prettyJson(root) + "\n";
}

SignatureDatabase signatureFromJson(const std::string& text, const std::string& fileName,
                                    LintErrors errors) {
    const json parsed = parseJson(text, fileName);
    JsonProblems problems(fileName);
    JsonObject root(parsed, "", problems);

    const std::string format = root.text("format", true);
    if (!format.empty() && format != formatName) {
        problems.addText("format", "'" + format + "'", std::string("'") + formatName + "'");
    }
    const double version = root.number("version", signatureFileVersion, true);
    if (version != signatureFileVersion) {
        problems.addText("version", numberText(version), std::to_string(signatureFileVersion));
    }

    SignatureDatabase database;
    database.title = root.text("title");
    database.notes = root.text("notes");
    readIndexed(root, "temperatures", database.temperatures, problems, readTemperature);
    readIndexed(root, "materials", database.materials, problems, readMaterial);
    if (const json* const spectra = root.find("spectra")) {
        if (!spectra->is_object()) {
            problems.add("spectra", *spectra, "an object {...} of spectra by name");
        } else {
            for (const auto& item : spectra->items()) {
                database.spectra[item.key()] =
                    readSpectrum(item.value(), item.key(), spectrumPath(item.key()), problems);
            }
        }
    }
    root.finish();
    problems.throwIfAny();
    if (errors == LintErrors::refuse) {
        throwOnLintErrors(database, fileName);
    }
    return database;
}

} // namespace irsg
