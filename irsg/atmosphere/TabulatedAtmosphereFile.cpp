#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "irsg/atmosphere/TabulatedAtmosphere.h"
#include "irsg/atmosphere/import/ModtranCsv.h"
#include "irsg/atmosphere/import/ModtranJson.h"
#include "irsg/atmosphere/import/Tape7.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/core/JsonText.h"

namespace irsg {

namespace {

using nlohmann::json;
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
        : file_(file),
          root_(parseJson(text, file, {.expected = "a tabulated atmosphere (JSON)"})),
          places_(text) {
        if (!root_.is_object() || root_.value("format", json()) != formatName) {
            throw InputError({file, "format",
                              root_.is_object() && root_.contains("format")
                                  ? shownJson(root_["format"])
                                  : "no such key",
                              "\"" + std::string(formatName) + "\""});
        }
        if (root_.value("version", json()) != formatVersion) {
            throw InputError(
                {file, "version",
                 root_.contains("version") ? shownJson(root_["version"]) : "no such key",
                 std::to_string(formatVersion)});
        }
    }

    TabulatedAtmosphere read() {
        const std::vector<double> wavenumbers =
            numbers(root_, "wavenumbers [cm-1]", "", 0.0, HUGE_VAL);
        for (std::size_t i = 0; i < wavenumbers.size(); ++i) {
            if (!(wavenumbers[i] > (i == 0 ? 0.0 : wavenumbers[i - 1]))) {
                report("wavenumbers [cm-1][" + std::to_string(i) + "]", numberText(wavenumbers[i]),
                       "positive and ascending wavenumbers");
            }
        }
        if (wavenumbers.size() < 2) {
            report("wavenumbers [cm-1]", std::to_string(wavenumbers.size()) + " values",
                   "at least two");
        }
        std::vector<SpectralRun> runs;
        const json& list = root_.contains("runs") ? root_["runs"] : json();
        if (!list.is_array() || list.empty())
            report("runs", list.is_array() ? "an empty array" : "no array", "at least one run");
        for (std::size_t i = 0; list.is_array() && i < list.size(); ++i)
            runs.push_back(readRun(list[i], "runs[" + std::to_string(i) + "]", wavenumbers));
        if (!diagnostics_.empty())
            throw InputError(std::move(diagnostics_));
        return {std::move(runs), text(root_, "name", "")};
    }

  private:
    void report(const std::string& path, std::string value, std::string expected) {
        diagnostics_.push_back(
            {file_, places_.position(path), std::move(value), std::move(expected)});
    }

    std::string text(const json& object, const char* key, const std::string& path) {
        if (object.contains(key) && object[key].is_string())
            return object[key].get<std::string>();
        report(path + key, object.contains(key) ? shownJson(object[key]) : "no such key", "a text");
        return "";
    }

    double number(const json& object, const char* key, const std::string& path, double least,
                  double largest) {
        const json value = object.value(key, json());
        if (value.is_number()) {
            const double found = value.get<double>();
            if (std::isfinite(found) && found >= least && found <= largest)
                return found;
        }
        report(path + key, object.contains(key) ? shownJson(value) : "no such key",
               "a number of " + numberText(least) + " to " + numberText(largest));
        return 0.0;
    }

    std::vector<double> numbers(const json& object, const char* key, const std::string& path,
                                double least, double largest) {
        std::vector<double> values;
        const json& list = object.contains(key) ? object[key] : json();
        if (!list.is_array()) {
            report(path + key, "no array", "numbers");
            return values;
        }
        for (std::size_t i = 0; i < list.size(); ++i) {
            const double value = list[i].is_number() ? list[i].get<double>() : std::nan("");
            if (!(value >= least && value <= largest && std::isfinite(value))) {
                report(path + key + "[" + std::to_string(i) + "]", shownJson(list[i]),
                       largest == 1.0 ? "0 to 1" : "a finite number of at least 0");
            }
            values.push_back(value);
        }
        return values;
    }

