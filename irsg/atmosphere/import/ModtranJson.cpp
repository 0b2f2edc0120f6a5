#include "irsg/atmosphere/import/ModtranJson.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "irsg/atmosphere/Earth.h"
#include "irsg/atmosphere/import/Tape7.h"
#include "irsg/radiometry/JsonText.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

using nlohmann::json;

struct Word {
    const char* word;
    double number;
};
constexpr Word words[] = {
    {"RT_TRANSMITTANCE", 0},
    {"RT_THERMAL_ONLY", 1},
    {"RT_SOLAR_AND_THERMAL", 2},
    {"RT_SOLAR_IRRADIANCE", 3},
    {"RT_NO_MULTIPLE_SCATTER", 0},
    {"RT_DISORT", 1},
    {"RT_DISORT_AT_OBS", -1},
    {"RT_ISAACS_2STREAM", 3},
    {"RT_ISAACS_2STREAM_AT_OBS", -3},
    {"RT_ISAACS_SCALED", 5},
    {"RT_ISAACS_SCALED_AT_OBS", -5},
    {"ATM_CONSTANT", 0},
    {"ATM_TROPICAL", 1},
    {"ATM_MIDLAT_SUMMER", 2},
    {"ATM_MIDLAT_WINTER", 3},
    {"ATM_SUBARC_SUMMER", 4},
    {"ATM_SUBARC_WINTER", 5},
    {"ATM_US_STANDARD_1976", 6},
    {"ATM_USER_ALT_PROFILE", 7},
    {"ATM_USER_PRESS_PROFILE", 8},
    {"AER_NONE", 0},
    {"AER_RURAL", 1},
    {"AER_RURAL_DENSE", 2},
    {"AER_MARITIME_NAVY", 3},
    {"AER_MARITIME", 4},
    {"AER_URBAN", 5},
    {"AER_TROPOSPHERIC", 6},
    {"AER_USER_DEFINED", 7},
    {"AER_FOG_ADVECTIVE", 8},
    {"AER_FOG_RADIATIVE", 9},
    {"AER_DESERT", 10},
    {"SEASN_AUTO", 0},
    {"SEASN_SPRING_SUMMER", 1},
    {"SEASN_FALL_WINTER", 2},
    {"STRATO_BACKGROUND", 1},
    {"CLOUD_NONE", 0},
    {"CLOUD_CUMULUS", 1},
    {"CLOUD_ALTOSTRATUS", 2},
    {"CLOUD_STRATUS", 3},
    {"CLOUD_STRATOCUMULUS", 4},
    {"CLOUD_NIMBOSTRATUS", 5},
    {"CLOUD_CIRRUS", 18},
    {"CLOUD_CIRRUS_THIN", 19},
};

struct Key {
    const char* group;
    const char* key;
    const char* card;
};
constexpr Key keys[] = {
    {"GEOMETRY", "ITYPE", "ITYPE"},    {"GEOMETRY", "H1ALT", "H1"},
    {"GEOMETRY", "H2ALT", "H2"},       {"GEOMETRY", "OBSZEN", "ANGLE"},
    {"GEOMETRY", "HRANGE", "RANGE"},   {"GEOMETRY", "LENN", "LEN"},
    {"GEOMETRY", "RAD_E", "RO"},       {"GEOMETRY", "IPARM", "IPARM"},
    {"GEOMETRY", "PARM1", "PARM1"},    {"GEOMETRY", "PARM2", "PARM2"},
    {"GEOMETRY", "PARM3", "PARM3"},    {"GEOMETRY", "PARM4", "PARM4"},
    {"GEOMETRY", "IDAY", "IDAY"},      {"GEOMETRY", "GMTIME", "TIME"},
    {"RTOPTIONS", "IEMSCT", "IEMSCT"}, {"RTOPTIONS", "IMULT", "IMULT"},
    {"ATMOSPHERE", "MODEL", "MODEL"},  {"ATMOSPHERE", "CO2MX", "CO2MX"},
    {"AEROSOLS", "IHAZE", "IHAZE"},    {"AEROSOLS", "ISEASN", "ISEASN"},
    {"AEROSOLS", "IVULCN", "IVULCN"},  {"AEROSOLS", "ICLD", "ICLD"},
    {"AEROSOLS", "ICSTL", "ICSTL"},    {"AEROSOLS", "VIS", "VIS"},
    {"AEROSOLS", "WSS", "WSS"},        {"AEROSOLS", "WHH", "WHH"},
    {"AEROSOLS", "RAINRT", "RAINRT"},  {"SURFACE", "TPTEMP", "TBOUND"},
    {"SURFACE", "SURREF", "SALB"},     {"SURFACE", "GNDALT", "GNDALT"},
    {"SPECTRAL", "V1", "V1"},          {"SPECTRAL", "V2", "V2"},
    {"SPECTRAL", "DV", "DV"},          {"SPECTRAL", "FWHM", "FWHM"},
};

