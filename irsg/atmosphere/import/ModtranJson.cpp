#include "irsg/atmosphere/import/ModtranJson.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "irsg/atmosphere/import/Tape7.h"
#include "irsg/atmosphere/path/Earth.h"
#include "irsg/core/Collect.h"
#include "irsg/core/JsonText.h"
#include "irsg/core/WrittenPath.h"
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

constexpr const char* inputKey = "\"MODTRANINPUT\"";

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
    void report(const std::string& path, std::string value, std::string expected) {
        diagnostics_.push_back(
            {file_, places_.position(path), std::move(value), std::move(expected)});
    }
    void throwIfAny() {
        if (!diagnostics_.empty())
            throw InputError(std::move(diagnostics_));
    }

    /// The lines of sight of the case of an index.
    std::vector<ModtranCase> readCase(std::size_t number) {
        ModtranCase result;
        result.number = number;
        const std::string path = pathOf(number) + ".MODTRANINPUT";
        const json& entry = cases()[number];
        if (!entry.is_object() || !entry.contains("MODTRANINPUT") ||
            !entry["MODTRANINPUT"].is_object()) {
            report(path, "no such object",
                   "the input of the case beside its results, or in a document of this folder "
                   "whose FILEOPTIONS.JSONPRNT names this file");
            return {result};
        }
        const json& input = entry["MODTRANINPUT"];
        result.name = text(input, "NAME");
        if (input.contains("FILEOPTIONS")) {
            result.csvName = text(input["FILEOPTIONS"], "CSVPRNT");
            result.jsonName = text(input["FILEOPTIONS"], "JSONPRNT");
        }
        for (const Key& key : keys)
            if (input.contains(key.group))
                readKey(key, input[key.group], path + "." + key.group, result.cards);
        result.kind = kindOf(result.cards, path);
        result.unit = unitOf(input, path);
        return sightsOf(std::move(result), input, path);
    }

    static std::string pathOf(std::size_t number) {
        return "MODTRAN[" + std::to_string(number) + "]";
    }

  private:
    void readKey(const Key& key, const json& group, const std::string& path,
                 std::map<std::string, double>& cards) {
        if (!group.is_object() || !group.contains(key.key))
            return;
        if (const auto value = numberOf(group[key.key], path + "." + key.key))
            cards[key.card] = *value;
    }

    /// A case of several lines of sight is several, each with GEOMETRY's keys where it has none.
    std::vector<ModtranCase> sightsOf(ModtranCase common, const json& input,
                                      const std::string& path) {
        const json none = json::array();
        const std::string place = path + ".GEOMETRY.MLOS";
        const json::json_pointer pointer("/GEOMETRY/MLOS");
        const json& sights = input.contains(pointer) ? input[pointer] : none;
        if (!sights.is_array()) {
            report(place, shownJson(sights), "an array of lines of sight");
            return {common};
        }
        if (sights.empty()) {
            finishSight(common.cards, path);
            return {common};
        }
        std::vector<ModtranCase> all;
        for (std::size_t i = 0; i < sights.size(); ++i) {
            const std::string at = place + "[" + std::to_string(i) + "]";
            all.push_back(common);
            if (!sights[i].is_object()) {
                report(at, shownJson(sights[i]), "an object with keys of GEOMETRY");
                continue;
            }
            for (const Key& key : keys)
                if (key.group == std::string_view("GEOMETRY"))
                    readKey(key, sights[i], at, all.back().cards);
            finishSight(all.back().cards, at);
        }
        return all;
    }

    void finishSight(std::map<std::string, double>& cards, const std::string& path) {
        for (const auto& [needed, called] :
             {std::pair{"ITYPE", "ITYPE"}, {"IEMSCT", "IEMSCT"}, {"H1", "H1ALT"}})
            if (!cards.contains(needed))
                report(path, std::string("no ") + called, "this setting in the input");
        finishSlant(cards);
    }

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
        report(path, shownJson(value), "a finite number or a word of MODTRAN 6");
        return std::nullopt;
    }

    RunKind kindOf(const std::map<std::string, double>& cards, const std::string& path) {
        const auto found = cards.find("IEMSCT");
        const double kind = found == cards.end() ? 0.0 : found->second;
        if (kind != 0.0 && kind != 1.0 && kind != 2.0 && kind != 3.0) {
            report(path + ".RTOPTIONS.IEMSCT", numberText(kind),
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
            report(path + ".SPECTRAL.XFLAG", flag, "W, M or N");
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

/// Where results stand, as a path and as a pointer.
struct OutputPlace {
    std::string path;
    json::json_pointer pointer;

    OutputPlace then(const std::string& key) const { return {path + "." + key, pointer / key}; }
    OutputPlace then(std::size_t index) const {
        return {path + "[" + std::to_string(index) + "]", pointer / index};
    }
};

/// The results of a line of sight: those of several stand in an array on one of the levels. No
/// value where there are none; says so then.
std::optional<OutputPlace> placeOf(Document& document, const ModtranCase& settings,
                                   std::size_t sight, std::size_t sights) {
    const json& entry = document.cases()[settings.number];
    OutputPlace place{Document::pathOf(settings.number), json::json_pointer()};
    const char* group = settings.kind == RunKind::transmittance ? "TRANSMITTANCE"
                        : settings.kind == RunKind::sunlight    ? "IRRADIANCE"
                                                                : "RADIANCE";
    bool isApart = false;
    for (const char* key : {"MODTRANOUTPUT", "SPECTRA", group}) {
        place = place.then(key);
        const json* found =
            entry.is_object() && entry.contains(place.pointer) ? &entry[place.pointer] : nullptr;
        if (found != nullptr && found->is_array() && !isApart) {
            if (found->size() != sights) {
                document.report(place.path, std::to_string(found->size()) + " results",
                                std::to_string(sights) + ", one for each line of sight");
                return std::nullopt;
            }
            isApart = true;
            place = place.then(sight);
            found = &entry[place.pointer];
        }
        if (found == nullptr || !found->is_object()) {
            document.report(place.path, "no such object",
                            "results of the case (JSONOPT WRT_OUTPUT)");
            return std::nullopt;
        }
    }
    if (sights > 1 && !isApart) {
        document.report(place.path, "results of one line of sight",
                        "an array of " + std::to_string(sights) +
                            ", one for each of GEOMETRY.MLOS");
        return std::nullopt;
    }
    return place;
}

/// The arrays of one line of sight.
RunTable spectraOf(Document& document, const OutputPlace& place, const ModtranCase& settings) {
    RunTable table{.file = document.file(),
                   .positions = {},
                   .columns = {},
                   .unit = settings.unit,
                   .transmittanceRounding = 0.0,
                   .sumsIncluded = false};
    const std::string& path = place.path;
    const json& spectra = document.cases()[settings.number][place.pointer];
    std::optional<std::size_t> rows;
    for (const auto& [key, values] : spectra.items()) {
        const std::optional<RunColumn> column = runColumn(key);
        if (!column || !values.is_array())
            continue;
        std::string ofKey = path;
        ofKey.append(".").append(key);
        if (values.size() != rows.value_or(values.size())) {
            document.report(ofKey, std::to_string(values.size()) + " values",
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
                std::string where = ofKey;
                where.append("[").append(std::to_string(i)).append("]");
                document.report(where, shownJson(values[i]), "a finite number");
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
            document.report(path, "no array FREQ, and " + std::to_string(*rows) + " values",
                            "a spectral axis, or as many values as V1, V2 and DV make");
        }
        for (std::size_t i = 0; i < *rows; ++i) {
            table.columns[RunColumn::wavenumber].push_back(card("V1") +
                                                           static_cast<double>(i) * card("DV"));
        }
    }
    return table;
}

/// Lines of sight of each case.
std::vector<std::vector<ModtranCase>> byCase(const std::vector<ModtranCase>& sights) {
    std::vector<std::vector<ModtranCase>> cases;
    for (const ModtranCase& sight : sights) {
        if (cases.empty() || cases.back().back().number != sight.number)
            cases.emplace_back();
        cases.back().push_back(sight);
    }
    return cases;
}

} // namespace

std::vector<SpectralRun> readModtranJson(const std::filesystem::path& file) {
    const std::string text = readTextFile(file);
    const bool hasInput = text.find(inputKey) != std::string::npos;
    return parseModtranJson(text, file.string(),
                            hasInput ? std::vector<ModtranCase>()
                                     : modtranCasesBeside(file, &ModtranCase::jsonName));
}

std::vector<SpectralRun> parseModtranJson(const std::string& text, const std::string& file,
                                          const std::vector<ModtranCase>& beside) {
    Document document(text, file);
    const std::vector<std::vector<ModtranCase>> stated = byCase(beside);
    if (!stated.empty() && stated.size() != document.cases().size()) {
        throw InputError(
            {file, "MODTRAN", std::to_string(document.cases().size()) + " cases",
             std::to_string(stated.size()) + " as in the input document that names this file"});
    }
    std::vector<SpectralRun> runs;
    for (std::size_t i = 0; i < document.cases().size(); ++i) {
        const std::size_t before = document.diagnostics().size();
        std::vector<ModtranCase> sights = stated.empty() ? document.readCase(i) : stated[i];
        if (document.diagnostics().size() != before)
            continue;
        for (std::size_t k = 0; k < sights.size(); ++k) {
            ModtranCase& settings = sights[k];
            settings.number = i;
            const std::string line =
                sights.size() > 1 ? ", line of sight " + std::to_string(k + 1) : "";
            SpectralRun run;
            run.source = std::filesystem::path(file).filename().string() + ", case " +
                         (settings.name.empty() ? std::to_string(i) : settings.name) + line;
            run.kind = settings.kind;
            run.cards = settings.cards;
            const auto place = placeOf(document, settings, k, sights.size());
            if (!place)
                continue;
            const std::size_t beforeSpectra = document.diagnostics().size();
            const RunTable table = spectraOf(document, *place, settings);
            if (beforeSpectra == document.diagnostics().size()) {
                placeRun(run, file,
                         Document::pathOf(i) + ".MODTRANINPUT.GEOMETRY" +
                             (sights.size() > 1 ? ".MLOS[" + std::to_string(k) + "]" : ""),
                         document.diagnostics());
                fillRun(run, table, document.diagnostics());
            }
            runs.push_back(std::move(run));
        }
    }
    document.throwIfAny();
    return runs;
}

std::vector<ModtranCase> parseModtranCases(const std::string& text, const std::string& file) {
    Document document(text, file);
    std::vector<ModtranCase> cases;
    for (std::size_t i = 0; i < document.cases().size(); ++i)
        for (ModtranCase& sight : document.readCase(i))
            cases.push_back(std::move(sight));
    document.throwIfAny();
    return cases;
}

std::vector<ModtranCase> modtranCasesBeside(const std::filesystem::path& file,
                                            std::string ModtranCase::*name) {
    const std::filesystem::path folder =
        file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
    std::vector<std::filesystem::path> documents;
    const std::filesystem::path twin = std::filesystem::path(file).replace_extension(".json");
    std::error_code problem;
    for (const auto& entry : std::filesystem::directory_iterator(folder, problem))
        if (entry.is_regular_file(problem) && entry.path().extension() == ".json" &&
            entry.path().filename() != file.filename())
            documents.push_back(entry.path());
    std::ranges::sort(documents, {}, [&](const std::filesystem::path& one) {
        return std::pair(one.filename() != twin.filename(), one);
    });
    std::vector<Diagnostic> wrong;
    for (const std::filesystem::path& document : documents) {
        const std::string text = readTextFile(document);
        if (!isModtranJson(text) || text.find(inputKey) == std::string::npos)
            continue;
        std::vector<ModtranCase> cases;
        std::vector<Diagnostic> ofThis;
        collect(ofThis, [&] { cases = parseModtranCases(text, document.string()); });
        if (!ofThis.empty()) {
            // It may be of other results; it is told where none names these.
            if (wrong.empty())
                wrong = std::move(ofThis);
            continue;
        }
        const auto isOther = [&](const ModtranCase& one) {
            const std::string named = writtenFileName(one.*name), own = file.filename().string();
            return !isSameName(named, own) && !isSameName(named + ".json", own);
        };
        if (document.filename() == twin.filename() && std::ranges::all_of(cases, isOther))
            return cases;
        std::erase_if(cases, isOther);
        if (!cases.empty())
            return cases;
    }
    if (!wrong.empty())
        throw InputError(std::move(wrong));
    return {};
}

bool isModtranJson(std::string_view text) {
    return text.substr(0, text.find_first_not_of(" \t\r\n")).size() < text.size() &&
           text[std::min(text.find_first_not_of(" \t\r\n"), text.size() - 1)] == '{' &&
           text.find("\"MODTRAN\"") != text.npos;
}

} // namespace irsg
