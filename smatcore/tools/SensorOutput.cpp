#include "smatcore/tools/SensorOutput.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "irsg/core/Errors.h"
#include "irsg/core/ProgramVersion.h"
#include "irsg/core/Wording.h"
#include "irsg/radiometry/Units.h"
#include "irsg/sensor/PointSpread.h"
#include "irsg/sensor/SensorNumbers.h"
#include "irsg/sensor/SensorTransfer.h"

namespace smat {

namespace {

using Direction = irsg::ResolvableTemperature::Direction;

void requireFrequency(double frequency_per_rad) {
    if (!(frequency_per_rad >= 0.0 && std::isfinite(frequency_per_rad)))
        throw irsg::InputError({"", "frequency", irsg::numberText(frequency_per_rad),
                                "a number of at least 0 cycles/rad"});
}

using Json = nlohmann::ordered_json;

Json signalJson(const irsg::PixelSignal& signal) {
    return {{"scene", signal.scene},
            {"optics", signal.optics},
            {"housing", signal.housing},
            {"dark", signal.dark},
            {"total", signal.total()}};
}

Json noiseJson(const irsg::PixelNoise& noise) {
    return {{"photon", noise.photon},   {"dark", noise.dark},
            {"read", noise.read},       {"quantisation", noise.quantisation},
            {"thermal", noise.thermal}, {"temporal", noise.temporal()},
            {"pattern", noise.pattern}, {"total", noise.total()}};
}

Json numbersJson(const irsg::SensorDescription& sensor, const irsg::SensorNumbers& numbers,
                 const SensorNumbersRequest& request) {
    const bool isThermal = sensor.detector.isThermal();
    Json json;
    json[isThermal ? "absorbed_W" : "electrons"] = signalJson(numbers.signal);
    json[isThermal ? "noise_W" : "noise_electrons"] = noiseJson(numbers.noise);
    json["netd_K"] = numbers.netd_K;
    json["netd_total_K"] = numbers.totalNetd_K;
    json["ner_W_m2_sr"] = numbers.ner_W_m2_sr;
    json["nei_W_m2"] = numbers.nei_W_m2;
    json["nei_whole_point_W_m2"] = numbers.neiWholePoint_W_m2;
    json["nei_total_W_m2"] = numbers.totalNei_W_m2;
    json["nep_W"] = numbers.nep_W;
    json["d_star_cm_sqrtHz_W"] = numbers.dStar_cm_sqrtHz_W;
    json["well_fill"] = numbers.wellFill;
    json["dynamic_range_dB"] = numbers.dynamicRange_dB;
    if (request.temperatureDifference_K != 0.0)
        json["snr_area"] = std::abs(request.temperatureDifference_K) / numbers.netd_K;
    if (request.pointIrradiance_W_m2 != 0.0)
        json["snr_point"] = std::abs(request.pointIrradiance_W_m2) / numbers.nei_W_m2;
    return json;
}

constexpr std::pair<irsg::ConeConvention, const char*> conventions[] = {
    {irsg::ConeConvention::exact, "1/(4F^2+1)"}, {irsg::ConeConvention::smallAngle, "1/(4F^2)"}};

/// One line for each number, objects within objects with their key before.
void addLines(std::string& text, const Json& json, const std::string& before) {
    for (const auto& [key, value] : json.items()) {
        const std::string name = before.empty() ? key : before + "." + key;
        if (value.is_object())
            addLines(text, value, name);
        else if (value.is_number())
            text += fmt::format("  {:<34} {}\n", name, irsg::roundedText(value.get<double>()));
        else
            text += fmt::format("  {:<34} {}\n", name, value.get<std::string>());
    }
}

/// How a table came to be in which an observer looks.
void tellObserved(ResultTable& table, const char* analysis, const irsg::SensorDescription& sensor,
                  double background_K, const irsg::Observer& observer) {
    Provenance& provenance = table.provenance;
    provenance.add("program", irsg::programWithVersion());
    provenance.add("analysis", analysis);
    provenance.add("sensor", sensor.title);
    provenance.add("background temperature", irsg::numberText(background_K) + " K");
    provenance.add("observer threshold", irsg::numberText(observer.threshold));
    provenance.add("eye integration time", irsg::numberText(observer.integration_s) + " s");
    provenance.add("frame rate", irsg::numberText(sensor.electronics.frameRate_Hz) + " Hz");
}

} // namespace

Json sensorNumbersJson(const irsg::SensorDescription& sensor, const SensorNumbersRequest& request) {
    const irsg::PointSpread spread(sensor, request.background_K);
    const double centre = spread.energyAt(0.0, 0.0);
    const irsg::Sensor pinhole = sensor.pinhole();
    const double halfHeight = 0.5 * sensor.detector.rows * sensor.pixelAngle_rad();
    Json json = {{"title", sensor.title},
                 {"source", sensor.source},
                 {"background_temperature_K", request.background_K},
                 {"f_number", sensor.optics.fNumber()},
                 {"pixel_angle_urad", 1e6 * sensor.pixelAngle_rad()},
                 {"horizontal_field_of_view_deg", irsg::degrees(pinhole.horizontalFieldOfView_rad)},
                 {"vertical_field_of_view_deg", irsg::degrees(2.0 * std::atan(halfHeight))},
                 {"peak_signal_per_joule", sensor.peakSignalPerJoule()},
                 {"ensquared_energy",
                  {{"centre", centre},
                   {"edge", spread.energyAt(0.5, 0.0)},
                   {"corner", spread.energyAt(0.5, 0.5)}}}};
    Json both;
    for (const auto& [convention, name] : conventions) {
        Json numbers = numbersJson(
            sensor, irsg::sensorNumbers(sensor, request.background_K, convention, centre), request);
        if (convention == irsg::ConeConvention::exact) {
            json["convention"] = name;
            json.update(numbers);
        }
        both[name] = std::move(numbers);
    }
    json["by_convention"] = std::move(both);
    json["conventions"] = {
        {"1/(4F^2+1)", "a pixel sees the pupil in the projected solid angle of a flat disc, "
                       "pi/(4F^2+1), less its obscuration"},
        {"1/(4F^2)", "the same for small angles, area of the pupil / focal length^2"},
        {"field_of_view", "full angles of the whole detector"},
        {"netd_K", "temporal noise / change of the scene's signal per K; netd_total_K with the "
                   "pattern noise"},
        {"nei_W_m2", "irradiance on the pupil in the band, weighted by the response relative to "
                     "its peak, of a point in the middle of a pixel whose signal is the temporal "
                     "noise, with ensquared energy; nei_whole_point_W_m2 without, nei_total_W_m2 "
                     "with the pattern noise"},
        {"ner_W_m2_sr", "radiance in the band, weighted the same, whose signal is the temporal "
                        "noise"},
        {"d_star_cm_sqrtHz_W", "of the detector's active area in a bandwidth of 1/(2 integration "
                               "time), at the peak of its response, with all temporal noise"},
        {"dynamic_range_dB", "20 lg of what is left of well and converter without a scene over "
                             "the temporal noise without one"}};
    return json;
}

std::string sensorNumbersText(const Json& numbers) {
    std::string text;
    Json shown = numbers;
    shown.erase("by_convention");
    addLines(text, shown, "");
    return text;
}

ResultTable sensorTransferTable(const irsg::SensorDescription& sensor,
                                const std::vector<double>& frequencies_per_rad, bool isVertical,
                                double source_K) {
    const irsg::SensorTransfer transfer(sensor, source_K);
    ResultTable table;
    table.add("frequency", "cycles rad-1");
    for (const auto& component : transfer.components(0.0, 0.0))
        table.add(component.name, "");
    table.add("system", "");
    for (const double frequency : frequencies_per_rad) {
        requireFrequency(frequency);
        const double x = isVertical ? 0.0 : frequency, y = isVertical ? frequency : 0.0;
        std::vector<double> row{frequency};
        for (const auto& component : transfer.components(x, y))
            row.push_back(component.value);
        row.push_back(transfer.at(x, y));
        table.addRow(row);
    }
    table.provenance.add("program", irsg::programWithVersion());
    table.provenance.add("analysis", "sensor mtf");
    table.provenance.add("sensor", sensor.title);
    table.provenance.add("direction", isVertical ? "vertical" : "horizontal");
    table.provenance.add("source temperature", irsg::numberText(source_K) + " K");
    return table;
}

ResultTable resolvableTemperatureTable(const irsg::SensorDescription& sensor,
                                       const std::vector<double>& frequencies_per_rad,
                                       double background_K, const irsg::Observer& observer) {
    const irsg::ResolvableTemperature resolvable(sensor, background_K, observer);
    ResultTable table;
    table.add("frequency", "cycles rad-1");
    table.add("mrtd_horizontal", "K");
    table.add("mrtd_vertical", "K");
    table.add("mrtd", "K");
    for (const double frequency : frequencies_per_rad) {
        requireFrequency(frequency);
        std::vector<double> row = {frequency, resolvable.mrtd_K(frequency, Direction::horizontal),
                                   resolvable.mrtd_K(frequency, Direction::vertical),
                                   resolvable.mrtd_K(frequency)};
        std::ranges::replace_if(
            row, [](double value) { return std::isinf(value); },
            std::numeric_limits<double>::quiet_NaN());
        table.addRow(row);
    }
    tellObserved(table, "sensor mrtd", sensor, background_K, observer);
    return table;
}

ResultTable nominalRangeTable(const irsg::SensorDescription& sensor,
                              const std::vector<double>& extinctions_per_km,
                              const irsg::NominalTarget& target, double background_K,
                              const irsg::Observer& observer) {
    const irsg::ResolvableTemperature resolvable(sensor, background_K, observer);
    ResultTable table;
    table.add("line_pairs", "");
    table.add("extinction", "km-1");
    table.add("range", "m");
    for (const irsg::JohnsonTask& task : irsg::nominalTasks())
        for (const double extinction_per_km : extinctions_per_km) {
            irsg::NominalTarget behind = target;
            behind.extinction_per_km = extinction_per_km;
            table.addRow({task.cyclesOfHalf, extinction_per_km,
                          irsg::nominalRange_m(resolvable, behind, task.cyclesOfHalf)});
        }
    tellObserved(table, "sensor range", sensor, background_K, observer);
    table.provenance.add("target side", irsg::numberText(target.side_m) + " m");
    table.provenance.add("target temperature difference",
                         irsg::numberText(target.difference_K) + " K");
    return table;
}

} // namespace smat