/// MODTRAN itself takes comments in its documents.
const JsonForm form = {.expected = "a MODTRAN 6 document (JSON)", .mayComment = true};

/// The document of one file and what is wrong with it.
class Document {
  public:
    Document(const std::string& text, const std::string& file)
        : file_(file), root_(parseJson(text, file, form)), places_(text, form.mayComment) {
        if (!root_.is_object() || !root_.contains("MODTRAN") || !root_["MODTRAN"].is_array() ||
            root_["MODTRAN"].empty()) {
            throw InputError({file, "", "no array MODTRAN with cases in it",
                              "a MODTRAN 6 document: {\"MODTRAN\": [...]}"});
        }
    }

    const std::string& file() const { return file_; }
    const json& cases() const { return root_["MODTRAN"]; }
    std::vector<Diagnostic>& diagnostics() { return diagnostics_; }
    void offend(const std::string& path, std::string value, std::string expected) {
        diagnostics_.push_back(
            {file_, places_.position(path), std::move(value), std::move(expected)});
    }
    void throwIfAny() {
        if (!diagnostics_.empty())
            throw InputError(std::move(diagnostics_));
    }

    /// The case of an index; `number` of its diagnostics begin with MODTRAN[number].
    ModtranCase readCase(std::size_t number) {
        ModtranCase result;
        const std::string path = pathOf(number) + ".MODTRANINPUT";
        const json& entry = cases()[number];
        if (!entry.is_object() || !entry.contains("MODTRANINPUT") ||
            !entry["MODTRANINPUT"].is_object()) {
            offend(path, "no such object", "the input of the case beside its results");
            return result;
        }
        const json& input = entry["MODTRANINPUT"];
        result.name = text(input, "NAME");
        if (input.contains("FILEOPTIONS"))
            result.csvName = text(input["FILEOPTIONS"], "CSVPRNT");
        for (const Key& key : keys) {
            if (!input.contains(key.group) || !input[key.group].is_object() ||
                !input[key.group].contains(key.key)) {
                continue;
            }
            const std::string at = path + "." + key.group + "." + key.key;
            if (const std::optional<double> value = numberOf(input[key.group][key.key], at))
                result.cards[key.card] = *value;
        }
        if (input.contains("GEOMETRY") && input["GEOMETRY"].is_object() &&
            input["GEOMETRY"].contains("MLOS") && !input["GEOMETRY"]["MLOS"].empty()) {
            offend(path + ".GEOMETRY.MLOS", "several lines of sight", "one line of sight a case");
        }
        for (const char* needed : {"ITYPE", "IEMSCT", "H1"}) {
            if (!result.cards.contains(needed)) {
                offend(path, "no " + std::string(needed == std::string("H1") ? "H1ALT" : needed),
                       "this setting in the input");
            }
        }
        result.kind = kindOf(result.cards, path);
        result.unit = unitOf(input, path);
        finishSlant(result.cards);
        return result;
    }

