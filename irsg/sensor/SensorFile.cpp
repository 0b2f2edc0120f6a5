#include "irsg/sensor/SensorFile.h"

#include <cmath>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/core/JsonHead.h"
#include "irsg/core/JsonReader.h"
#include "irsg/core/ProgramVersion.h"

namespace irsg {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* formatName = "smat-sensor";
constexpr int newestVersion = 1;
constexpr std::uint64_t largestSensor_B = 16u << 20;

const std::vector<std::string>& pupilWords() {
    static const std::vector<std::string> words = {"circular", "annular", "square"};
    return words;
}

struct ResponseKey {
    ResponseKind kind;
    const char* key;
};
constexpr ResponseKey responseKeys[] = {
    {ResponseKind::quantumEfficiency, "quantumEfficiency"},
    {ResponseKind::responsivity_A_per_W, "responsivity_A_per_W"},
    {ResponseKind::absorptance, "absorptance"}};

/// A number, or {"wavelength_um": [...], "values": [...]}.
Spectrum spectrumOf(const JsonReader& value, const std::string& name) {
    if (value.json().is_number() || !value.exists())
        return Spectrum::constant(value.number());
    if (!value.isObject("a number, or wavelength_um and values"))
        return Spectrum::constant(1.0);
    const std::vector<double> wavelengths_um = value.at("wavelength_um").numbers();
    const std::vector<double> values = value.at("values").numbers();
    value.refuseUnknown();
    Spectrum spectrum = Spectrum::constant(1.0);
    if (value.isAnyRefused())
        return spectrum;
    value.check(
        [&] { spectrum = Spectrum(wavelengths_um, values, Spectrum::Outside::hold, name); });
    return spectrum;
}

SensorOptics opticsOf(const JsonReader& object) {
    SensorOptics optics;
    if (!object.isObject())
        return optics;
    if (const JsonReader pupil = object.at("pupil"); pupil.exists())
        optics.pupil = static_cast<PupilShape>(pupil.word(pupilWords()));
    optics.aperture_m = object.at("aperture_m").number();
    if (object.has("fNumber")) {
        object.refuseMember("focalLength_m", "either focalLength_m or fNumber");
        optics.focalLength_m = object.at("fNumber").number() * optics.aperture_m;
    } else {
        optics.focalLength_m = object.at("focalLength_m").number();
    }
    optics.obscuration = object.at("obscuration").numberOr(0.0);
    optics.transmission = spectrumOf(object.at("transmission"), "transmission");
    optics.temperature_K = object.at("temperature_K").numberOr(0.0);
    optics.emissivity = object.at("emissivity").numberOr(0.0);
    optics.coldShieldEfficiency = object.at("coldShieldEfficiency").numberOr(1.0);
    optics.housingTemperature_K = object.at("housingTemperature_K").numberOr(0.0);
    optics.defocus_waves = object.at("defocus_waves").numberOr(0.0);
    optics.defocusWavelength_um = object.at("defocusWavelength_um").numberOr(0.0);
    optics.aberrationBlur_urad = object.at("aberrationBlur_urad").numberOr(0.0);
    return optics;
}

SensorDetector detectorOf(const JsonReader& object) {
    SensorDetector detector;
    if (!object.isObject())
        return detector;
    detector.pitch_um = object.at("pitch_um").number();
    detector.fillFactor = object.at("fillFactor").numberOr(1.0);
    detector.columns = object.at("columns").index();
    detector.rows = object.at("rows").index();
    detector.integrationTime_s = object.at("integrationTime_s").number();
    const JsonReader band = object.at("band_um");
    if (const auto ends = band.numbers(2, 1e6, "a list of two wavelengths, [3, 5]"))
        detector.band = {ends->at(0), ends->at(1)};
    int found = 0;
    for (const ResponseKey& known : responseKeys)
        if (const JsonReader response = object.at(known.key); response.exists()) {
            detector.responseKind = known.kind;
            detector.response = spectrumOf(response, known.key);
            ++found;
        }
    if (found != 1)
        object.refuse(found == 0 ? "no response" : "several responses",
                      "one of quantumEfficiency, responsivity_A_per_W and absorptance");
    detector.well_e = object.at("well_e").numberIfAny();
    detector.darkCurrent_e_per_s = object.at("darkCurrent_e_per_s").numberOr(0.0);
    detector.timeConstant_s = object.at("timeConstant_s").numberOr(0.0);
    detector.thermalNetd_K = object.at("netd_K").numberIfAny();
    detector.thermalNetdTemperature_K = object.at("netdTemperature_K").numberOr(0.0);
    return detector;
}

SensorElectronics electronicsOf(const JsonReader& object, bool isThermal) {
    SensorElectronics electronics;
    if (!object.isObject())
        return electronics;
    const char* const key = isThermal ? "gain_W_per_count" : "gain_e_per_count";
    electronics.gain = object.at(key).number();
    electronics.offset_counts = object.at("offset_counts").numberOr(0.0);
    electronics.readNoise_e = object.at("readNoise_e").numberOr(0.0);
    electronics.bits = object.at("bits").index();
    electronics.frameRate_Hz = object.at("frameRate_Hz").numberOr(electronics.frameRate_Hz);
    return electronics;
}

SensorNoise noiseOf(const JsonReader& object) {
    SensorNoise noise;
    noise.referenceTemperature_K = object.at("referenceTemperature_K").numberOr(300.0);
    noise.tv = object.at("tv").numberOr(0.0);
    noise.th = object.at("th").numberOr(0.0);
    noise.t = object.at("t").numberOr(0.0);
    noise.vh = object.at("vh").numberOr(0.0);
    noise.v = object.at("v").numberOr(0.0);
    noise.h = object.at("h").numberOr(0.0);
    noise.deadPixelFraction = object.at("deadPixelFraction").numberOr(0.0);
    noise.hotPixelFraction = object.at("hotPixelFraction").numberOr(0.0);
    return noise;
}

Json jsonOf(const Spectrum& spectrum) {
    if (spectrum.isConstant())
        return spectrum.values().front();
    return {{"wavelength_um", spectrum.wavelengths_um()}, {"values", spectrum.values()}};
}

/// Leaves out what is as it would be without.
void put(Json& object, const char* key, double value, double otherwise) {
    if (value != otherwise)
        object[key] = value;
}

Json opticsJson(const SensorOptics& optics) {
    const SensorOptics none;
    Json object;
    object["pupil"] = pupilWords().at(static_cast<std::size_t>(optics.pupil));
    object["aperture_m"] = optics.aperture_m;
    object["focalLength_m"] = optics.focalLength_m;
    put(object, "obscuration", optics.obscuration, none.obscuration);
    object["transmission"] = jsonOf(optics.transmission);
    put(object, "temperature_K", optics.temperature_K, none.temperature_K);
    put(object, "emissivity", optics.emissivity, none.emissivity);
    put(object, "coldShieldEfficiency", optics.coldShieldEfficiency, none.coldShieldEfficiency);
    put(object, "housingTemperature_K", optics.housingTemperature_K, none.housingTemperature_K);
    put(object, "defocus_waves", optics.defocus_waves, none.defocus_waves);
    put(object, "defocusWavelength_um", optics.defocusWavelength_um, none.defocusWavelength_um);
    put(object, "aberrationBlur_urad", optics.aberrationBlur_urad, none.aberrationBlur_urad);
    return object;
}

Json detectorJson(const SensorDetector& detector) {
    Json object = {{"pitch_um", detector.pitch_um}};
    put(object, "fillFactor", detector.fillFactor, 1.0);
    object["columns"] = detector.columns;
    object["rows"] = detector.rows;
    object["integrationTime_s"] = detector.integrationTime_s;
    object["band_um"] = Json::array({detector.band.min_um, detector.band.max_um});
    for (const ResponseKey& known : responseKeys)
        if (known.kind == detector.responseKind)
            object[known.key] = jsonOf(detector.response);
    if (detector.well_e)
        object["well_e"] = *detector.well_e;
    put(object, "darkCurrent_e_per_s", detector.darkCurrent_e_per_s, 0.0);
    put(object, "timeConstant_s", detector.timeConstant_s, 0.0);
    if (detector.thermalNetd_K)
        object["netd_K"] = *detector.thermalNetd_K;
    put(object, "netdTemperature_K", detector.thermalNetdTemperature_K, 0.0);
    return object;
}

Json noiseJson(const SensorNoise& noise) {
    Json object = Json::object();
    put(object, "referenceTemperature_K", noise.referenceTemperature_K, 300.0);
    put(object, "tv", noise.tv, 0.0);
    put(object, "th", noise.th, 0.0);
    put(object, "t", noise.t, 0.0);
    put(object, "vh", noise.vh, 0.0);
    put(object, "v", noise.v, 0.0);
    put(object, "h", noise.h, 0.0);
    put(object, "deadPixelFraction", noise.deadPixelFraction, 0.0);
    put(object, "hotPixelFraction", noise.hotPixelFraction, 0.0);
    return object;
}

} // namespace

