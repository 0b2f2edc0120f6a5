#include <algorithm>
#include <iterator>

#include "apps/smat-batch/Command.h"
#include "apps/smat-batch/NumberOptions.h"
#include "irsg/core/Collect.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Band.h"
#include "smatcore/tools/GasInput.h"
#include "smatcore/tools/GasLayerText.h"

namespace smat::batch {

namespace {

std::vector<std::string> sourceWords() {
    return {irsg::gasSourceNames.begin(), irsg::gasSourceNames.end()};
}

/// `smat-batch gas --layer T_K=700,p_atm=1,length_m=0.5,CO2=0.033 --band 3-5 --out FILE.csv`.
class GasCommand {
  public:
    explicit GasCommand(CLI::App& command) : numbers_(command), files_(command) {
        const auto several = [](CLI::Option* option, const char* type) {
            option->type_name(type)->expected(1)->take_all();
        };
        several(
            command.add_option("--layer", layers_,
                               "A uniform layer: T_K=700,p_atm=1,length_m=0.5 with the mole "
                               "fractions CO2, H2O, CO, CH4 and O2, and soot_ppmv; the rest is "
                               "nitrogen. May be given more than once, in order from the sensor"),
            "LAYER");
        command.add_option("--band", band_, "Spectral band MIN-MAX")
            ->type_name("um")
            ->capture_default_str();
        numbers_.add("--step", "cm-1", "Width of the spectral cells, 1 to 100; 5 by default");
        command
            .add_option("--source", source_,
                        oneOf(sourceWords(), "") + ": source of the absorption of each gas")
            ->type_name("WORD")
            ->capture_default_str();
        numbers_.add(
            "--background-temperature", "K",
            "Temperature of a black body behind the layers; without it nothing radiates there");
        several(command.add_option("--atmosphere", atmosphere_,
                                   "Atmosphere or Environment file between gas and sensor; of "
                                   "several, the first that covers the band is used"),
                "FILE");
        numbers_.add("--altitude", "m", "Altitude of the gas, with --atmosphere");
        numbers_.add("--range", "m", "Range from sensor to gas, with --atmosphere");
        numbers_.add("--sensor-altitude", "m",
                     "Altitude of the sensor, with --atmosphere; that of the gas by default");
        command.footer(
            "Transmittance and radiance of layers of hot gas: the spectrum, the band radiance, "
            "what each gas adds to it, and the source of each gas with its stated error.");
    }

    int run(Context& context) const {
        files_.check("gas.csv", context.json);
        const GasInput input = checkedInput();
        GasOutputRequest request;
        {
            const StageTimer::Scope scope(&context.timer, "load");
            request = gasOutputRequest(input);
        }
        request.commandLine = context.commandLine;
        GasOutput output;
        {
            const StageTimer::Scope scope(&context.timer, "compute");
            output = gasOutput(request);
        }
        const StageTimer::Scope scope(&context.timer, "save");
        files_.write("gas", output.table, output.summary, output.warnings, context.json);
        return done;
    }

  private:
    /// Every diagnostic of the options at once.
    GasInput checkedInput() const {
        std::vector<irsg::Diagnostic> diagnostics;
        const auto collect = [&](const auto& work) { irsg::collect(diagnostics, work); };
        GasInput input;
        for (std::size_t i = 0; i < layers_.size(); ++i)
            collect([&] {
                input.gas.layers.push_back(
                    gasLayerFromText(layers_[i], "--layer " + std::to_string(i + 1)));
            });
        if (layers_.empty())
            diagnostics.push_back({"--layer", "", "nothing",
                                   std::string("a layer, such as --layer ") + gasLayerExample});
        collect([&] { input.gas.band = irsg::Band::fromText(band_).range(); });
        collect([&] { numbers_.check(); });
        const std::vector<std::string> words = sourceWords();
        const auto word = std::ranges::find(words, source_);
        if (word == words.end())
            diagnostics.push_back({"--source", "", source_, oneOf(words, source_)});
        else
            input.gas.source = static_cast<irsg::GasSource>(word - words.begin());
        if (const auto step = numbers_.value("--step"))
            input.gas.step_per_cm = *step;
        input.gas.background_K = numbers_.value("--background-temperature");
        input.atmosphere = {atmosphere_.begin(), atmosphere_.end()};
        input.altitude_m = numbers_.value("--altitude");
        input.range_m = numbers_.value("--range");
        input.sensorAltitude_m = numbers_.value("--sensor-altitude");
        // What cannot be read is no request to be checked.
        std::ranges::move(diagnostics.empty() ? gasInputDiagnostics(input)
                                              : gasPathDiagnostics(input),
                          std::back_inserter(diagnostics));
        if (!diagnostics.empty())
            throw irsg::InputError(std::move(diagnostics));
        return input;
    }

    NumberOptions numbers_;
    std::vector<std::string> layers_, atmosphere_;
    std::string band_ = "3-5", source_ = irsg::gasSourceNames.front();
    TableFiles files_;
};

} // namespace

void addGasCommand(CLI::App& app, Context& context) {
    addCommand<GasCommand>(app, context, AnalysisKind::gas);
}

} // namespace smat::batch
