#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "irsg/atmosphere/TabulatedAtmosphere.h"
#include "irsg/atmosphere/import/ModtranCsv.h"
#include "irsg/atmosphere/import/ModtranJson.h"
#include "irsg/atmosphere/import/Tape7.h"
#include "irsg/core/Collect.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/core/JsonReader.h"
#include "irsg/core/ProgramVersion.h"

namespace irsg {

namespace {

using nlohmann::ordered_json;

constexpr const char* formatName = "irsg tabulated atmosphere";
constexpr int formatVersion = 1;

struct SpectrumKey {
    const char* key;
    std::vector<double> SpectralRun::*values;
    double largest;
};
const SpectrumKey spectrumKeys[] = {
    {"transmittance", &SpectralRun::transmittance, 1.0},
    {"path_radiance [W m-2 sr-1 um-1]", &SpectralRun::pathRadiance_W_m2_sr_um, HUGE_VAL},
    {"total_radiance [W m-2 sr-1 um-1]", &SpectralRun::totalRadiance_W_m2_sr_um, HUGE_VAL},
    {"solar_irradiance [W m-2 um-1]", &SpectralRun::solarIrradiance_W_m2_um, HUGE_VAL},
    {"scattering_depth", &SpectralRun::scatteringDepth, HUGE_VAL},
};

constexpr const char* pathNames[] = {"", "horizontal", "slant", "to space"};

/// One table file on its way from JSON to runs.
class TableReader {
  public:
    TableReader(const std::string& text, const std::string& file)
        : root_(text, file, {.expected = "a tabulated atmosphere (JSON)", .indexInBrackets = true},
                JsonErrors::collect) {
        if (!root_.isObject("a tabulated atmosphere (a JSON object)"))
            root_.throwRefused();
        if (const JsonReader format = root_.at("format"); format.json() != formatName)
            format.refuse("\"" + std::string(formatName) + "\"");
        root_.throwRefused();
        if (const JsonReader version = root_.at("version"); version.json() != formatVersion)
            version.refuse(std::to_string(formatVersion));
        root_.throwRefused();
    }

    TabulatedAtmosphere read() {
        const JsonReader axis = root_.at("wavenumbers [cm-1]");
        wavenumbers_ = axis.numbers("numbers", {.least = 0.0});
        for (std::size_t i = 0; i < wavenumbers_.size(); ++i) {
            if (wavenumbers_[i] <= (i == 0 ? 0.0 : wavenumbers_[i - 1])) {
                axis.refuse(numberText(wavenumbers_[i]), "positive and ascending wavenumbers",
                            "[" + std::to_string(i) + "]");
            }
        }
        if (wavenumbers_.size() < 2)
            axis.refuse(std::to_string(wavenumbers_.size()) + " values", "at least two");
        const JsonReader list = root_.at("runs");
        std::vector<SpectralRun> runs;
        for (const JsonReader& run : list.list("at least one run"))
            runs.push_back(readRun(run));
        if (runs.empty())
            list.refuse("at least one run");
        std::string name = root_.at("name").text();
        root_.throwRefused();
        return {std::move(runs), std::move(name)};
    }

  private:
    SpectralRun readRun(const JsonReader& json) {
        SpectralRun run;
        run.wavenumbers_per_cm = wavenumbers_;
        if (!json.isObject())
            return run;
        run.source = json.at("source").text();
        std::vector<std::string> kinds;
        for (int i = 0; i < 4; ++i)
            kinds.push_back(name(static_cast<RunKind>(i)));
        run.kind = static_cast<RunKind>(json.at("kind").word(kinds));
        const std::vector<std::string> paths(std::begin(pathNames) + 1, std::end(pathNames));
        run.geometry.path = static_cast<RunPath>(json.at("path").word(paths) + 1);
        RunGeometry& geometry = run.geometry;
        geometry.sensorAltitude_m = json.at("sensor_altitude [m]").number({0.0, 1e8});
        geometry.targetAltitude_m = json.at("target_altitude [m]").number({-1e8, 1e8});
        geometry.range_m = json.at("range [m]").number({0.0, 1e9});
        geometry.elevation_rad = json.at("elevation [rad]").number({-1.6, 1.6});
        geometry.sunElevation_rad = json.at("sun_elevation [rad]").numberIfAny({-1.6, 1.6});
        if (const JsonReader cards = json.at("cards"); cards.exists())
            for (const auto& [card, value] : cards.members())
                run.cards[card] = value.number({-1e30, 1e30});
        for (const JsonReader& warning : json.at("warnings").listOrNone())
            run.warnings.push_back(warning.text());
        for (const SpectrumKey& spectrum : spectrumKeys) {
            const JsonReader list = json.at(spectrum.key);
            if (!list.exists() && spectrum.values != &SpectralRun::transmittance)
                continue;
            const auto values = list.numbers("numbers", {0.0, spectrum.largest});
            if (values.size() != wavenumbers_.size()) {
                list.refuse(std::to_string(values.size()) + " values",
                            std::to_string(wavenumbers_.size()) + ", one for each wavenumber");
            }
            run.*spectrum.values = values;
        }
        const bool radiates =
            run.kind == RunKind::thermalRadiance || run.kind == RunKind::solarRadiance;
        if (radiates &&
            (run.pathRadiance_W_m2_sr_um.empty() || run.totalRadiance_W_m2_sr_um.empty()))
            json.refuse("no radiances", "path and total radiance in a run of this kind");
        if (run.kind == RunKind::sunlight && run.solarIrradiance_W_m2_um.empty())
            json.refuse("no solar irradiance", "it in a run of this kind");
        return run;
    }