    static std::string pathOf(std::size_t number) {
        return "MODTRAN[" + std::to_string(number) + "]";
    }

  private:
    static std::string text(const json& object, const char* key) {
        return object.is_object() && object.contains(key) && object[key].is_string()
                   ? object[key].get<std::string>()
                   : "";
    }

    std::optional<double> numberOf(const json& value, const std::string& path) {
        if (value.is_number() && std::isfinite(value.get<double>()))
            return value.get<double>();
        if (value.is_boolean())
            return value.get<bool>() ? 1.0 : 0.0;
        if (value.is_string()) {
            const std::string word = value.get<std::string>();
            const auto* found =
                std::ranges::find_if(words, [&](const Word& known) { return word == known.word; });
            if (found != std::end(words))
                return found->number;
            // Words that do not decide how a result is read are let through without a number.
            if (path.ends_with("IVULCN") || path.ends_with("ICLD"))
                return std::nullopt;
        }
        offend(path, shownJson(value), "a finite number or a word of MODTRAN 6");
        return std::nullopt;
    }

    RunKind kindOf(const std::map<std::string, double>& cards, const std::string& path) {
        const auto found = cards.find("IEMSCT");
        const double kind = found == cards.end() ? 0.0 : found->second;
        if (kind != 0.0 && kind != 1.0 && kind != 2.0 && kind != 3.0) {
            offend(path + ".RTOPTIONS.IEMSCT", numberText(kind),
                   "0 (transmittance), 1 or 2 (radiance) or 3 (solar irradiance)");
            return RunKind::transmittance;
        }
        return static_cast<RunKind>(static_cast<int>(kind));
    }

    SpectralUnit unitOf(const json& input, const std::string& path) {
        const std::string flag =
            input.contains("SPECTRAL") ? text(input["SPECTRAL"], "XFLAG") : std::string();
        if (flag == "M" || flag == "m")
            return SpectralUnit::micrometre;
        if (flag == "N" || flag == "n")
            return SpectralUnit::nanometre;
        if (!(flag.empty() || flag == " " || flag == "W" || flag == "w"))
            offend(path + ".SPECTRAL.XFLAG", flag, "W, M or N");
        return SpectralUnit::wavenumber;
    }

    /// MODTRAN's case 2b: a zenith angle and a range lead to the end of the path.
    static void finishSlant(std::map<std::string, double>& cards) {
        if (cards["ITYPE"] != 2.0 || !(cards["RANGE"] > 0.0) || !(cards["ANGLE"] > 0.0))
            return;
        const double from = (cards["RO"] > 0.0 ? cards["RO"] : 1e-3 * earthRadius_m) + cards["H1"];
        const double rise = cards["RANGE"] * std::cos(radians(cards["ANGLE"]));
        const double across = cards["RANGE"] * std::sin(radians(cards["ANGLE"]));
        cards["H2"] = cards["H1"] + std::hypot(from + rise, across) - from;
    }

    const std::string& file_;
    json root_;
    JsonPlaces places_;
    std::vector<Diagnostic> diagnostics_;
};

