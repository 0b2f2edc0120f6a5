#include "irsg/signature/EntryJson.h"

#include "irsg/radiometry/Errors.h"
#include "irsg/signature/JsonText.h"

namespace irsg {

namespace {

using nlohmann::json;

void addTable(json& object, const char* key, const LookupTable& table) {
    if (table.empty()) {
        return;
    }
    json nodes = json::array();
    for (std::size_t i = 0; i < table.x().size(); ++i) {
        nodes.push_back({table.x()[i], table.y()[i]});
    }
    object[key] = {{"loop", table.loop()}, {"nodes", std::move(nodes)}};
}

json termsJson(const TemperatureTerms& terms) {
    json object = {{"base_K", terms.base_K},
                   {"ambientFactor", terms.ambientFactor},
                   {"recoveryFactor", terms.recoveryFactor},
                   {"ambientOffset_K", terms.ambientOffset_K}};
    addTable(object, "time_s", terms.time);
    addTable(object, "power", terms.power);
    addTable(object, "altitude_m", terms.altitude);
    addTable(object, "mach", terms.mach);
    return object;
}

json factorJson(const ComponentFactor& factor) {
    json object = {{"component", factor.component}, {"constant", factor.constant}};
    addTable(object, "time_s", factor.time);
    addTable(object, "angle_deg", factor.angle);
    return object;
}

json spectrumJson(const Spectrum& spectrum) {
    if (spectrum.isConstant()) {
        return spectrum.values().front();
    }
    json nodes = json::array();
    for (std::size_t i = 0; i < spectrum.size(); ++i) {
        nodes.push_back({spectrum.wavelengths_um()[i], spectrum.values()[i]});
    }
    return nodes;
}

} // namespace

json entryJson(const TemperatureEntry& entry) {
    const bool equation = entry.mode == EmissionMode::temperature;
    json object = {{"name", entry.name},
                   {"mode", equation ? "temperature" : "userSpectrum"},
                   {"terms", termsJson(entry.terms)},
                   {"userSpectrum", entry.userSpectrum},
                   {"notes", entry.notes}};
    for (const ComponentFactor& factor : entry.factors) {
        object["factors"].push_back(factorJson(factor));
    }
    return object;
}

json entryJson(const Material& material) {
    return {{"name", material.name},
            {"emissivity", spectrumJson(material.emissivity)},
            {"transmissivity", spectrumJson(material.transmissivity)},
            {"nAngleFactor", material.nAngleFactor},
            {"notes", material.notes}};
}

json entryJson(const UserSpectrum& spectrum) {
    json names = json::array();
    json rows = json::array();
    for (const SpectrumComponent& component : spectrum.components) {
        const auto& axis = component.radiance.wavelengths_um();
        if (axis != spectrum.components.front().radiance.wavelengths_um()) {
            throw LogicError("components of '" + spectrum.name + "' without one shared axis");
        }
        names.push_back(component.name);
        for (std::size_t i = 0; i < axis.size(); ++i) {
            if (rows.size() <= i) {
                rows.push_back({axis[i]});
            }
            rows[i].push_back(component.radiance.values()[i]);
        }
    }
    return {{"components", std::move(names)},
            {"radiance_W_m2_sr_um", std::move(rows)},
            {"referenceDistance_m", spectrum.referenceDistance_m},
            {"importedUnit", spectrum.importedUnit},
            {"notes", spectrum.notes}};
}

std::map<std::string, std::string> canonicalEntries(const SignatureDatabase& database) {
    std::map<std::string, std::string> texts = {{"title", compactJson(database.title)},
                                                {"notes", compactJson(database.notes)}};
    for (const auto& [index, entry] : database.temperatures) {
        texts[temperaturePath(index)] = compactJson(entryJson(entry));
    }
    for (const auto& [index, material] : database.materials) {
        texts[materialPath(index)] = compactJson(entryJson(material));
    }
    for (const auto& [name, spectrum] : database.spectra) {
        texts[spectrumPath(name)] = compactJson(entryJson(spectrum));
    }
    return texts;
}

} // namespace irsg
