#include "tools/atmosphere-tables/lines/CarbonDioxideLines.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "irsg/core/CsvTable.h"
#include "tools/atmosphere-tables/lines/LineListFile.h"

namespace irsg::lbl {

namespace {

constexpr double lowest_per_cm = 250.0;
constexpr double weakestGenerated = 1e-27;
constexpr double weakestBare = 2e-28;
constexpr double bareFrom_per_cm = 2000.0, bareTo_per_cm = 3333.34;
constexpr int bareHighestIsotopologue = 3;
constexpr double mainListTo_per_cm =
    2400.0; ///< CO2.par.gz has the main isotopologue from bareFrom on

/// Ranges for which CO2.par.gz has all lines of the first isotopologues up to a number.
struct Covered {
    double from_per_cm, to_per_cm;
    int highestIsotopologue;
};
constexpr Covered covered[] = {
    {600.0, 700.0, 2},   {700.0, 765.0, 9},   {800.0, 1200.0, 9},  {4000.0, 4900.0, 1},
    {4900.0, 5100.0, 9}, {5100.0, 5200.0, 1}, {6000.0, 6400.0, 1},
};

bool isCovered(const Line& line) {
    const double nu = line.wavenumber_per_cm;
    return (nu >= bareFrom_per_cm && nu < bareTo_per_cm &&
            line.isotopologue <= bareHighestIsotopologue) ||
           std::ranges::any_of(covered, [&](const auto& c) {
               return nu >= c.from_per_cm && nu < c.to_per_cm &&
                      line.isotopologue <= c.highestIsotopologue;
           });
}

} // namespace

std::vector<BareLine> readBareLines(const std::filesystem::path& file) {
    std::vector<BareLine> bare;
    std::vector<Diagnostic> diagnostics;
    const std::vector<std::string> lines = readTextLines(file);
    for (std::size_t i = 0; i < lines.size() && diagnostics.size() < 10; ++i) {
        std::istringstream words(lines[i]);
        std::string first, second, more;
        words >> first >> second >> more;
        if (first.empty())
            continue;
        const auto wavenumber = parseNumber(first), intensity = parseNumber(second);
        if (!more.empty() || !wavenumber || *wavenumber <= 0.0 || !intensity || *intensity < 0.0)
            diagnostics.push_back({file.string(), "line " + std::to_string(i + 1),
                                   "'" + lines[i] + "'", "wavenumber and intensity"});
        else
            bare.push_back({*wavenumber, *intensity});
    }
    if (bare.empty() && diagnostics.empty())
        diagnostics.push_back({file.string(), "", "no line", "wavenumbers and intensities"});
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    std::ranges::stable_sort(bare, {}, &BareLine::wavenumber_per_cm);
    return bare;
}

std::vector<Line> describedLines(std::span<const BareLine> bare, std::span<const Line> generated,
                                 const Line& otherwise, double near_per_cm) {
    constexpr double widest = 3.0;
    std::vector<Line> described;
    described.reserve(bare.size());
    for (const BareLine& line : bare) {
        const Line* best = nullptr;
        double bestDistance = 2.0 * widest * widest;
        auto next = std::ranges::lower_bound(
            generated, line.wavenumber_per_cm - widest * near_per_cm, {}, &Line::wavenumber_per_cm);
        for (; next != generated.end() &&
               next->wavenumber_per_cm <= line.wavenumber_per_cm + widest * near_per_cm;
             ++next) {
            const double away = (next->wavenumber_per_cm - line.wavenumber_per_cm) / near_per_cm;
            const double factor = std::log(next->intensity / line.intensity) / std::log(1.5);
            const double distance = away * away + factor * factor;
            if (distance < bestDistance) {
                bestDistance = distance;
                best = &*next;
            }
        }
        described.push_back(best ? *best : otherwise);
        described.back().wavenumber_per_cm = line.wavenumber_per_cm;
        described.back().intensity = line.intensity;
    }
    return described;
}

std::vector<BareLine> missingLines(std::span<const BareLine> bare, std::span<const Line> list) {
    // The surest pairs first, so that no line is taken by a neighbour that resembles it.
    struct Likeness {
        double near_per_cm, factor;
    };
    constexpr Likeness likenesses[] = {{1e-4, 1.02}, {1e-3, 1.1}, {2e-3, 1.3}, {8e-3, 1.05}};
    std::vector<char> taken(list.size(), 0), found(bare.size(), 0);
    for (const auto& [near_per_cm, factor] : likenesses)
        for (std::size_t i = 0; i < bare.size(); ++i) {
            if (found[i])
                continue;
            std::size_t best = list.size();
            double bestDistance = near_per_cm;
            auto place = static_cast<std::size_t>(
                std::ranges::lower_bound(list, bare[i].wavenumber_per_cm - near_per_cm, {},
                                         &Line::wavenumber_per_cm) -
                list.begin());
            for (; place < list.size() &&
                   list[place].wavenumber_per_cm <= bare[i].wavenumber_per_cm + near_per_cm;
                 ++place) {
                const double ratio = list[place].intensity / bare[i].intensity;
                const double distance =
                    std::abs(list[place].wavenumber_per_cm - bare[i].wavenumber_per_cm);
                if (!taken[place] && ratio < factor && ratio > 1.0 / factor &&
                    distance <= bestDistance) {
                    bestDistance = distance;
                    best = place;
                }
            }
            if (best < list.size())
                taken[best] = found[i] = 1;
        }
    std::vector<BareLine> missing;
    for (std::size_t i = 0; i < bare.size(); ++i)
        if (!found[i])
            missing.push_back(bare[i]);
    return missing;
}

LineList completeCarbonDioxide(const std::filesystem::path& folder) {
    const std::filesystem::path listFile = folder / "CO2.par.gz";
    const std::filesystem::path bandFile =
        folder / "extra" / "CO2_BandInfo_HITRAN2008_Lamouroux.dat.gz";
    LineList list = readLineList(Gas::CO2, listFile);
    const CarbonDioxideLevels levels(readTextLines(listFile), listFile.string());

    std::vector<Line> generated;
    for (const CarbonDioxideBand& band :
         readCarbonDioxideBands(readTextLines(bandFile), bandFile.string()))
        for (const Line& line : bandLines(band, levels))
            generated.push_back(line);
    std::ranges::stable_sort(generated, {}, &Line::wavenumber_per_cm);

    // Positions and strengths of isotopologues 1 to 3 are known here; the rest comes from the
    // bands.
    std::vector<BareLine> bare = readBareLines(folder / "extra" / "CO2_nu_S_2000-3333.txt.gz");
    std::erase_if(bare, [](const BareLine& line) { return line.intensity < weakestBare; });
    Line otherwise;
    otherwise.lowerEnergy_per_cm = 1500.0;
    levels.widths(30).applyTo(otherwise);
    std::vector<Line> candidates = generated;
    std::erase_if(candidates, [](const Line& line) {
        return line.isotopologue > bareHighestIsotopologue ||
               (line.isotopologue == 1 && line.wavenumber_per_cm < mainListTo_per_cm);
    });
    const std::vector<Line> described =
        describedLines(missingLines(bare, list.lines), candidates, otherwise);

    list.lines.insert(list.lines.end(), described.begin(), described.end());
    std::ranges::copy_if(generated, std::back_inserter(list.lines), [](const Line& line) {
        return line.wavenumber_per_cm >= lowest_per_cm && line.intensity >= weakestGenerated &&
               !isCovered(line);
    });
    std::ranges::stable_sort(list.lines, {}, &Line::wavenumber_per_cm);
    list.origins = {
        "CO2 lines at 600-765, 800-1200, 2000-2400, 4000-5200 and 6000-6400 cm-1: HITRAN2016 and "
        "HITRAN2020 (Gordon et al. 2017, J. Quant. Spectrosc. Radiat. Transfer 203, 3; Gordon et "
        "al. 2022, J. Quant. Spectrosc. Radiat. Transfer 277, 107949); strengths to a few percent",
        "CO2 lines at 2000-3333 cm-1 that these lack (isotopologues 2 and 3 everywhere, 1 beyond "
        "2400 cm-1): positions and strengths of HITRAN, lower energies and widths from the "
        "generated bands; strengths to 5 percent",
        "CO2 lines elsewhere, and isotopologues missing above: generated from band strengths "
        "(Lamouroux et al. 2010, J. Quant. Spectrosc. Radiat. Transfer 111, 2321), levels of "
        "assigned HITRAN lines and Hoenl-London factors; positions to 0.05 cm-1, strengths to 10 "
        "percent"};
    return list;
}

} // namespace irsg::lbl
