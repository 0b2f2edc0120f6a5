#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

#include "irsg/core/JsonReader.h"
#include "irsg/core/ProgramVersion.h"
#include "irsg/signature/CanonicalJson.h"
#include "irsg/signature/EntryFields.h"
#include "irsg/signature/EntryJson.h"
#include "irsg/signature/LintErrors.h"
#include "irsg/signature/MaterialCsv.h"
#include "irsg/signature/SignatureFile.h"

namespace irsg {

namespace {

constexpr const char* formatName = "smat-signature";
const JsonForm jsonForm = {
    .expected = "a signature database (JSON in UTF-8)", .deepest = 16, .indexInBrackets = true};

template <typename Entry>
void readFields(Entry& entry, std::span<const EntryField<Entry>> fields, const JsonReader& object);

LookupTable readTable(const JsonReader& json) {
    LookupTable table;
    const bool loop = json.at("loop").booleanOr(false);
    const JsonReader nodes = json.at("nodes");
    if (const auto columns = nodes.columns(2))
        nodes.check([&] { table = {(*columns)[0], (*columns)[1], loop}; });
    json.refuseUnknown();
    return table;
}

/// A number, or rows of wavelength and value.
Spectrum readSpectrum(const JsonReader& json, double otherwise) {
    Spectrum spectrum = Spectrum::constant(otherwise);
    if (json.json().is_number())
        return Spectrum::constant(json.number());
    if (!json.json().is_array())
        json.refuse("a number, or rows of wavelength in um and value");
    else if (const auto nodes = json.columns(2))
        json.check([&] { spectrum = {(*nodes)[0], (*nodes)[1]}; });
    return spectrum;
}

/// Rows of directions, each with a value a wavelength.
ReflectanceTable readReflectance(const JsonReader& json) {
    ReflectanceTable table;
    const bool isBrdf = json.at("kind").word({"directionalHemispherical", "brdf"}) == 1;
    std::vector<double> wavelengths_um =
        json.at("wavelengths_um").numbers("a list of wavelengths in um");
    const std::size_t angles = isBrdf ? 3 : 1;
    const auto columns = json.at("nodes").columns(angles + wavelengths_um.size());
    json.refuseUnknown();
    const auto isRefused = [](double number) { return std::isnan(number); };
    if (!columns || wavelengths_um.empty() || std::ranges::any_of(wavelengths_um, isRefused))
        return table;
    std::vector<ReflectanceTable::Row> rows((*columns)[0].size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].incidence_deg = (*columns)[0][i];
        if (isBrdf) {
            rows[i].reflection_deg = (*columns)[1][i];
            rows[i].azimuth_deg = (*columns)[2][i];
        }
        for (std::size_t w = 0; w < wavelengths_um.size(); ++w)
            rows[i].values.push_back((*columns)[angles + w][i]);
    }
    json.check(
        [&] { table = ReflectanceTable(isBrdf, std::move(wavelengths_um), std::move(rows)); });
    return table;
}

/// One field of an entry. A field that may be missing stays as it is then.
class FieldReader {
  public:
    FieldReader(const JsonReader& json, bool isRequired) : json_(json), isRequired_(isRequired) {}

    void into(std::string& text) const { text = isRequired_ ? json_.text() : json_.textOr(""); }
    void into(double& number) const {
        number = isRequired_ ? json_.number() : json_.numberOr(number);
    }
    void into(LookupTable& table) const {
        if (json_.exists())
            table = readTable(json_);
    }
    void into(Spectrum& spectrum) const {
        if (isAsked())
            spectrum = readSpectrum(json_, spectrum.values().front());
    }
    template <typename Choice>
        requires std::is_enum_v<Choice>
    void into(Choice& choice) const {
        std::string name;
        into(name);
        if (const auto known = choiceNamed<Choice>(name))
            choice = *known;
        else if (!name.empty())
            json_.refuse(choicesExpected<Choice>());
    }
    void into(TemperatureTerms& terms) const {
        if (isAsked())
            readWhole(json_, terms, termFields());
    }
    void into(ReflectanceTable& table) const {
        if (isAsked())
            table = readReflectance(json_);
    }
    void into(ComponentFactors& factors) const {
        if (isAsked())
            for (const JsonReader& one : json_.list("a list of component factors"))
                readWhole(one, factors.emplace_back(), geometryBuffers());
    }

  private:
    bool isAsked() const { return isRequired_ || json_.exists(); }
    template <typename Entry>
    static void readWhole(const JsonReader& json, Entry& entry,
                          std::span<const EntryField<Entry>> fields) {
        readFields(entry, fields, json);
        json.refuseUnknown();
    }

