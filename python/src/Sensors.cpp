#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "irsg/sensor/SensorChain.h"
#include "irsg/sensor/SensorFile.h"
#include "python/src/OpenProjects.h"
#include "python/src/Results.h"
#include "smatcore/analysis/Detection.h"
#include "smatcore/analysis/DetectionCheck.h"
#include "smatcore/support/NearestNames.h"
#include "smatcore/tools/SensorOutput.h"

namespace smat::python {

namespace {

using irsg::SensorDescription;
using Plane = py::array_t<float, py::array::c_style | py::array::forcecast>;
using Table = std::shared_ptr<ResultTable>;

/// A sensor with the file that it is from.
struct FileSensor {
    SensorDescription description;
    std::filesystem::path file;
};

double positive(const char* argument, double value, const char* expected) {
    if (!(value > 0.0 && std::isfinite(value)))
        throw badArgument(argument, irsg::numberText(value), expected);
    return value;
}

std::size_t wordOf(const char* argument, const std::string& word,
                   const std::vector<std::string>& words) {
    const auto found = std::ranges::find(words, word);
    if (found == words.end())
        throw badArgument(argument, word, oneOf(words, word));
    return static_cast<std::size_t>(found - words.begin());
}

py::object numbersOf(const FileSensor& sensor, double background_K, double difference_K,
                     double irradiance_W_m2) {
    const std::string text = withoutLock([&] {
        return sensorNumbersJson(sensor.description, {background_K, difference_K, irradiance_W_m2})
            .dump();
    });
    return py::module_::import("json").attr("loads")(text);
}

Table transferOf(const FileSensor& sensor, const Numbers& frequencies_per_rad,
                 const std::string& direction, double source_K) {
    const bool isVertical = wordOf("direction", direction, {"horizontal", "vertical"}) == 1;
    const std::vector<double> list = python::vectorOf(frequencies_per_rad, "frequencies_per_rad");
    return withoutLock([&] {
        return std::make_shared<ResultTable>(
            sensorTransferTable(sensor.description, list, isVertical, source_K));
    });
}

Table resolvableOf(const FileSensor& sensor, const Numbers& frequencies_per_rad,
                   double background_K, double threshold, double eyeTime_s) {
    const std::vector<double> list = python::vectorOf(frequencies_per_rad, "frequencies_per_rad");
    return withoutLock([&] {
        return std::make_shared<ResultTable>(resolvableTemperatureTable(
            sensor.description, list, background_K, {threshold, eyeTime_s}));
    });
}

Table nominalRangesOf(const FileSensor& sensor, const Numbers& extinctions_per_km, double side_m,
                      double difference_K, double background_K, double threshold,
                      double eyeTime_s) {
    const std::vector<double> list = python::vectorOf(extinctions_per_km, "extinctions_per_km");
    return withoutLock([&] {
        return std::make_shared<ResultTable>(nominalRangeTable(
            sensor.description, list, {.side_m = side_m, .difference_K = difference_K},
            background_K, {threshold, eyeTime_s}));
    });
}

std::shared_ptr<irsg::RadianceImage> readingOf(const FileSensor& sensor, const Plane& radiance,
                                               std::uint64_t seed, std::uint32_t frame) {
    const irsg::SensorDetector& detector = sensor.description.detector;
    const bool isPlane = radiance.ndim() == 2;
    const py::ssize_t samples = isPlane ? radiance.shape(1) / detector.columns : 0;
    if (!isPlane || samples < 1 || radiance.shape(1) != samples * detector.columns ||
        radiance.shape(0) != samples * detector.rows)
        throw badArgument(
            "radiance",
            isPlane ? std::to_string(radiance.shape(0)) + " x " + std::to_string(radiance.shape(1))
                    : std::to_string(radiance.ndim()) + " dimensions",
            "rows and columns of the detector, " + std::to_string(detector.rows) + " x " +
                std::to_string(detector.columns) + ", or the same whole multiple of both");
    auto image = std::make_shared<irsg::RadianceImage>(static_cast<int>(radiance.shape(1)),
                                                       static_cast<int>(radiance.shape(0)), "L",
                                                       "W m-2 sr-1");
    image->channels.front().values.assign(radiance.data(), radiance.data() + radiance.size());
    withoutLock([&] {
        irsg::readBySensor(*image, irsg::SensorChain(sensor.description), static_cast<int>(samples),
                           seed, frame);
    });
    return image;
}

RangeComparison comparisonOf(const py::dict& given) {
    RangeComparison comparison;
    comparison.against = static_cast<RangeAgainst>(
        wordOf("against", given["against"].cast<std::string>(), rangeAgainstWords()));
    if (!given["values"].is_none())
        for (const py::handle value : given["values"])
            comparison.values.push_back(py::isinstance<py::str>(value)
                                            ? value.cast<std::string>()
                                            : irsg::numberText(value.cast<double>()));
    if (!given["paint"].is_none())
        comparison.paint = given["paint"].cast<std::string>();
    if (!given["sun_of"].is_none())
        comparison.place = rangePlaceOf("sun_of", given["sun_of"].cast<std::string>());
    return comparison;
}

/// Arguments of another name than the command's options have with - for _.
constexpr std::pair<const char*, const char*> argumentNames[] = {
    {"clutter", "clutter_K"},
    {"ranges", "ranges_m"},
    {"nearest", "nearest_m"},
    {"farthest", "farthest_m"},
    {"scene-contrast", "scene_contrast_K"},
    {"display-pixel", "display_pixel_mrad"},
    {"display-luminance", "display_luminance_cd_m2"},
    {"background-temperature", "background_temperature_K"}};

std::string argumentOf(std::string option) {
    if (findSetting(option) != nullptr)
        return option;
    const auto named = std::ranges::find(argumentNames, option,
                                         [](const auto& pair) { return std::string(pair.first); });
    if (named != std::end(argumentNames))
        return named->second;
    std::ranges::replace(option, '-', '_');
    return option;
}

std::string optionOf(std::string argument) {
    const auto named = std::ranges::find(argumentNames, argument,
                                         [](const auto& pair) { return std::string(pair.second); });
    if (named != std::end(argumentNames))
        return named->first;
    std::ranges::replace(argument, '_', '-');
    return argument;
}

/// What is neither None nor False, an empty list or no draws.
GivenOptions givenOptions(const py::dict& request) {
    GivenOptions given{argumentOf};
    for (const auto& [key, value] : request) {
        const auto name = key.cast<std::string>();
        if (name == "settings")
            for (const auto& [setting, text] : value.cast<std::map<std::string, std::string>>())
                given.values[setting] = text;
        else if (PyObject_IsTrue(value.ptr()) == 1)
            given.values[optionOf(name)] = py::str(value).cast<std::string>();
    }
    return given;
}

DetectionRequest requestOf(const FileSensor& sensor, const py::dict& given) {
    DetectionRequest request;
    request.sensor = sensor.description;
    request.sensorFile = sensor.file;
    const auto number = [&](const char* key, double otherwise) {
        return given[key].is_none() ? otherwise
                                    : positive(key, given[key].cast<double>(), "a number above 0");
    };
    request.criterion = static_cast<RangeCriterion>(
        wordOf("criterion", given["criterion"].cast<std::string>(), criterionWords()));
    if (!given["point"].is_none())
        request.place = static_cast<PointPlace>(
            wordOf("point", given["point"].cast<std::string>(), pointPlaceWords()));
    request.threshold = number("snr", request.threshold);
    const std::size_t task =
        given["task"].is_none()
            ? 0
            : wordOf("task", given["task"].cast<std::string>(), rangeTaskWords());
    request.task.cyclesOfHalf = number("cycles", tasksOf(request.criterion)[task].cyclesOfHalf);
    request.task.probability = number("probability", request.task.probability);
    if (request.criterion == RangeCriterion::point && !given["probability"].is_none())
        request.pointProbability = request.task.probability;
    if (request.task.probability >= 1.0)
        throw badArgument("probability", irsg::numberText(request.task.probability),
                          "a number between 0 and 1, both exclusive");
    if (!given["false_alarms"].is_none())
        request.threshold = thresholdOfFalseAlarms(given["false_alarms"].cast<double>());
    if (!given["leave_out"].is_none())
        request.leftOut = given["leave_out"].cast<std::vector<std::string>>();
    if (py::isinstance<py::str>(given["clutter_K"])) {
        (void)wordOf("clutter_K", given["clutter_K"].cast<std::string>(), {"auto"});
        request.measuresClutter = true;
    } else {
        request.clutter_K = number("clutter_K", request.clutter_K);
    }
    request.findsSensitivity = given["sensitivity"].cast<bool>();
    if (!given["ranges_m"].is_none())
        for (const double range_m : given["ranges_m"].cast<std::vector<double>>())
            request.ranges_m.push_back(range_m);
    request.cases = static_cast<RangeCases>(
        wordOf("cases", given["cases"].cast<std::string>(), rangeCasesWords()));
    if (!given["against"].is_none())
        request.comparison = comparisonOf(given);
    constexpr long long mostDraws = 1'000'000;
    const auto draws = given["draws"].cast<long long>();
    if (draws < 0 || draws > mostDraws)
        throw badArgument("draws", std::to_string(draws), "a whole number from 0 to 1000000");
    request.draws = static_cast<std::size_t>(draws);
    request.display = {
        .pixel_mrad = number("display_pixel_mrad", request.display.pixel_mrad),
        .luminance_cd_m2 = number("display_luminance_cd_m2", request.display.luminance_cd_m2),
        .sceneContrast_K = number("scene_contrast_K", request.display.sceneContrast_K)};
    request.limits.nearest_m = number("nearest_m", request.limits.nearest_m);
    request.limits.farthest_m = number("farthest_m", request.limits.farthest_m);
    if (!given["background_temperature_K"].is_none())
        request.background_K = number("background_temperature_K", 0.0);
    checkDetection(request, givenOptions(given));
    return request;
}

std::shared_ptr<AnalysisData> detectionOf(const OpenProject& open, const FileSensor& sensor,
                                          const py::dict& given, const py::object& progress) {
    prepareProcess();
    const DetectionRequest request = requestOf(sensor, given);
    auto data = std::make_shared<AnalysisData>(analysisOf(open, name(kindOf(request.cases)), ""));
    data->name = name(detectionKind());
    data->commandLine = detectionCommand(data->project, data->settings, request, "detection.csv");
    PythonProgress watch(progress);
    withoutLock([&] {
        const Pool<JobRunner>::Lease runner(*open.runners);
        runner->scenes().setDatabaseOverrides(open.databases);
        runner->run(*data, request, {.progress = watch.callback(), .stop = watch.stop()});
    });
    watch.finish();
    warnOf(data->warnings);
    return data;
}

} // namespace

void addSensors(py::module_& module, ProjectClass& project) {
    py::class_<FileSensor>(module, "SensorDescription",
                           R"(A sensor from its pupil to its counts, as docs/sensor.md describes it.

Parameters
----------
file : str or os.PathLike
    A sensor (.smatsensor).

Raises
------
InputError
    For a file that is none, and a sensor that cannot be, with key and line.
)")
        .def(py::init([](const std::filesystem::path& file) {
                 return withoutLock([&] { return FileSensor{irsg::loadSensor(file), file}; });
             }),
             py::arg("file"))
        .def_property_readonly(
            "title", [](const FileSensor& sensor) { return sensor.description.title; }, "Its name.")
        .def_property_readonly(
            "source", [](const FileSensor& sensor) { return sensor.description.source; },
            "Where its numbers come from.")
        .def_property_readonly(
            "shape",
            [](const FileSensor& sensor) {
                return py::make_tuple(sensor.description.detector.rows,
                                      sensor.description.detector.columns);
            },
            "Rows and columns of the detector.")
        .def_property_readonly(
            "pixel_angle_rad",
            [](const FileSensor& sensor) { return sensor.description.pixelAngle_rad(); },
            "The angle of a pixel, rad.")
        .def_property_readonly(
            "band", [](const FileSensor& sensor) { return sensor.description.band(); },
            "Its response relative to the peak, as a Band.")
        .def("numbers", &numbersOf, py::arg("background_temperature_K") = 300.0, py::kw_only(),
             py::arg("temperature_difference_K") = 0.0, py::arg("point_irradiance_W_m2") = 0.0,
             R"(What `smat-batch sensor info --json` states before a background.

Parameters
----------
background_temperature_K : float
    Of a black body that fills the field, K, above 0.
temperature_difference_K : float
    Of an area before it, K; with one there is 'snr_area'.
point_irradiance_W_m2 : float
    Of a point on the pupil, W m-2 in the band; with one there is 'snr_point'.

Returns
-------
dict
    'netd_K', 'nei_W_m2', 'electrons' and more, with each convention in words ('conventions').
)")
        .def("transfer", &transferOf, py::arg("frequencies_per_rad"), py::kw_only(),
             py::arg("direction") = "horizontal", py::arg("source_temperature_K") = 300.0,
             R"(The modulation transfer function.

Parameters
----------
frequencies_per_rad : array_like, shape (n,)
    Spatial frequencies, cycles/rad, at least 0.
direction : {'horizontal', 'vertical'}
    Along the rows, or the columns.
source_temperature_K : float
    Of the black body whose spectrum weighs the wavelengths, K.

Returns
-------
Table
    'frequency', a column for each component, and their product, 'system'.
)")
        .def("resolvable_temperature", &resolvableOf, py::arg("frequencies_per_rad"), py::kw_only(),
             py::arg("background_temperature_K") = 300.0, py::arg("threshold") = 2.5,
             py::arg("eye_time_s") = 0.2,
             R"(The minimum resolvable temperature difference (MRTD), K.

Parameters
----------
frequencies_per_rad : array_like, shape (n,)
    Spatial frequencies, cycles/rad, at least 0.
background_temperature_K : float
    Of a black body that fills the field, K.
threshold : float
    Perceived signal to noise ratio at which an observer sees bars.
eye_time_s : float
    Over which his eye takes the mean of frames, s.

Returns
-------
Table
    'mrtd_horizontal', 'mrtd_vertical' and 'mrtd', NaN where bars are not resolved.
)")
        .def("nominal_ranges", &nominalRangesOf, py::arg("extinctions_per_km"), py::kw_only(),
             py::arg("target_size_m") = 2.3, py::arg("temperature_difference_K") = 2.0,
             py::arg("background_temperature_K") = 300.0, py::arg("threshold") = 2.5,
             py::arg("eye_time_s") = 0.2,
             R"(Nominal static ranges of a thermal imager as STANAG 4347 defines them.

Parameters
----------
extinctions_per_km : array_like, shape (n,)
    Of the atmosphere, 1/km, at least 0.
target_size_m : float
    Side of the target, m.
temperature_difference_K : float
    Of the target before the background, K.
background_temperature_K : float
    Of a black body that fills the field, K.
threshold : float
    Perceived signal to noise ratio at which an observer sees bars.
eye_time_s : float
    Over which his eye takes the mean of frames, s.

Returns
-------
Table
    'line_pairs' (1 detection, 3 recognition, 6 identification), 'extinction' and 'range', m.

Raises
------
InputError
    For values that cannot be.
)")
        .def("read", &readingOf, py::arg("radiance"), py::kw_only(), py::arg("seed") = 1,
             py::arg("frame") = 0,
             R"(What the sensor makes of a picture: blur, noise, counts.

Parameters
----------
radiance : array_like, shape (n rows, n columns)
    Band radiance, W m-2 sr-1, of n squared samples for each pixel, top row first.
seed, frame : int
    The noise follows from them and the place of a pixel alone.

Returns
-------
Image
    Planes 'counts' and 'L', the apparent radiance that the counts stand for.

Raises
------
InputError
    For an array of another size.
)")
        .def("__repr__",
             [](const FileSensor& sensor) {
                 return "SensorDescription '" + sensor.description.title + "'";
             })
        .def(py::pickle(
            [](const FileSensor& sensor) {
                return py::make_tuple(sensorToJson(sensor.description), sensor.file);
            },
            [](const py::tuple& state) {
                const auto file = state[1].cast<std::filesystem::path>();
                return FileSensor{irsg::sensorFromJson(state[0].cast<std::string>(), file.string()),
                                  file};
            }));
    project.def("detection", &detectionOf, py::arg("sensor"), py::arg("options"),
                py::arg("progress"));
}

} // namespace smat::python
