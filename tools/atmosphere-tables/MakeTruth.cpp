#include "tools/atmosphere-tables/Command.h"

#include <atomic>
#include <cstdio>
#include <iostream>
#include <mutex>
#include <string>
#include <thread>

#include <zlib.h>

#include "irsg/core/Errors.h"
#include "tools/atmosphere-tables/lines/CompleteLines.h"
#include "tools/atmosphere-tables/lines/LineByLineColumn.h"
#include "tools/atmosphere-tables/lines/TruthPaths.h"

namespace smat::tables {

namespace {

using namespace irsg;
using namespace irsg::lbl;

/// Levels at which absorption is computed line by line.
std::vector<double> levels_m() {
    std::vector<double> levels;
    auto steps = [&](double from_m, double to_m, double step_m) {
        for (double z = from_m; z < to_m - 1.0; z += step_m)
            levels.push_back(z);
    };
    steps(0.0, 3000.0, 375.0);
    steps(3000.0, 12000.0, 500.0);
    steps(12000.0, 30000.0, 2000.0);
    steps(30000.0, 50000.0, 5000.0);
    for (const double z : {50e3, 60e3, 75e3, 100e3})
        levels.push_back(z);
    return levels;
}

/// One atmosphere in one band: rows of text.
std::string rows(const std::vector<LineList>& gases, const PartitionSums& partition, int atmosphere,
                 const TruthBand& band) {
    const Profile profile = Profile::model(static_cast<ModelAtmosphere>(atmosphere));
    const LineByLineColumn column(gases, partition, profile, levels_m(), band.lower_per_cm,
                                  band.upper_per_cm, band.lower_per_cm < 2400.0 ? 0.001 : 0.002);
    const RayTracer tracer(profile, levels_m());
    std::string text;
    for (std::size_t p = 0; p < truthPaths.size(); ++p) {
        const auto means = column.along(tracer.between(truthPaths[p]), truthBinWidth_per_cm);
        for (std::size_t bin = 0; bin < means.transmittance.size(); ++bin) {
            char row[96];
            std::snprintf(row, sizeof row, "%d,%zu,%g,%.5f,%.4e\n", atmosphere, p,
                          band.lower_per_cm + truthBinWidth_per_cm * static_cast<double>(bin),
                          means.transmittance[bin], means.radiance_W_m2_sr_per_cm[bin]);
            text += row;
        }
    }
    return text;
}

} // namespace

void makeTruth(const Folders& folders) {
    const PartitionSums partition = PartitionSums::read(folders.data / "lines" / "partition");
    const std::vector<LineList> gases = completeLineLists(folders.data);
    constexpr std::size_t atmospheres = 6;
    std::vector<std::string> texts(atmospheres * truthBands.size());
    std::atomic<std::size_t> next = 0;
    std::mutex output;
    auto run = [&] {
        for (std::size_t i = next++; i < texts.size(); i = next++) {
            const TruthBand& band = truthBands[i / atmospheres];
            texts[i] = rows(gases, partition, static_cast<int>(i % atmospheres) + 1, band);
            const std::lock_guard lock(output);
            std::cout << "atmosphere " << i % atmospheres + 1 << ", " << band.lower_per_cm << "-"
                      << band.upper_per_cm << " cm-1" << std::endl;
        }
    };
    std::vector<std::jthread> workers;
    for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
        workers.emplace_back(run);
    workers.clear();

    std::string all =
        "# Transmittance and thermal radiance of molecular air, computed line by line\n"
        "# recipe: atmosphere-tables truth; the lines of gases.gastable, absorption at 43 levels\n"
        "# units: bins of 5 cm-1 from their lower end; radiance W m-2 sr-1 per cm-1\n"
        "atmosphere,path,lower_per_cm,transmittance,radiance\n";
    for (const std::string& text : texts)
        all += text;
    const auto file = folders.out / "line-by-line.csv.gz";
    gzFile out = gzopen(file.c_str(), "wb9");
    const bool written = out && gzwrite(out, all.data(), static_cast<unsigned>(all.size())) ==
                                    static_cast<int>(all.size());
    if (!out || gzclose(out) != Z_OK || !written)
        throw InputError(Diagnostic{file.string(), "", "cannot be written", "a writable folder"});
}

} // namespace smat::tables