SensorDescription sensorFromJson(const std::string& text, const std::string& fileName) {
    const JsonForm form{.expected = "a sensor (JSON in UTF-8)", .deepest = 8};
    const JsonReader root(text, fileName, form, JsonErrors::collect);
    readJsonHead(root, formatName, newestVersion);
    SensorDescription sensor;
    sensor.title = root.at("title").textOr("");
    sensor.source = root.at("source").textOr("");
    sensor.optics = opticsOf(root.section("optics"));
    sensor.detector = detectorOf(root.section("detector"));
    if (const JsonReader motion = root.section("motion"); motion.exists() && motion.isObject()) {
        sensor.motion.jitter_urad = motion.at("jitter_urad").numberOr(0.0);
        sensor.motion.lineOfSightRate_urad_per_s =
            motion.at("lineOfSightRate_urad_per_s").numberOr(0.0);
    }
    sensor.electronics = electronicsOf(root.section("electronics"), sensor.detector.isThermal());
    if (const JsonReader noise = root.section("noise"); noise.exists() && noise.isObject())
        sensor.noise = noiseOf(noise);
    root.refuseUnknown();
    root.throwRefused();
    root.check([&] { sensor.check(); });
    root.throwRefused();
    return sensor;
}

SensorDescription loadSensor(const std::filesystem::path& file) {
    return sensorFromJson(readFile(file, largestSensor_B), file.string());
}

