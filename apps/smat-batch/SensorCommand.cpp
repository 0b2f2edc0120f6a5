#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/smat-batch/Command.h"
#include "apps/smat-batch/NumberOptions.h"
#include "apps/smat-batch/Output.h"
#include "irsg/core/CsvTable.h"
#include "irsg/sensor/SensorFile.h"
#include "smatcore/tools/SensorOutput.h"

namespace smat::batch {

namespace {

void addObserver(NumberOptions& numbers) {
    numbers.add("--background-temperature", "K",
                "Temperature of the background that fills the field, 300 by default");
    numbers.add("--threshold", "",
                "Perceived signal to noise ratio at which bars are visible, 2.5 by default");
    numbers.add("--eye-time", "s", "Time over which the eye averages frames, 0.2 by default");
}

irsg::Observer observerOf(const NumberOptions& numbers) {
    irsg::Observer observer;
    observer.threshold = numbers.positive("--threshold", observer.threshold, "a number above 0");
    observer.integration_s =
        numbers.positive("--eye-time", observer.integration_s, "a time above 0 s");
    return observer;
}

double backgroundOf(const NumberOptions& numbers) {
    return numbers.positive("--background-temperature", 300.0, "a temperature above 0 K");
}

/// `smat-batch sensor info FILE.smatsensor --background-temperature 300`.
class SensorInfoCommand {
  public:
    explicit SensorInfoCommand(CLI::App& command) : numbers_(command) {
        command.add_option("FILE", file_, "Sensor (.smatsensor)")->required()->type_name("");
        numbers_.add("--background-temperature", "K",
                     "Temperature of the background that fills the field, 300 by default");
        numbers_.add("--temperature-difference", "K",
                     "Temperature of an area in front of it, for its signal to noise ratio");
        numbers_.add("--point-irradiance", "W m-2",
                     "Irradiance of a point on the pupil in the band, for the same");
    }

    int run(Context& context) const {
        numbers_.check();
        SensorNumbersRequest request;
        request.background_K = backgroundOf(numbers_);
        request.temperatureDifference_K = numbers_.value("--temperature-difference").value_or(0.0);
        request.pointIrradiance_W_m2 = numbers_.value("--point-irradiance").value_or(0.0);
        const auto json = sensorNumbersJson(irsg::loadSensor(file_), request);
        if (json.at("well_fill").get<double>() >= 1.0)
            warn(
                file_ +
                ": pixels saturate before this background; the numbers are those of a larger well");
        if (!std::isfinite(json.at("netd_K").get<double>()))
            warn(file_ + ": this background radiates nothing in the sensor's band: the NETD is "
                         "infinite");
        if (context.json)
            fmt::print("{}\n", jsonText(json));
        else
            fmt::print("{}\n{}", file_, sensorNumbersText(json));
        return done;
    }

  private:
    std::string file_;
    NumberOptions numbers_;
};

/// `smat-batch sensor mtf FILE.smatsensor --frequencies 0,500,1000 --out m.csv`.
class SensorTransferCommand {
  public:
    explicit SensorTransferCommand(CLI::App& command) : numbers_(command), files_(command) {
        command.add_option("FILE", file_, "Sensor (.smatsensor)")->required()->type_name("");
        command
            .add_option("--frequencies", frequencies_,
                        "Spatial frequencies, separated by commas: 0,500,1000")
            ->type_name("cycles/rad");
        command
            .add_option("--direction", direction_,
                        "horizontal, along the rows, or vertical, along the columns")
            ->type_name("WORD")
            ->capture_default_str();
        numbers_.add(
            "--source-temperature", "K",
            "Temperature of the black body whose spectrum weights the wavelengths, 300 by default");
        command.footer("Columns: frequency, one for each component, and their product, system.");
    }

    int run(Context& context) const {
        files_.check("mtf.csv", context.json);
        numbers_.check();
        const double source_K =
            numbers_.positive("--source-temperature", 300.0, "a temperature above 0 K");
        if (direction_ != "horizontal" && direction_ != "vertical")
            throw wordRefusal("--direction", direction_, {"horizontal", "vertical"});
        ResultTable table =
            sensorTransferTable(irsg::loadSensor(file_), numbersOf("--frequencies", frequencies_),
                                direction_ == "vertical", source_K);
        table.provenance.add("sensor file", file_);
        files_.write("sensor mtf", table, {}, {}, context.json);
        return done;
    }

