#include "irsg/signature/EntryJson.h"

#include "irsg/core/Errors.h"
#include "irsg/signature/CanonicalJson.h"
#include "irsg/signature/EntryFields.h"

namespace irsg {

namespace {

using nlohmann::json;

void addTable(json& object, const char* key, const LookupTable& table) {
    if (table.empty())
        return;
    json nodes = json::array();
    for (std::size_t i = 0; i < table.x().size(); ++i)
        nodes.push_back({table.x()[i], table.y()[i]});
    object[key] = {{"loop", table.loop()}, {"nodes", std::move(nodes)}};
}

json spectrumJson(const Spectrum& spectrum) {
    if (spectrum.isConstant())
        return spectrum.values().front();
    json nodes = json::array();
    for (std::size_t i = 0; i < spectrum.size(); ++i)
        nodes.push_back({spectrum.wavelengths_um()[i], spectrum.values()[i]});
    return nodes;
}

template <typename Entry>
json fieldsJson(const Entry& entry, std::span<const EntryField<Entry>> fields);

void add(json& object, const char* key, const std::string& text) {
    object[key] = text;
}
void add(json& object, const char* key, double number) {
    object[key] = number;
}
template <typename Choice>
    requires std::is_enum_v<Choice>
void add(json& object, const char* key, Choice choice) {
    object[key] = nameOf(choice);
}
void add(json& object, const char* key, const Spectrum& spectrum) {
    object[key] = spectrumJson(spectrum);
}
void add(json& object, const char* key, const LookupTable& table) {
    addTable(object, key, table);
}
void add(json& object, const char* key, const TemperatureTerms& terms) {
    object[key] = fieldsJson(terms, termFields());
}
/// Rows of directions, each with a value a wavelength.
void add(json& object, const char* key, const ReflectanceTable& table) {
    json nodes = json::array();
    for (const ReflectanceTable::Row& row : table.rows()) {
        json one = {row.incidence_deg};
        if (table.isBrdf()) {
            one.push_back(row.reflection_deg);
            one.push_back(row.azimuth_deg);
        }
        for (const double value : row.values)
            one.push_back(value);
        nodes.push_back(std::move(one));
    }
    object[key] = {{"kind", table.isBrdf() ? "brdf" : "directionalHemispherical"},
                   {"wavelengths_um", table.wavelengths_um()},
                   {"nodes", std::move(nodes)}};
}
void add(json& object, const char* key, const ComponentFactors& factors) {
    for (const ComponentFactor& factor : factors)
        object[key].push_back(fieldsJson(factor, geometryBuffers()));
}

template <typename Entry>
json fieldsJson(const Entry& entry, std::span<const EntryField<Entry>> fields) {
    json object = json::object();
    for (const EntryField<Entry>& field : fields)
        if (field.since == 1 || field.saysSomething(entry))
            std::visit([&](auto member) { add(object, field.key, entry.*member); }, field.member);
    return object;
}

} // namespace

json entryJson(const TemperatureEntry& entry) {
    return fieldsJson(entry, temperatureFields());
}

json entryJson(const Material& material) {
    return fieldsJson(material, materialFields());
}

json entryJson(const UserSpectrum& spectrum) {
    json names = json::array();
    json rows = json::array();
    for (const SpectrumComponent& component : spectrum.components) {
        const auto& axis = component.radiance.wavelengths_um();
        if (axis != spectrum.components.front().radiance.wavelengths_um())
            throw LogicError("components of '" + spectrum.name + "' without one shared axis");
        names.push_back(component.name);
        for (std::size_t i = 0; i < axis.size(); ++i) {
            if (rows.size() <= i)
                rows.push_back({axis[i]});
            rows[i].push_back(component.radiance.values()[i]);
        }
    }
    json object = fieldsJson(spectrum, spectrumFields());
    object["components"] = std::move(names);
    object["radiance_W_m2_sr_um"] = std::move(rows);
    return object;
}

std::map<std::string, std::string> canonicalEntries(const SignatureDatabase& database) {
    std::map<std::string, std::string> texts = {{"title", compactJson(database.title)},
                                                {"notes", compactJson(database.notes)}};
    for (const auto& [index, entry] : database.temperatures)
        texts[temperaturePath(index)] = compactJson(entryJson(entry));
    for (const auto& [index, material] : database.materials)
        texts[materialPath(index)] = compactJson(entryJson(material));
    for (const auto& [name, spectrum] : database.spectra)
        texts[spectrumPath(name)] = compactJson(entryJson(spectrum));
    return texts;
}

} // namespace irsg
