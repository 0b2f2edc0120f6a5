#include "tools/atmosphere-tables/lines/CompleteLines.h"

#include <algorithm>
#include <string>

#include "irsg/core/Errors.h"
#include "tools/atmosphere-tables/lines/CarbonDioxideLines.h"
#include "tools/atmosphere-tables/lines/LineListFile.h"
#include "tools/atmosphere-tables/lines/MethaneLines.h"
#include "tools/atmosphere-tables/lines/NitrousOxideLines.h"
#include "tools/atmosphere-tables/lines/OzoneLines.h"
#include "tools/atmosphere-tables/lines/PseudoLines.h"
#include "tools/atmosphere-tables/lines/PublishedRun.h"
#include "tools/atmosphere-tables/lines/StrengthScaling.h"

namespace irsg::lbl {

namespace {

constexpr double lowest_per_cm = 250.0;
constexpr double weakestMethane = 2e-26;

/// A range of wavenumbers for which a list has no line.
struct Gap {
    double from_per_cm, to_per_cm;
};

std::vector<Gap> gapsOf(Gas gas) {
    switch (gas) {
    case Gas::H2O:
        return {{250.0, 500.0}, {5405.4, 6000.0}, {6400.0, 17860.0}};
    case Gas::O3:
        return {{250.0, 650.0}, {750.0, 800.0}, {2670.0, 3260.0}};
    case Gas::CH4:
        return {{4100.0, 4690.0}, {5865.0, 6135.0}};
    default:
        return {};
    }
}

void addPseudoLines(LineList& list, const std::filesystem::path& dataFolder) {
    const std::vector<Gap> gaps = gapsOf(list.gas);
    if (gaps.empty())
        return;
    const LowtranBands bands = LowtranBands::read(dataFolder / "lowtran");
    std::string ranges;
    for (const Gap& gap : gaps) {
        const std::vector<Line> lines =
            pseudoLines(bands.points(list.gas, gap.from_per_cm - LowtranBands::step_per_cm,
                                     gap.to_per_cm + LowtranBands::step_per_cm),
                        pseudoGas(list.gas), gap.from_per_cm, gap.to_per_cm);
        list.lines.insert(list.lines.end(), lines.begin(), lines.end());
        ranges += (ranges.empty() ? "" : ", ") + numberText(gap.from_per_cm) + "-" +
                  numberText(gap.to_per_cm);
    }
    list.origins.push_back(
        std::string(gasNames[static_cast<std::size_t>(list.gas)]) + " at " + ranges +
        " cm-1: pseudo-lines whose transmittance over 20 cm-1 is that of LOWTRAN 7 (Kneizys et al. "
        "1988, AFGL-TR-88-0177); to 0.06 in transmittance, no detail finer than 20 cm-1");
}

/// Pseudo-lines of water whose LOWTRAN parameters are farther from MODTRAN than 0.06, brought
/// nearer.
void scalePseudoLines(LineList& list, const std::filesystem::path& dataFolder) {
    if (list.gas != Gas::H2O)
        return;
    const PublishedRun run = PublishedRun::read(dataFolder);
    const ScalingWindows windows{8000.0, 11000.0, 100.0};
    scaleStrengths(list,
                   {PublishedRun::air(), PublishedRun::length_cm, run.wavenumber_per_cm, run.water},
                   windows);
    list.origins.push_back(
        std::string(gasNames[static_cast<std::size_t>(list.gas)]) + " at " +
        numberText(windows.lower_per_cm) + "-" + numberText(windows.upper_per_cm) +
        " cm-1: pseudo-lines fitted to LOWTRAN 7, then scaled in windows of " +
        numberText(windows.width_per_cm) +
        " cm-1 to the column of this gas in a published MODTRAN run of 5 km of tropical air "
        "(horizon5kmtropical.fl7 of pyradi, C. J. Willers et al., MIT licence), from which LOWTRAN "
        "7 itself is 0.08 RMS away; to 0.06 in transmittance");
}

/// nu4 and nu2 of methane, where the list ends at 1200 cm-1 and begins again at 2000.
void addMethaneDyad(LineList& list) {
    const std::vector<Line> dyad = methaneDyadLines(list.lines);
    list.lines.insert(list.lines.end(), dyad.begin(), dyad.end());
    list.origins.push_back(
        "CH4 at 1200-1775 cm-1: nu4 and nu2 generated from an effective Hamiltonian of the dyad, "
        "fitted to the energies that HITRAN's hot bands and P branch hold (0.012 cm-1 rms up to J "
        "= 16), and a dipole fitted to the P branch at 850-1200 cm-1; strengths to a few percent; "
        "13CH4 moved, without CH3D and hot bands");
}

/// The bands of ozone at 9.6, 4.75 and around 5.7 um, whose lines the list lacks.
void addOzone(LineList& list, const std::filesystem::path& file) {
    const std::vector<Line> bands = ozoneLines(readTextLines(file));
    list.lines.insert(list.lines.end(), bands.begin(), bands.end());
    list.origins.push_back(
        "O3 at 983-1275 and 1630-2295 cm-1: generated from Watson's Hamiltonians of interacting "
        "states, fitted to the energies that HITRAN's hot bands and P branches hold (0.001 to 0.01 "
        "cm-1 rms), and dipoles fitted to its P branch below 983 cm-1 and to cross sections "
        "computed from it; strengths to 2 percent in nu3, 8 percent in nu1 + nu3 (16 at "
        "2060-2080 cm-1), 15 percent beside them");
}

// Where the list has all that is known of the main isotopologue of methane.
constexpr double methaneFrom_per_cm = 2832.8, methaneTo_per_cm = 3246.31;

/// Methane at 2000 to 3333 cm-1, where positions and strengths of all isotopologues are known.
/// Those that the list lacks are 13CH4's, and a few of CH3D: lower energies and widths are those of
/// the line of 12CH4 that stands as far from its band origin. Beyond the list they are assumed.
void addBareMethane(LineList& list, const std::filesystem::path& folder) {
    Line mean;
    const PseudoGas methane = pseudoGas(Gas::CH4);
    mean.lowerEnergy_per_cm = 300.0;
    mean.airWidth_cm_atm = methane.airWidth_cm_atm;
    mean.selfWidth_cm_atm = methane.selfWidth_cm_atm;
    mean.widthExponent = methane.widthExponent;
    std::vector<BareLine> inside, outside;
    for (const BareLine& bare : readBareLines(folder / "extra" / "CH4_nu_S_2000-3333.txt.gz")) {
        if (bare.intensity < weakestMethane)
            continue;
        const bool isInside = bare.wavenumber_per_cm > methaneFrom_per_cm &&
                              bare.wavenumber_per_cm < methaneTo_per_cm;
        (isInside ? inside : outside).push_back(bare);
    }
    std::vector<Line> listed;
    std::ranges::copy_if(list.lines, std::back_inserter(listed), [](const Line& line) {
        return line.wavenumber_per_cm > methaneFrom_per_cm - 1.0 &&
               line.wavenumber_per_cm < methaneTo_per_cm + 1.0;
    });
    Line rare = mean;
    rare.isotopologue = 2;
    const std::vector<Line> described =
        describedLines(missingLines(inside, listed), heavyMethane(listed), rare, 0.1);
    list.lines.insert(list.lines.end(), described.begin(), described.end());
    for (const BareLine& bare : outside) {
        list.lines.push_back(mean);
        list.lines.back().wavenumber_per_cm = bare.wavenumber_per_cm;
        list.lines.back().intensity = bare.intensity;
    }
    list.origins.push_back(
        "CH4 lines at 2833-3246 cm-1 that the list lacks (13CH4, CH3D): positions and strengths of "
        "HITRAN, lower energies and widths of 12CH4's lines moved by the distance of the nu3 "
        "origins; a few percent");
    list.origins.push_back(
        "CH4 at 2000-2833 and 3246-3333 cm-1: positions and strengths of HITRAN, "
        "with a lower energy of 300 cm-1 and widths of 0.055 cm-1 assumed for "
        "all lines; a few percent at 270 to 320 K, more beyond");
}

/// The isotopologues of nitrous oxide beside the main one where the list has that alone.
void addRareNitrousOxide(LineList& list, const std::filesystem::path& file) {
    const std::vector<Line> rare = rareNitrousOxide(readTextLines(file));
    list.lines.insert(list.lines.end(), rare.begin(), rare.end());
    list.origins.push_back(
        "N2O at 2000-2400 cm-1, 14N15N16O, 15N14N16O, 14N14N18O and 14N14N17O: the bands of the "
        "main "
        "isotopologue that raise v3 by 1, moved to the origins and rotational constants of Toth "
        "1987 (J. Opt. Soc. Am. B 4, 357) and Bogey 1975 (NIST), with HITRAN's abundances; "
        "positions "
        "to 0.05 cm-1, strengths to 5 percent");
}

std::string hitranOrigin(Gas gas) {
    const std::string name = gasNames[static_cast<std::size_t>(gas)];
    switch (gas) {
    case Gas::CO:
    case Gas::O2:
        return name + ": HITRAN2012 (Rothman et al. 2013, J. Quant. Spectrosc. Radiat. Transfer "
                      "130, 4); strengths to a few percent";
    case Gas::N2O:
        return name + " up to 7797 cm-1: HITRAN2008 to HITRAN2016 (Rothman et al. 2009, J. Quant. "
                      "Spectrosc. Radiat. Transfer 110, 533; Gordon et al. 2017, 203, 3); "
                      "strengths to a few percent";
    default:
        return name + " elsewhere: HITRAN2016 and HITRAN2020 (Gordon et al. 2017, J. Quant. "
                      "Spectrosc. Radiat. Transfer 203, 3; Gordon et al. 2022, 277, 107949); "
                      "strengths to a few percent";
    }
}

} // namespace

std::vector<Line> heavyMethane(const std::vector<Line>& listed) {
    // nu3 of 12CH4 and 13CH4, cm-1 (J. S. Margolis 1988, Appl. Opt. 27, 4038; S. Albert et al.
    // 2009, Chem. Phys. 356, 131), and HITRAN's abundances. B is that of the tetrahedron of
    // hydrogen.
    constexpr double origin12_per_cm = 3018.92, origin13_per_cm = 3009.55;
    constexpr double abundanceRatio = 0.0111031 / 0.988274;
    std::vector<Line> heavy;
    for (Line line : listed) {
        if (line.isotopologue != 1)
            continue;
        line.wavenumber_per_cm += origin13_per_cm - origin12_per_cm;
        line.intensity *= abundanceRatio;
        line.isotopologue = 2;
        heavy.push_back(line);
    }
    return heavy;
}

LineList completeLineList(Gas gas, const std::filesystem::path& dataFolder) {
    const std::filesystem::path folder = dataFolder / "lines";
    if (static_cast<std::size_t>(gas) >= lineGasCount)
        throw LogicError("this gas does not absorb in lines");
    if (gas == Gas::CO2)
        return completeCarbonDioxide(folder);
    LineList list = readLineList(
        gas, folder / (std::string(gasNames[static_cast<std::size_t>(gas)]) + ".par.gz"));
    list.origins.push_back(hitranOrigin(gas));
    if (gas == Gas::CH4) {
        addMethaneDyad(list);
        addBareMethane(list, folder);
    }
    if (gas == Gas::O3)
        addOzone(list, folder / "O3.par.gz");
    if (gas == Gas::N2O)
        addRareNitrousOxide(list, folder / "N2O.par.gz");
    addPseudoLines(list, dataFolder);
    scalePseudoLines(list, dataFolder);
    std::erase_if(list.lines,
                  [](const Line& line) { return line.wavenumber_per_cm < lowest_per_cm; });
    std::ranges::stable_sort(list.lines, {}, &Line::wavenumber_per_cm);
    return list;
}

std::vector<LineList> completeLineLists(const std::filesystem::path& dataFolder) {
    std::vector<LineList> lists;
    for (std::size_t g = 0; g < lineGasCount; ++g)
        lists.push_back(completeLineList(static_cast<Gas>(g), dataFolder));
    return lists;
}

} // namespace irsg::lbl