    JsonReader root_;
    std::vector<double> wavenumbers_;
};

/// The first thing in a text that is neither blank nor a byte order mark.
char firstCharacter(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF"))
        text.remove_prefix(3);
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return first == text.npos ? '\0' : text[first];
}

bool looksLikeTape7(std::string_view text) {
    const std::size_t names = std::min(text.find("\n    FREQ"), text.find("\n  FREQ"));
    return names != text.npos || text.substr(0, 16384).find("! H2O & O3 COLUMNS") != text.npos;
}

std::vector<SpectralRun> readRuns(const std::filesystem::path& file) {
    const std::string text = readTextFile(file);
    const bool isCsv = file.extension() == ".csv" || file.extension() == ".CSV";
    if (isCsv)
        return readModtranCsv(file);
    if (firstCharacter(text) == '{') {
        return TabulatedAtmosphere::isTable(text) || file.extension() == ".smatatm"
                   ? TabulatedAtmosphere::fromText(text, file.string()).runs()
                   : readModtranJson(file);
    }
    return parseTape7(TextLines::parse(text, file.string()));
}

} // namespace

std::string TabulatedAtmosphere::toText() const {
    ordered_json root = {{"format", formatName},
                         {"version", formatVersion},
                         {"program", programWithVersion()},
                         {"name", name_}};
    root["wavenumbers [cm-1]"] = runs_.front().wavenumbers_per_cm;
    for (const SpectralRun& run : runs_) {
        ordered_json object = {{"source", run.source},
                               {"kind", irsg::name(run.kind)},
                               {"path", pathNames[static_cast<int>(run.geometry.path)]},
                               {"sensor_altitude [m]", run.geometry.sensorAltitude_m},
                               {"target_altitude [m]", run.geometry.targetAltitude_m},
                               {"range [m]", run.geometry.range_m},
                               {"elevation [rad]", run.geometry.elevation_rad}};
        if (run.geometry.sunElevation_rad)
            object["sun_elevation [rad]"] = *run.geometry.sunElevation_rad;
        object["cards"] = run.cards;
        object["warnings"] = run.warnings;
        for (const SpectrumKey& spectrum : spectrumKeys)
            if (!(run.*spectrum.values).empty())
                object[spectrum.key] = run.*spectrum.values;
        root["runs"].push_back(std::move(object));
    }
    // Cards of old programs are in the encodings of their time.
    return root.dump(-1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

void TabulatedAtmosphere::write(const std::filesystem::path& file) const {
    writeFileDurably(file, toText());
}

TabulatedAtmosphere TabulatedAtmosphere::read(const std::filesystem::path& file) {
    return fromText(readTextFile(file), file.string());
}

TabulatedAtmosphere TabulatedAtmosphere::fromText(const std::string& text,
                                                  const std::string& file) {
    return TableReader(text, file).read();
}

bool TabulatedAtmosphere::isTable(std::string_view text) {
    return firstCharacter(text) == '{' &&
           text.substr(0, 200).find(formatName) != std::string_view::npos;
}

bool TabulatedAtmosphere::isTableFile(const std::filesystem::path& file) {
    return file.extension() == ".smatatm" || isTable(readTextFile(file));
}

bool TabulatedAtmosphere::canImport(const std::filesystem::path& file) {
    if (file.extension() == ".smatatm")
        return true;
    const std::string text = readTextFile(file);
    if (file.extension() == ".csv" || file.extension() == ".CSV")
        return isModtranCsv(text);
    return firstCharacter(text) == '{' ? isTable(text) || isModtranJson(text)
                                       : looksLikeTape7(text);
}

TabulatedAtmosphere TabulatedAtmosphere::import(std::span<const std::filesystem::path> files) {
    std::vector<Diagnostic> diagnostics;
    std::vector<SpectralRun> runs;
    for (const std::filesystem::path& file : files) {
        collect(diagnostics, [&] {
            std::vector<SpectralRun> some = readRuns(file);
            const auto isNamesake = [&](const std::filesystem::path& other) {
                return &other != &file && other.filename() == file.filename();
            };
            if (std::ranges::any_of(files, isNamesake))
                for (SpectralRun& run : some)
                    run.source = (file.parent_path().filename() / run.source).string();
            std::ranges::move(some, std::back_inserter(runs));
        });
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    std::string name = "tabulated";
    if (!files.empty()) {
        name += " (" + files.front().filename().string() +
                (files.size() > 1 ? " and " + std::to_string(files.size() - 1) + " more)" : ")");
    }
    return {std::move(runs), std::move(name)};
}

} // namespace irsg
