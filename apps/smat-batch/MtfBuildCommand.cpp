#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/smat-batch/MtfCommand.h"
#include "apps/smat-batch/NumberOptions.h"
#include "apps/smat-batch/Output.h"
#include "apps/smat-batch/StopSignal.h"
#include "irsg/atmosphere/engine/Particles.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/core/ProgramVersion.h"
#include "irsg/radiometry/Units.h"
#include "irsg/scattering/MtfBuild.h"
#include "irsg/scattering/PhaseFunction.h"
#include "smatcore/data/ResultTable.h"
#include "smatcore/support/Log.h"

namespace smat::batch {

namespace {

/// "1,2,3" or "1:2,3:4" as numbers.
std::vector<std::vector<double>> lists(const char* option, const std::string& text,
                                       const char* expected) {
    std::vector<std::vector<double>> result;
    std::istringstream entries(text);
    for (std::string entry; std::getline(entries, entry, ',');) {
        result.emplace_back();
        std::istringstream parts(entry);
        for (std::string part; std::getline(parts, part, ':');) {
            const auto number = irsg::parseNumber(part);
            if (!number)
                throw refusal(option, text, expected);
            result.back().push_back(*number);
        }
    }
    return result;
}

/// `smat-batch mtf build --out FILE.mtf`.
class MtfBuildCommand {
  public:
    explicit MtfBuildCommand(CLI::App& command) : numbers_(command) {
        const auto word = [&](const char* option, auto& text, const char* type, const char* help) {
            command.add_option(option, text, help)->type_name(type);
        };
        word("--out", out_, "FILE", "The database, .mtf");
        word("--table", table_, "FILE", "Its curves with their standard errors, .csv or .json");
        word("--method", method_, "WORD", "small-angle (default) or monte-carlo");
        word("--droplets", droplets_, "WORD",
             "single (default), gamma, log-normal, advection-fog or radiation-fog; the fogs are "
             "those of Shettle and Fenn 1979");
        word("--aerosol", aerosol_, "WORD",
             "In place of droplets, the aerosol of an AtmosphereSmart at the ground: rural, urban, "
             "maritime, navy-maritime, tropospheric or desert");
        numbers_.add("--humidity", "%", "Relative humidity of the aerosol, 0 to 99, 80 by default");
        numbers_.add("--diameter", "um",
                     "Of single droplets, or mode (gamma) or median (log-normal); 100 by default");
        numbers_.add("--width", "X",
                     "Of a gamma distribution (3 by default), or the geometric standard deviation "
                     "of a log-normal one (1.5)");
        numbers_.add("--wavelength", "um", "0.4 to 14, 4 by default; droplets are water");
        word("--optical-depths", depths_, "LIST",
             "Scattering optical depths, 0.25,0.5,1,2,3,4,6,8 by default");
        word("--layers", layers_, "LIST",
             "THICKNESS:CONCENTRATION of each layer from the sensor to the target, relative; one "
             "by default");
        numbers_.add("--fov", "deg",
                     "Full angle that haze is meant for, beyond which it is cut; 60 by default");
        numbers_.add("--frequencies", "N", "Points of a curve, 201 by default");
        numbers_.add("--lowest-frequency", "1/rad", "Behind 0; 0.05 cycles per rad by default");
        numbers_.add("--highest-frequency", "1/rad", "100000 cycles per rad by default");
        numbers_.add("--photons", "N", "For each optical depth, 1000000 by default");
        numbers_.add("--seed", "S", "Of the photons, 1 by default");
    }