std::string sensorToJson(const SensorDescription& sensor) {
    Json root = {{"format", formatName},
                 {"version", newestVersion},
                 {"program", programWithVersion()},
                 {"title", sensor.title},
                 {"source", sensor.source},
                 {"optics", opticsJson(sensor.optics)},
                 {"detector", detectorJson(sensor.detector)}};
    Json motion = Json::object();
    put(motion, "jitter_urad", sensor.motion.jitter_urad, 0.0);
    put(motion, "lineOfSightRate_urad_per_s", sensor.motion.lineOfSightRate_urad_per_s, 0.0);
    if (!motion.empty())
        root["motion"] = std::move(motion);
    Json electronics;
    electronics[sensor.detector.isThermal() ? "gain_W_per_count" : "gain_e_per_count"] =
        sensor.electronics.gain;
    put(electronics, "offset_counts", sensor.electronics.offset_counts, 0.0);
    put(electronics, "readNoise_e", sensor.electronics.readNoise_e, 0.0);
    electronics["bits"] = sensor.electronics.bits;
    put(electronics, "frameRate_Hz", sensor.electronics.frameRate_Hz,
        SensorElectronics().frameRate_Hz);
    root["electronics"] = std::move(electronics);
    if (Json noise = noiseJson(sensor.noise); !noise.empty())
        root["noise"] = std::move(noise);
    return root.dump(1) + "\n";
}

void saveSensor(const SensorDescription& sensor, const std::filesystem::path& file) {
    sensor.check();
    writeFileDurably(file, sensorToJson(sensor));
}

} // namespace irsg