    SpectralRun readRun(const json& object, const std::string& where,
                        const std::vector<double>& wavenumbers) {
        SpectralRun run;
        run.wavenumbers_per_cm = wavenumbers;
        if (!object.is_object()) {
            report(where, shownJson(object), "an object");
            return run;
        }
        const std::string path = where + ".";
        run.source = text(object, "source", path);
        const std::string kind = text(object, "kind", path);
        const std::string line = text(object, "path", path);
        bool known = false;
        for (int i = 0; i < 4; ++i) {
            if (kind == name(static_cast<RunKind>(i))) {
                run.kind = static_cast<RunKind>(i);
                known = true;
            }
        }
        if (!known) {
            report(path + "kind", kind,
                   "transmittance, thermal radiance, thermal and solar radiance or solar "
                   "irradiance");
        }
        known = false;
        for (int i = 1; i < 4; ++i) {
            if (line == pathNames[i]) {
                run.geometry.path = static_cast<RunPath>(i);
                known = true;
            }
        }
        if (!known)
            report(path + "path", line, "horizontal, slant or to space");
        RunGeometry& geometry = run.geometry;
        geometry.sensorAltitude_m = number(object, "sensor_altitude [m]", path, 0.0, 1e8);
        geometry.targetAltitude_m = number(object, "target_altitude [m]", path, -1e8, 1e8);
        geometry.range_m = number(object, "range [m]", path, 0.0, 1e9);
        geometry.elevation_rad = number(object, "elevation [rad]", path, -1.6, 1.6);
        if (object.contains("sun_elevation [rad]"))
            geometry.sunElevation_rad = number(object, "sun_elevation [rad]", path, -1.6, 1.6);
        if (object.contains("cards") && object["cards"].is_object()) {
            for (const auto& [card, value] : object["cards"].items()) {
                run.cards[card] =
                    number(object["cards"], card.c_str(), path + "cards.", -1e30, 1e30);
            }
        }
        if (object.contains("warnings") && object["warnings"].is_array())
            for (const json& warning : object["warnings"])
                run.warnings.push_back(warning.is_string() ? warning.get<std::string>() : "");
        for (const SpectrumKey& spectrum : spectrumKeys) {
            if (object.contains(spectrum.key) || spectrum.values == &SpectralRun::transmittance) {
                run.*spectrum.values = numbers(object, spectrum.key, path, 0.0, spectrum.largest);
                if ((run.*spectrum.values).size() != wavenumbers.size()) {
                    report(path + spectrum.key,
                           std::to_string((run.*spectrum.values).size()) + " values",
                           std::to_string(wavenumbers.size()) + ", one for each wavenumber");
                }
            }
        }
        const bool radiates =
            run.kind == RunKind::thermalRadiance || run.kind == RunKind::solarRadiance;
        if (radiates &&
            (run.pathRadiance_W_m2_sr_um.empty() || run.totalRadiance_W_m2_sr_um.empty())) {
            report(where, "no radiances", "path and total radiance in a run of this kind");
        }
        if (run.kind == RunKind::sunlight && run.solarIrradiance_W_m2_um.empty())
            report(where, "no solar irradiance", "it in a run of this kind");
        return run;
    }

    const std::string& file_;
    json root_;
    JsonPlaces places_;
    std::vector<Diagnostic> diagnostics_;
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
                   : parseModtranJson(text, file.string());
    }
    return parseTape7(TextLines::parse(text, file.string()));
}

} // namespace

std::string TabulatedAtmosphere::toText() const {
    ordered_json root = {{"format", formatName}, {"version", formatVersion}, {"name", name_}};
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
        try {
            std::vector<SpectralRun> some = readRuns(file);
            const auto isNamesake = [&](const std::filesystem::path& other) {
                return &other != &file && other.filename() == file.filename();
            };
            if (std::ranges::any_of(files, isNamesake))
                for (SpectralRun& run : some)
                    run.source = (file.parent_path().filename() / run.source).string();
            std::ranges::move(some, std::back_inserter(runs));
        } catch (const InputError& error) {
            diagnostics.insert(diagnostics.end(), error.diagnostics().begin(),
                               error.diagnostics().end());
        }
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