    int run(const Context& context) const {
        const irsg::MtfRecipe recipe = this->recipe();
        recipe.check();
        catchStopSignal();
        const std::filesystem::path part = out_ + ".part";
        const bool isLong = recipe.method == irsg::MtfRecipe::Method::monteCarlo;
        std::optional<irsg::BuiltMtf> built;
        try {
            ProgressLine line;
            bool isTracing = false;
            const auto begun = std::chrono::steady_clock::now();
            built = irsg::buildMtf(
                recipe,
                [&](double fraction) {
                    const std::chrono::duration<double> elapsed =
                        std::chrono::steady_clock::now() - begun;
                    if (!isTracing && fraction > 0.2) {
                        isTracing = true;
                        logInfo(isLong ? "tracing photons" : "transforming");
                    }
                    line.show({static_cast<std::size_t>(1000.0 * fraction), 1000, elapsed.count(),
                               isLong ? "photons" : "droplets"});
                    return !stopWasAsked();
                },
                isLong ? std::optional(part) : std::nullopt);
        } catch (const irsg::Cancelled&) {
            warn(isLong ? "stopped; the same command goes on from " + part.string()
                        : std::string("stopped; nothing was written"));
            return warned;
        }
        built->database.write(out_);
        if (!table_.empty())
            tableOf(*built, context).save(table_);
        std::error_code ignored;
        std::filesystem::remove(part, ignored);
        tell(*built, context);
        return done;
    }

  private:
    void take(const char* option, double& number) const {
        if (const auto given = numbers_.value(option))
            number = *given;
    }

    irsg::SizeDistribution sizes() const {
        using irsg::SizeDistribution;
        const std::string kind = droplets_.value_or("single");
        if (kind == "advection-fog" || kind == "radiation-fog") {
            for (const char* option : {"--diameter", "--width"})
                if (const auto given = numbers_.value(option))
                    throw refusal(option, irsg::numberText(*given),
                                  "nothing: the fog has sizes of its own");
            return kind == "advection-fog" ? SizeDistribution::advectionFog()
                                           : SizeDistribution::radiationFog();
        }
        SizeDistribution sizes;
        if (kind == "gamma")
            sizes = {SizeDistribution::Kind::gamma, 50.0, 3.0};
        else if (kind == "log-normal")
            sizes = {SizeDistribution::Kind::logNormal, 50.0, 1.5};
        else if (kind != "single")
            throw wordRefusal("--droplets", kind,
                              {"single", "gamma", "log-normal", "advection-fog", "radiation-fog"});
        double diameter_um = 2.0 * sizes.radius_um;
        take("--diameter", diameter_um);
        sizes.radius_um = 0.5 * diameter_um;
        take("--width", sizes.width);
        return sizes;
    }

    std::optional<irsg::HazeAerosol> aerosol(double wavelength_um) const {
        using irsg::AerosolModel;
        const auto humidity_percent = numbers_.value("--humidity");
        if (aerosol_.empty()) {
            if (humidity_percent)
                throw refusal("--humidity", irsg::numberText(*humidity_percent),
                              "nothing without --aerosol: droplets do not depend on it");
            return std::nullopt;
        }
        static const std::vector<std::pair<std::string, AerosolModel>> models = {
            {"rural", AerosolModel::rural},
            {"urban", AerosolModel::urban},
            {"maritime", AerosolModel::maritime},
            {"navy-maritime", AerosolModel::navyMaritime},
            {"tropospheric", AerosolModel::tropospheric},
            {"desert", AerosolModel::desert}};
        const auto found =
            std::ranges::find(models, aerosol_, &std::pair<std::string, AerosolModel>::first);
        if (found == models.end()) {
            std::vector<std::string> words;
            for (const auto& [word, model] : models)
                words.push_back(word);
            throw wordRefusal("--aerosol", aerosol_, words);
        }
        if (droplets_)
            throw refusal("--droplets", *droplets_, "nothing beside --aerosol");
        for (const char* option : {"--diameter", "--width"})
            if (const auto given = numbers_.value(option))
                throw refusal(option, irsg::numberText(*given),
                              "nothing beside --aerosol, whose sizes are its own");
        const double percent = humidity_percent.value_or(80.0);
        if (!(percent >= 0.0 && percent <= 99.0))
            throw refusal("--humidity", irsg::numberText(percent), "0 to 99 %");
        const irsg::ParticleOptics optics =
            irsg::aerosolOptics(found->second, 0.01 * percent, wavelength_um);
        return irsg::HazeAerosol{aerosol_, 1.0 - optics.absorption / optics.extinction,
                                 optics.asymmetry};
    }