/// The arrays of one case's results.
RunTable spectraOf(Document& document, std::size_t number, const ModtranCase& settings) {
    RunTable table{.file = document.file(),
                   .positions = {},
                   .columns = {},
                   .unit = settings.unit,
                   .transmittanceRounding = 0.0,
                   .sumsIncluded = false};
    const char* group = settings.kind == RunKind::transmittance ? "TRANSMITTANCE"
                        : settings.kind == RunKind::sunlight    ? "IRRADIANCE"
                                                                : "RADIANCE";
    const std::string path =
        Document::pathOf(number) + ".MODTRANOUTPUT.SPECTRA." + std::string(group);
    const json::json_pointer pointer("/MODTRANOUTPUT/SPECTRA/" + std::string(group));
    const json& entry = document.cases()[number];
    if (!entry.contains(pointer) || !entry[pointer].is_object()) {
        document.offend(path, "no such object", "results of the case (JSONOPT WRT_OUTPUT)");
        return table;
    }
    std::optional<std::size_t> rows;
    for (const auto& [key, values] : entry[pointer].items()) {
        const std::optional<RunColumn> column = runColumn(key);
        if (!column || !values.is_array())
            continue;
        if (values.size() != rows.value_or(values.size())) {
            document.offend(path + "." + key, std::to_string(values.size()) + " values",
                            std::to_string(*rows) + " as in the arrays before");
            continue;
        }
        rows = values.size();
        if (key == "PTH_THRML" || key == "SOL_SCAT")
            table.sumsIncluded = true;
        std::vector<double>& numbers = table.columns[*column];
        for (std::size_t i = 0; i < values.size(); ++i) {
            const bool finite = values[i].is_number() && std::isfinite(values[i].get<double>());
            if (!finite) {
                document.offend(path + "." + key + "[" + std::to_string(i) + "]",
                                shownJson(values[i]), "a finite number");
            }
            numbers.push_back(finite ? values[i].get<double>() : 0.0);
        }
    }
    for (std::size_t i = 0; i < rows.value_or(0); ++i)
        table.positions.push_back(path + "[" + std::to_string(i) + "]");
    if (rows && !table.columns.contains(RunColumn::wavenumber)) {
        const auto card = [&](const char* name) {
            const auto found = settings.cards.find(name);
            return found == settings.cards.end() ? 0.0 : found->second;
        };
        const double steps = (card("V2") - card("V1")) / card("DV");
        if (!(std::abs(steps + 1.0 - static_cast<double>(*rows)) < 0.5)) {
            document.offend(path, "no array FREQ, and " + std::to_string(*rows) + " values",
                            "a spectral axis, or as many values as V1, V2 and DV make");
        }
        for (std::size_t i = 0; i < *rows; ++i) {
            table.columns[RunColumn::wavenumber].push_back(card("V1") +
                                                           static_cast<double>(i) * card("DV"));
        }
    }
    return table;
}

} // namespace

std::vector<SpectralRun> readModtranJson(const std::filesystem::path& file) {
    return parseModtranJson(readTextFile(file), file.string());
}

std::vector<SpectralRun> parseModtranJson(const std::string& text, const std::string& file) {
    Document document(text, file);
    std::vector<SpectralRun> runs;
    for (std::size_t i = 0; i < document.cases().size(); ++i) {
        const ModtranCase settings = document.readCase(i);
        SpectralRun run;
        run.source = std::filesystem::path(file).filename().string() + ", case " +
                     (settings.name.empty() ? std::to_string(i) : settings.name);
        run.kind = settings.kind;
        run.cards = settings.cards;
        const std::size_t before = document.diagnostics().size();
        const RunTable table = spectraOf(document, i, settings);
        if (before == document.diagnostics().size()) {
            placeRun(run, file, Document::pathOf(i) + ".MODTRANINPUT.GEOMETRY",
                     document.diagnostics());
            fillRun(run, table, document.diagnostics());
        }
        runs.push_back(std::move(run));
    }
    document.throwIfAny();
    return runs;
}

std::vector<ModtranCase> parseModtranCases(const std::string& text, const std::string& file) {
    Document document(text, file);
    std::vector<ModtranCase> cases;
    for (std::size_t i = 0; i < document.cases().size(); ++i)
        cases.push_back(document.readCase(i));
    document.throwIfAny();
    return cases;
}

bool isModtranJson(std::string_view text) {
    return text.substr(0, text.find_first_not_of(" \t\r\n")).size() < text.size() &&
           text[std::min(text.find_first_not_of(" \t\r\n"), text.size() - 1)] == '{' &&
           text.find("\"MODTRAN\"") != text.npos;
}

} // namespace irsg
