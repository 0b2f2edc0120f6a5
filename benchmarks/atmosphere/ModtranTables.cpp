#include <cmath>

#include "benchmarks/atmosphere/Table.h"
#include "tests/atmosphere/ModtranRuns.h"

namespace irsg::accuracy {

namespace {

using namespace modtran;

/// File names of curves have no folders in them.
std::string flat(std::string name) {
    for (char& c : name)
        if (c == '/' || c == '.')
            c = '-';
    return name;
}

void writeSpectra(const Output& output, const std::string& name,
                  const ModtranComparison& comparison) {
    std::vector<Curve> curves = {{"wavenumber [cm-1]", comparison.wavenumbers_per_cm},
                                 {"transmittance ours [1]", comparison.transmittance},
                                 {"transmittance MODTRAN [1]", comparison.theirTransmittance}};
    if (!comparison.radiance.empty()) {
        curves.push_back({"path radiance ours [W m-2 sr-1 um-1]", comparison.radiance});
        curves.push_back({"path radiance MODTRAN [W m-2 sr-1 um-1]", comparison.theirRadiance});
    }
    writeCurves(output, "modtran-" + flat(name), name, curves);
}

void absorberTable(const Output& output) {
    const AbsorberComparisons comparisons = compareAbsorbers(output.data() / "modtran");
    std::vector<BandLimits> parts = {
        {"657-750", 657, 750},        {"750-980", 750, 980},       {"980-1080", 980, 1080},
        {"1080-1250", 1080, 1250},    {"1250-1400", 1250, 1400},   {"1400-2000", 1400, 2000},
        {"2000-2300", 2000, 2300},    {"2300-2500", 2300, 2500},   {"2500-3334", 2500, 3334},
        {"4000-6667", 4000, 6667},    {"6667-14286", 6667, 14286}, {"14286-25000", 14286, 25000},
        {"25000-40000", 25000, 40000}};
    Table table("Absorber by absorber, 5 km horizontal at the ground, tropical, 365 ppmv CO2: RMS "
                "and mean of ours − MODTRAN, 10 cm⁻¹",
                {"column", "cm⁻¹", "mean MODTRAN", "mean difference", "RMS", "largest"});
    std::vector<Curve> curves = {{"wavenumber [cm-1]", comparisons.wavenumbers_per_cm}};
    for (const AbsorberComparison& absorber : comparisons.absorbers) {
        curves.push_back({absorber.column + " ours [1]", absorber.ours});
        curves.push_back({absorber.column + " MODTRAN [1]", absorber.theirs});
        for (const BandLimits& part : parts) {
            double sum = 0.0, squares = 0.0, largest = 0.0, mean = 0.0, least = 1.0;
            int count = 0;
            for (std::size_t i = 0; i < comparisons.wavenumbers_per_cm.size(); ++i) {
                const double nu = comparisons.wavenumbers_per_cm[i];
                if (nu < part.lower_per_cm || nu >= part.upper_per_cm)
                    continue;
                const double difference = absorber.ours[i] - absorber.theirs[i];
                sum += difference;
                squares += difference * difference;
                largest = std::abs(difference) > std::abs(largest) ? difference : largest;
                mean += absorber.theirs[i];
                least = std::min({least, absorber.theirs[i], absorber.ours[i]});
                ++count;
            }
            if (count == 0 || least > 0.999)
                continue;
            table.add({absorber.column, part.name, text("%.4f", mean / count),
                       text("%+.4f", sum / count), text("%.4f", std::sqrt(squares / count)),
                       text("%+.3f", largest)});
        }
    }
    table.print();
    writeCurves(output, "modtran-absorbers", "absorber by absorber", curves);
}

} // namespace

void modtranTables(const Output& output) {
    Table table("Against MODTRAN, in-band",
                {"file", "µm", "τ ours", "τ MODTRAN", "difference", "L or E ours", "MODTRAN",
                 "difference", "of the bound", "held"});
    for (const PublishedFile& file : publishedFiles()) {
        const ModtranComparison comparison = compare(output.data() / "modtran", file);
        writeSpectra(output, file.name, comparison);
        for (const InBand& row : inBand(comparison, file))
            table.add(
                {file.name, row.band.name, text("%.4f", row.transmittance),
                 text("%.4f", row.theirTransmittance), text("%+.4f", row.transmittanceError()),
                 row.radiance ? text("%.4g", *row.radiance) : "",
                 row.radiance ? text("%.4g", *row.theirRadiance) : "",
                 row.radiance ? text("%+.2f %%", 100.0 * (*row.radiance / *row.theirRadiance - 1.0))
                              : "",
                 row.radiance ? text("%.2f", row.radianceShare()) : "",
                 row.holds() ? "yes" : "no"});
    }
    table.print();
    absorberTable(output);
}

} // namespace irsg::accuracy