    irsg::MtfRecipe recipe() const {
        numbers_.check();
        if (out_.empty() || std::filesystem::path(out_).extension() != ".mtf")
            throw refusal("--out", out_.empty() ? "nothing" : out_, "a file that ends in .mtf");
        if (const std::string kind = std::filesystem::path(table_).extension().string();
            !table_.empty() && kind != ".csv" && kind != ".json")
            throw refusal("--table", table_, "a file that ends in .csv or .json");
        irsg::MtfRecipe recipe;
        if (method_ == "monte-carlo")
            recipe.method = irsg::MtfRecipe::Method::monteCarlo;
        else if (method_ != "small-angle")
            throw wordRefusal("--method", method_, {"small-angle", "monte-carlo"});
        take("--wavelength", recipe.wavelength_um);
        recipe.aerosol = aerosol(recipe.wavelength_um);
        if (!recipe.aerosol)
            recipe.sizes = sizes();
        if (!depths_.empty()) {
            recipe.opticalDepths.clear();
            for (const auto& entry : lists("--optical-depths", depths_, "numbers, as 0.5,1,2"))
                recipe.opticalDepths.insert(recipe.opticalDepths.end(), entry.begin(), entry.end());
        }
        if (!layers_.empty()) {
            const char* expected = "THICKNESS:CONCENTRATION of each layer, as 1:2,3:0";
            recipe.layers.clear();
            for (const auto& entry : lists("--layers", layers_, expected)) {
                if (entry.size() != 2)
                    throw refusal("--layers", layers_, expected);
                recipe.layers.push_back({entry[0], entry[1]});
            }
        }
        double fov_deg = 60.0;
        take("--fov", fov_deg);
        recipe.fieldOfView_rad = irsg::radians(fov_deg);
        numbers_.takeWhole("--frequencies", recipe.frequencies);
        take("--lowest-frequency", recipe.lowestFrequency_per_rad);
        take("--highest-frequency", recipe.highestFrequency_per_rad);
        numbers_.takeWhole("--photons", recipe.photons);
        numbers_.takeWhole("--seed", recipe.seed);
        return recipe;
    }

    static ResultTable tableOf(const irsg::BuiltMtf& built, const Context& context) {
        ResultTable table;
        table.provenance.add("program", irsg::programWithVersion());
        table.provenance.add("command", context.commandLine);
        const irsg::MtfDatabase& database = built.database;
        table.add("frequency", "rad-1").values = database.frequencies_per_rad();
        for (std::size_t m = 0; m < database.opticalDepths().size(); ++m) {
            const std::string depth = irsg::numberText(database.opticalDepths()[m]);
            table.add("mtf_" + depth, "").values = database.values(m);
            if (!built.standardErrors.empty())
                table.add("error_mtf_" + depth, "").values = built.standardErrors[m];
        }
        return table;
    }

    void tell(const irsg::BuiltMtf& built, const Context& context) const {
        if (context.json) {
            nlohmann::ordered_json json = mtfAsJson(out_);
            json["albedo"] = built.albedo;
            json["asymmetry"] = built.asymmetry;
            json["forward_share"] = built.forwardFraction;
            fmt::print("{}\n", jsonText(json));
            return;
        }
        fmt::print("{}\n", out_);
        for (const std::string& line : built.database.description())
            fmt::print("  {}\n", line);
        fmt::print("  particles: albedo {:.4g}, asymmetry {:.4g}, scattered forward {:.4g}\n",
                   built.albedo, built.asymmetry, built.forwardFraction);
    }

    NumberOptions numbers_;
    std::string out_, table_, method_ = "small-angle", aerosol_, depths_, layers_;
    std::optional<std::string> droplets_;
};

} // namespace

void addMtfBuildCommand(CLI::App& mtf, Context& context) {
    addCommand<MtfBuildCommand>(
        mtf, context, "build",
        "Makes a database: Mie theory with the small-angle theory or traced photons");
}

} // namespace smat::batch
