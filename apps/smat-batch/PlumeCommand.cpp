#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "apps/smat-batch/Command.h"
#include "apps/smat-batch/NumberOptions.h"
#include "apps/smat-batch/Output.h"
#include "apps/smat-batch/StopSignal.h"
#include "irsg/core/Collect.h"
#include "irsg/core/CsvTable.h"
#include "irsg/gas/BentJet.h"
#include "irsg/gas/PlumePoints.h"
#include "irsg/radiometry/Band.h"
#include "smatcore/tools/PlumeJetText.h"
#include "smatcore/tools/PlumeModel.h"

namespace smat::batch {

namespace {

/// `smat-batch plume TABLE.csv --out plume.obj`.
class PlumeCommand {
  public:
    explicit PlumeCommand(CLI::App& command) : numbers_(command) {
        command
            .add_option("TABLE", table_,
                        "CSV with the columns x [m], r [m], T [K] of a plume about an axis, or x "
                        "[m], y [m], z [m], T [K] of points in space, and any of p [atm], CO2, "
                        "H2O, CO, CH4, O2, soot [ppmv]; or --jet")
            ->type_name("");
        command
            .add_option(
                "--jet", jet_,
                "In place of a table, the exhaust of a nozzle as a round turbulent jet: "
                "D_m=0.3,T_K=800,velocity_m_s=200,fuel_air=0.02 and any of air_K, coflow_m_s, "
                "p_atm, carbon, hydrogen, air_H2O, air_CO2, soot_ppmv, ends_at that differ from "
                "their defaults. With up_deg, the elevation of its axis, buoyancy lifts it; with "
                "wind_m_s and wind_from_deg (0 from ahead, 90 from starboard), wind bends it")
            ->type_name("KEY=NUMBER,...");
        command.add_option("--out", out_, "Model to write, with its codes and its database")
            ->type_name("FILE.obj");
        command.add_option("--band", band_, "Spectral band MIN-MAX in which the bound holds")
            ->type_name("um")
            ->capture_default_str();
        numbers_.add("--bound", "",
                     "Bound of the relative error of the radiant intensity; 0.01 by default");
        numbers_.add("--most-zones", "", "Greatest number of zones, 1 to 40; 16 by default");
        numbers_.add("--first-index", "",
                     "Temperature and material index of the outermost zone; 1 by default");
        command.footer(
            "Makes zones of gas from a plume: a model, its codes and its signature database. There "
            "are as many zones as it takes to keep the radiant intensity within the bound from "
            "beside, from the quarter and from behind; for points in space from above as well. The "
            "nozzle is at the origin; x points downstream, to the tail, y to starboard, z up.");
    }

    int run(Context& context) const {
        const PlumeRequest request = requestOf();
        PlumeModel plume;
        {
            const StageTimer::Scope scope(&context.timer, "compute");
            plume = jet_.empty() ? ofTable(request) : ofJet(request);
        }
        catchStopSignal(); // model, codes and database are those of one plume
        const StageTimer::Scope scope(&context.timer, "save");
        const auto files = savePlume(plume, out_);
        if (context.json)
            printJson(plume, files);
        else
            print(plume, files);
        return done;
    }

  private:
    PlumeModel ofTable(const PlumeRequest& request) const {
        const irsg::CsvTable csv = irsg::CsvTable::read(table_);
        return irsg::arePlumePoints(csv) ? plumeModel(irsg::readPlumePoints(csv), request)
                                         : plumeModel(irsg::PlumeTable::of(csv), request);
    }
    PlumeModel ofJet(const PlumeRequest& request) const {
        const PlumeJet jet = plumeJetFromText(jet_, "--jet");
        return jet.isStraight() ? plumeModel(jet.nozzle.table(), request)
                                : plumeModel(irsg::bentJetField(jet.bent().flow(96, 56)), request,
                                             jet.elevation_deg());
    }
    PlumeRequest requestOf() const {
        std::vector<irsg::Diagnostic> diagnostics;
        PlumeRequest request;
        irsg::collect(diagnostics, [&] { numbers_.check(); });
        if (table_.empty() == jet_.empty())
            diagnostics.push_back(
                {"plume", "", table_.empty() ? "nothing" : "TABLE and --jet", "a table or --jet"});
        irsg::collect(diagnostics, [&] { request.band = irsg::Band::fromText(band_).range(); });
        if (std::filesystem::path(out_).extension() != ".obj")
            diagnostics.push_back({"--out", "", out_.empty() ? "nothing" : out_, "FILE.obj"});
        request.bound = numbers_.value("--bound").value_or(request.bound);
        constexpr double largest = 0.5; // one zone of all gas, as long as the cold end, is within 1
        if (!(request.bound > 0.0 && request.bound <= largest))
            diagnostics.push_back({"--bound", "", irsg::numberText(request.bound),
                                   "a fraction of the radiant intensity above 0, at most 0.5: with "
                                   "a larger one a single zone up to the cold end would do"});
        irsg::collect(diagnostics,
                      [&] { numbers_.takeWhole("--most-zones", request.most, 1.0, 40.0); });
        irsg::collect(diagnostics,
                      [&] { numbers_.takeWhole("--first-index", request.firstIndex, 0.0, 1e6); });
        if (!diagnostics.empty())
            throw irsg::InputError(std::move(diagnostics));
        return request;
    }

    static void print(const PlumeModel& plume, const std::vector<std::filesystem::path>& files) {
        fmt::print("{} zones\n", plume.zones);
        std::size_t widest = 8;
        for (const irsg::PlumeZonesError& error : plume.errors)
            widest = std::max(widest, error.view.size());
        for (const irsg::PlumeZonesError& error : plume.errors)
            fmt::print("  {:<{}} {:.5g} W sr-1, of the table {:.5g}: {:+.2f} %\n", error.view,
                       widest, error.zones_W_sr, error.table_W_sr, 100.0 * error.relative());
        for (const std::filesystem::path& file : files)
            fmt::print("  {}\n", file.string());
    }

    static void printJson(const PlumeModel& plume,
                          const std::vector<std::filesystem::path>& files) {
        nlohmann::ordered_json json{{"zones", plume.zones}};
        for (const irsg::PlumeZonesError& error : plume.errors)
            json["views"].push_back({{"view", error.view},
                                     {"intensity_W_sr", error.zones_W_sr},
                                     {"intensity_table_W_sr", error.table_W_sr},
                                     {"error", error.relative()}});
        for (const std::filesystem::path& file : files)
            json["files"].push_back(file.string());
        fmt::print("{}\n", jsonText(json));
    }

    NumberOptions numbers_;
    std::string table_, jet_, out_, band_ = "3-5";
};

} // namespace

void addPlumeCommand(CLI::App& app, Context& context) {
    addCommand<PlumeCommand>(app, context, "plume",
                             "Makes zones of hot gas from a table of a plume");
}

} // namespace smat::batch