    const JsonReader& json_;
    bool isRequired_;
};

template <typename Entry>
void readFields(Entry& entry, std::span<const EntryField<Entry>> fields, const JsonReader& object) {
    for (const EntryField<Entry>& field : fields) {
        const JsonReader json = object.at(field.key);
        const FieldReader reader(json, field.isRequired != nullptr && field.isRequired(entry));
        std::visit([&](auto member) { reader.into(entry.*member); }, field.member);
    }
}

TemperatureEntry readTemperature(const JsonReader& json) {
    TemperatureEntry entry;
    readFields(entry, temperatureFields(), json);
    json.refuseUnknown();
    return entry;
}

/// A stated reflectivity is checked, not kept: it follows from the other two.
void checkReflectivity(const Material& material, const JsonReader& json) {
    const Spectrum reflectivity = readSpectrum(json, 0.0);
    std::vector<double> nodes_um = {1.0};
    for (const Spectrum* const each :
         {&material.emissivity, &material.transmissivity, &reflectivity}) {
        nodes_um.insert(nodes_um.end(), each->wavelengths_um().begin(),
                        each->wavelengths_um().end());
    }
    for (const double node_um : nodes_um) {
        const double derived = material.reflectivityAt(node_um);
        if (std::abs(reflectivity.at(node_um) - derived) > closureTolerance) {
            json.refuse(numberText(reflectivity.at(node_um)),
                        "1 - emissivity - transmissivity = " + numberText(derived),
                        " at " + numberText(node_um) + " um");
            return;
        }
    }
}

Material readMaterial(const JsonReader& json) {
    Material material;
    readFields(material, materialFields(), json);
    if (const JsonReader reflectivity = json.at("reflectivity"); reflectivity.exists())
        checkReflectivity(material, reflectivity);
    json.refuseUnknown();
    return material;
}

UserSpectrum readUserSpectrum(const std::string& name, const JsonReader& json) {
    UserSpectrum spectrum;
    spectrum.name = name;
    readFields(spectrum, spectrumFields(), json);
    const std::vector<std::string> components =
        json.at("components").texts("a list of component names");
    // The axis is checked once, by the first component.
    const JsonReader rows = json.at("radiance_W_m2_sr_um");
    const auto columns = rows.columns(components.size() + 1);
    json.refuseUnknown();
    if (columns)
        rows.check([&] {
            for (std::size_t i = 0; i < components.size(); ++i)
                spectrum.components.push_back(
                    {components[i], {(*columns)[0], (*columns)[i + 1], Spectrum::Outside::zero}});
        });
    return spectrum;
}

std::optional<int> canonicalIndex(const std::string& key) {
    int index = 0;
    const char* const end = key.data() + key.size();
    const auto result = std::from_chars(key.data(), end, index);
    const bool whole = result.ec == std::errc{} && result.ptr == end;
    return whole && std::to_string(index) == key ? std::optional(index) : std::nullopt;
}

template <typename Entry, typename Read>
void readIndexed(const JsonReader& entries, std::map<int, Entry>& into, Read read) {
    for (const auto& [key, json] : entries.members("an object of entries by index"))
        if (const auto index = canonicalIndex(key))
            into[*index] = read(json);
        else
            json.refuse(shownJson(key), "a whole number of 32 bits as index");
}

} // namespace

std::string signatureToJson(const SignatureDatabase& database) {
    throwOnLintErrors(database, database.title.empty() ? "signature database" : database.title);
    return draftToJson(database);
}

std::string draftToJson(const SignatureDatabase& database) {
    using nlohmann::json;
    json root = {{"format", formatName},
                 {"version", formatVersionOf(database)},
                 {"program", programWithVersion()},
                 {"title", database.title},
                 {"notes", database.notes},
                 {"temperatures", json::object()},
                 {"materials", json::object()},
                 {"spectra", json::object()}};
    for (const auto& [index, entry] : database.temperatures)
        root["temperatures"][std::to_string(index)] = entryJson(entry);
    for (const auto& [index, material] : database.materials)
        root["materials"][std::to_string(index)] = entryJson(material);
    for (const auto& [name, spectrum] : database.spectra)
        root["spectra"][name] = entryJson(spectrum);
    return prettyJson(root) + "\n";
}

SignatureDatabase signatureFromJson(const std::string& text, const std::string& fileName,
                                    LintErrors errors) {
    const JsonReader root(text, fileName, jsonForm, JsonErrors::collect);
    root.at("format").word({formatName});
    root.at("program");
    const JsonReader version = root.at("version");
    const double number = version.number();
    if (number != std::clamp(std::round(number), 1.0, double(newestFormatVersion())))
        version.refuse(signatureVersionsExpected());

    SignatureDatabase database;
    database.title = root.at("title").textOr("");
    database.notes = root.at("notes").textOr("");
    readIndexed(root.at("temperatures"), database.temperatures, readTemperature);
    readIndexed(root.at("materials"), database.materials, readMaterial);
    if (const JsonReader spectra = root.at("spectra"); spectra.exists())
        for (const auto& [name, json] : spectra.members("an object of spectra by name"))
            database.spectra[name] = readUserSpectrum(name, json);
    root.refuseUnknown();
    root.throwRefused();
    if (errors == LintErrors::refuse)
        throwOnLintErrors(database, fileName);
    return database;
}

} // namespace irsg
