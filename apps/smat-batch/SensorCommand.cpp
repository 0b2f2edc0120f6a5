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

/// `smat-batch sensor info FILE.smatsensor --background-temperature 300`.
class SensorInfoCommand {
  public:
    explicit SensorInfoCommand(CLI::App& command) : numbers_(command) {
        command.add_option("FILE", file_, "Sensor (.smatsensor)")->required()->type_name("");
        numbers_.add("--background-temperature", "K",
                     "Of the background that fills the field, 300");
        numbers_.add("--temperature-difference", "K",
                     "Of an area before it, for its signal to noise ratio");
        numbers_.add("--point-irradiance", "W m-2",
                     "Of a point on the pupil in the band, the same");
    }

    int run(Context& context) const {
        numbers_.check();
        SensorNumbersRequest request;
        request.background_K = numbers_.value("--background-temperature").value_or(300.0);
        if (!(request.background_K > 0.0))
            throw refusal("--background-temperature", irsg::numberText(request.background_K),
                          "a temperature above 0 K");
        request.temperatureDifference_K = numbers_.value("--temperature-difference").value_or(0.0);
        request.pointIrradiance_W_m2 = numbers_.value("--point-irradiance").value_or(0.0);
        const auto json = sensorNumbersJson(irsg::loadSensor(file_), request);
        if (json.at("well_fill").get<double>() >= 1.0)
            warn(file_ + ": pixels are full before this background; its numbers are those of a "
                         "larger well");
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
        numbers_.add("--source-temperature", "K",
                     "Black body whose spectrum weighs the wavelengths, 300");
        command.footer("Columns: frequency, one for each component, and their product, system.");
    }

    int run(Context& context) const {
        files_.check("mtf.csv");
        numbers_.check();
        const double source_K = numbers_.value("--source-temperature").value_or(300.0);
        if (!(source_K > 0.0))
            throw refusal("--source-temperature", irsg::numberText(source_K),
                          "a temperature above 0 K");
        if (direction_ != "horizontal" && direction_ != "vertical")
            throw wordRefusal("--direction", direction_, {"horizontal", "vertical"});
        const std::vector<double> frequencies = frequencies_per_rad();
        ResultTable table = sensorTransferTable(irsg::loadSensor(file_), frequencies,
                                                direction_ == "vertical", source_K);
        table.provenance.add("sensor file", file_);
        files_.write("sensor mtf", table, {}, {}, context.json);
        return done;
    }

  private:
    std::vector<double> frequencies_per_rad() const {
        std::vector<double> list;
        for (std::size_t begin = 0; begin <= frequencies_.size();) {
            const std::size_t end = std::min(frequencies_.find(',', begin), frequencies_.size());
            const std::string text = frequencies_.substr(begin, end - begin);
            const auto value = irsg::parseNumber(irsg::trimmed(text));
            if (!value || *value < 0.0)
                throw refusal("--frequencies", text.empty() ? "nothing" : text,
                              "numbers of at least 0, separated by commas");
            list.push_back(*value);
            begin = end + 1;
        }
        return list;
    }

    std::string file_, frequencies_, direction_ = "horizontal";
    NumberOptions numbers_;
    TableFiles files_;
};

} // namespace

void addSensorCommand(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand(
        "sensor", "What a sensor makes of radiance: numbers, transfer functions");
    command->require_subcommand(1);
    addCommand<SensorInfoCommand>(*command, context, "info",
                                  "Signal, noise and sensitivity before a background");
    addCommand<SensorTransferCommand>(*command, context, "mtf",
                                      "Transfer function by component over spatial frequency");
}

} // namespace smat::batch