  private:
    std::string file_, frequencies_, direction_ = "horizontal";
    NumberOptions numbers_;
    TableFiles files_;
};

/// `smat-batch sensor mrtd FILE.smatsensor --frequencies 500,1000 --out mrtd.csv`.
class SensorResolvableCommand {
  public:
    explicit SensorResolvableCommand(CLI::App& command) : numbers_(command), files_(command) {
        command.add_option("FILE", file_, "Sensor (.smatsensor)")->required()->type_name("");
        command
            .add_option("--frequencies", frequencies_,
                        "Spatial frequencies, separated by commas: 500,1000")
            ->type_name("cycles/rad");
        addObserver(numbers_);
        command.footer(
            "Columns: frequency, and the minimum resolvable temperature difference along rows, "
            "along columns and for both together; docs/sensor.md explains the convention.");
    }

    int run(Context& context) const {
        files_.check("mrtd.csv", context.json);
        numbers_.check();
        ResultTable table = resolvableTemperatureTable(
            irsg::loadSensor(file_), numbersOf("--frequencies", frequencies_),
            backgroundOf(numbers_), observerOf(numbers_));
        table.provenance.add("sensor file", file_);
        files_.write("sensor mrtd", table, {}, {}, context.json);
        return done;
    }

  private:
    std::string file_, frequencies_;
    NumberOptions numbers_;
    TableFiles files_;
};

/// `smat-batch sensor range FILE.smatsensor --out ranges.csv`.
class SensorRangeCommand {
  public:
    explicit SensorRangeCommand(CLI::App& command) : numbers_(command), files_(command) {
        command.add_option("FILE", file_, "Sensor (.smatsensor)")->required()->type_name("");
        command
            .add_option(
                "--extinctions", extinctions_,
                "Extinction of the atmosphere, separated by commas: good and limited visibility")
            ->type_name("1/km")
            ->capture_default_str();
        numbers_.add("--temperature-difference", "K", "Of the target, 2");
        numbers_.add("--target-size", "m", "Its side, 2.3");
        addObserver(numbers_);
        command.footer("Columns: line pairs across the target (1 detection, 3 recognition, 6 "
                       "identification), extinction, and the range at which they are just "
                       "resolved, as STANAG 4347 defines it (docs/sensor.md).");
    }

    int run(Context& context) const {
        files_.check("ranges.csv", context.json);
        numbers_.check();
        irsg::NominalTarget target;
        target.side_m = numbers_.positive("--target-size", target.side_m, "a length above 0 m");
        target.difference_K = numbers_.positive("--temperature-difference", target.difference_K,
                                                "a difference above 0 K");
        ResultTable table =
            nominalRangeTable(irsg::loadSensor(file_), numbersOf("--extinctions", extinctions_),
                              target, backgroundOf(numbers_), observerOf(numbers_));
        table.provenance.add("sensor file", file_);
        files_.write("sensor range", table, {}, {}, context.json);
        return done;
    }

  private:
    std::string file_, extinctions_ = "0.2,1";
    NumberOptions numbers_;
    TableFiles files_;
};

} // namespace

void addSensorCommand(CLI::App& app, Context& context) {
    CLI::App* command =
        app.add_subcommand("sensor", "Numbers, transfer functions and ranges of a sensor");
    command->require_subcommand(1);
    addCommand<SensorInfoCommand>(*command, context, "info",
                                  "Signal, noise and sensitivity before a background");
    addCommand<SensorTransferCommand>(*command, context, "mtf",
                                      "Transfer function by component over spatial frequency");
    addCommand<SensorResolvableCommand>(
        *command, context, "mrtd",
        "Minimum resolvable temperature difference over spatial frequency");
    addCommand<SensorRangeCommand>(*command, context, "range",
                                   "Nominal static ranges of a thermal imager (STANAG 4347)");
}

} // namespace smat::batch
