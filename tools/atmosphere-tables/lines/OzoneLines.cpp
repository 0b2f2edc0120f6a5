#include "tools/atmosphere-tables/lines/OzoneLines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

namespace irsg::lbl {

namespace {

using Axis = TopMoment::Axis;

constexpr double weakest = 1e-25;
constexpr int highestJ = 75;
constexpr double partitionSum296 = 3483.7; // TIPS-2017, 16O3
constexpr double mainAbundance = 0.992901; // HITRAN

// Constants in the order of TopState.
// clang-format off
const TopState ground{false, 0.0, 0.420018377, 3.13359363, 4.54533095e-07, -1.85283051e-06, 0.00021092424, 3.92403647e-13, 7.78559989e-12, -1.96126269e-09, 3.65711735e-08, 6.01681565e-12, -4.59349273e-13, 0.0252665411, 6.99339868e-08, 3.25469698e-06, 2.01509613e-13, -3.58037191e-12, 3.76189381e-09};
const TopState state100{false, 1103.13761, 0.417308847, 3.13933639, 4.57870252e-07, -2.1088521e-06, 0.000216835506, 3.92403647e-13, 2.05197655e-11, -2.12037851e-09, 3.8657376e-08, 6.01681565e-12, -4.59349273e-13, 0.025438161, 6.83788078e-08, 4.25171722e-06, 2.01509613e-13, -3.58037191e-12, 3.76189381e-09};
const TopState state001{true, 1042.08441, 0.416499763, 3.08400359, 4.61602531e-07, -1.79580008e-06, 0.000207589483, 3.92403647e-13, -8.99020316e-12, -1.93545766e-09, 3.62959236e-08, 6.01681565e-12, -4.59349273e-13, 0.0248038939, 7.36469796e-08, 2.3742361e-06, 2.01509613e-13, -3.58037191e-12, 3.76189381e-09};
const TopState state110{false, 1796.26019, 0.415490414, 3.19534983, 4.63923868e-07, -1.9664779e-06, 0.000239505288, 3.92403647e-13, 2.05197655e-11, -2.12037851e-09, 4.73205647e-08, 6.01681565e-12, -4.59349273e-13, 0.0259707381, 6.76354944e-08, 5.03632299e-06, 2.01509613e-13, -3.58037191e-12, 3.76189381e-09};
const TopState state011{true, 1726.52157, 0.414597504, 3.13771069, 4.66217332e-07, -1.64090078e-06, 0.000228350871, 3.92403647e-13, -8.99020316e-12, -1.93545766e-09, 4.36065702e-08, 6.01681565e-12, -4.59349273e-13, 0.0253106478, 7.36568609e-08, 2.92124726e-06, 2.01509613e-13, -3.58037191e-12, 3.76189381e-09};
const TopState state010{false, 700.929656, 0.418232978, 3.18886252, 4.57441532e-07, -1.73417643e-06, 0.000231984983, 3.92403647e-13, 7.78559989e-12, -1.96126269e-09, 4.37931594e-08, 6.01681565e-12, -4.59349273e-13, 0.0257917486, 6.91545309e-08, 3.87904284e-06, 2.01509613e-13, -3.58037191e-12, 3.76189381e-09};
const TopState state200{false, 2195.66582, 0.414271756, 3.14546068, 4.54180656e-07, -2.32873213e-06, 0.000224055357, 3.92403647e-13, 3.32539311e-11, -2.27949433e-09, 4.52253916e-08, 6.01681565e-12, -4.59349273e-13, 0.0259841236, 6.80486527e-08, 5.11277958e-06, 2.01509613e-13, -3.58037191e-12, 3.76189381e-09};
const TopState state101{true, 2110.78549, 0.413769083, 3.0881733, 4.83797358e-07, -2.17709155e-06, 0.000214568833, 3.92403647e-13, 3.74396243e-12, -2.09457349e-09, 4.14414861e-08, 6.01681565e-12, -4.59349273e-13, 0.0248346958, 6.79335077e-08, 4.96625023e-06, 2.01509613e-13, -3.58037191e-12, 3.76189381e-09};
const TopState state002{false, 2063.3792, 0.413149052, 3.03577839, 4.59532885e-07, -1.69863926e-06, 0.000204508512, 3.92403647e-13, -2.57660062e-11, -1.90965264e-09, 3.65173053e-08, 6.01681565e-12, -4.59349273e-13, 0.0241529633, 8.06133996e-08, 4.30195843e-07, 2.01509613e-13, -3.58037191e-12, 3.76189381e-09};
// clang-format on

const TopCoupling stretching{0, 1, -0.5132889035, -0.01173075132, 0.0};
const TopCoupling bentStretching{0, 1, -0.5247879727, -0.01196128569, 0.0};

const std::array<TopCoupling, 3> overtones = {{{0, 1, -0.749376905, -0.01807940725, 0.0},
                                               {1, 2, -0.7414415565, -0.0179630456, 0.0},
                                               {0, 2, 0.0, 0.0, -27.5}}};

// Dipoles, D, of nu1 and nu3, fitted to the strengths of the P branch that the list holds below 983
// cm-1 and to sums over 5 cm-1 of cross sections computed from HITRAN (see docs/atmosphere.md).
const TopMoment nu1{0, 0, Axis::b, 0.0128944301, 6.47224712e-3, 1.88127368e-4};
const TopMoment nu3{0, 0, Axis::a, 0.1888, -4.13937392e-4, -1.7506337e-6};

TopMoment between(std::size_t lower, std::size_t upper, TopMoment moment, double factor = 1.0) {
    moment.lower = lower;
    moment.upper = upper;
    moment.debye *= factor;
    return moment;
}

// Dipoles of combinations and overtones, D, fitted to the same cross sections at 1904 to 2300 cm-1;
// those of nu1 + nu2 and nu2 + nu3 are set to the order of these weak bands and not held to print.
const TopMoment nu1nu3{0, 1, Axis::a, 0.03992, -5.194e-4, -7.114e-6};
const TopMoment twiceNu1{0, 0, Axis::b, -1.0317e-3, 0.0, 0.0};
const TopMoment twiceNu3{0, 2, Axis::b, 5.625e-3, 0.02024, 0.0};
constexpr double moment110 = 0.0059, moment011 = 0.0090;

/// Means of air width, self width and exponent over the lines of a list with the same lower J and
/// Ka.
class OzoneWidths {
  public:
    explicit OzoneWidths(const std::vector<std::string>& texts) {
        for (const std::string& text : texts) {
            if (text.size() < 127 || text[2] != '1')
                continue;
            const auto number = [&](std::size_t first, std::size_t count) {
                return std::strtod(text.substr(first, count).c_str(), nullptr);
            };
            const auto J = static_cast<int>(number(112, 3)), Ka = static_cast<int>(number(115, 3));
            if (number(97, 3) == 0.0 && number(112, 3) == 0.0)
                continue;
            for (Mean* mean : {&exact_[{J, Ka}], &ofJ_[J]}) {
                mean->air += number(35, 5);
                mean->self += number(40, 5);
                mean->exponent += number(55, 4);
                mean->count += 1.0;
            }
        }
    }
    void give(Line& line, int J, int Ka) const {
        const Mean* mean = nullptr;
        if (const auto found = exact_.find({J, Ka}); found != exact_.end())
            mean = &found->second;
        else if (!ofJ_.empty()) {
            const auto near = ofJ_.lower_bound(J);
            mean = near == ofJ_.end() ? &ofJ_.rbegin()->second : &near->second;
        }
        line.airShift_cm_atm = -0.0007f;
        if (!mean)
            return;
        line.airWidth_cm_atm = static_cast<float>(mean->air / mean->count);
        line.selfWidth_cm_atm = static_cast<float>(mean->self / mean->count);
        line.widthExponent = static_cast<float>(mean->exponent / mean->count);
    }

  private:
    struct Mean {
        double air = 0.0, self = 0.0, exponent = 0.0, count = 0.0;
    };
    std::map<std::pair<int, int>, Mean> exact_;
    std::map<int, Mean> ofJ_;
};

/// 8 pi^3 / (3 h c) of a moment in debye, natural abundance of the main isotopologue included, at
/// 296 K.
double intensity(const TopTransition& transition) {
    constexpr double perDebye2 = 4.16238e-19;
    const double nu = transition.upper.energy_per_cm - transition.lower.energy_per_cm;
    const double c2T = secondRadiationConstant_cm_K / referenceTemperature_K;
    return -mainAbundance * perDebye2 * nu / partitionSum296 * std::expm1(-c2T * nu) *
           std::exp(-c2T * transition.lower.energy_per_cm) * transition.strength_debye2;
}

void add(std::vector<Line>& lines, const std::vector<TopTransition>& band,
         const OzoneWidths& widths) {
    for (const TopTransition& transition : band) {
        Line line;
        line.intensity = intensity(transition);
        if (line.intensity < weakest)
            continue;
        line.wavenumber_per_cm = transition.upper.energy_per_cm - transition.lower.energy_per_cm;
        line.lowerEnergy_per_cm = transition.lower.energy_per_cm;
        widths.give(line, transition.lower.J, transition.lower.Ka);
        lines.push_back(line);
    }
}

/// Lines of a band that resembles another: moved, as many times as strong, from levels so much
/// higher.
struct Likeness {
    int isotopologue;
    double from_per_cm, to_per_cm; ///< of the lines that are taken
    double move_per_cm, energy_per_cm, factor;
};

void addLike(std::vector<Line>& lines, const std::vector<Line>& original, const Likeness& like) {
    for (Line line : original) {
        if (line.wavenumber_per_cm < like.from_per_cm || line.wavenumber_per_cm >= like.to_per_cm)
            continue;
        line.wavenumber_per_cm += like.move_per_cm;
        line.lowerEnergy_per_cm += like.energy_per_cm;
        line.intensity *= like.factor;
        line.isotopologue = like.isotopologue;
        if (line.intensity >= weakest)
            lines.push_back(line);
    }
}

} // namespace

AsymmetricTop ozoneGround() {
    return AsymmetricTop({ground}, {});
}

AsymmetricTop ozoneBending() {
    return AsymmetricTop({state010}, {});
}

AsymmetricTop ozoneStretching() {
    return AsymmetricTop({state100, state001}, {stretching});
}

AsymmetricTop ozoneBentStretching() {
    return AsymmetricTop({state110, state011}, {bentStretching});
}

AsymmetricTop ozoneOvertones() {
    return AsymmetricTop({state200, state101, state002}, {overtones.begin(), overtones.end()});
}

std::vector<Line> ozoneLines(const std::vector<std::string>& texts) {
    const OzoneWidths widths(texts);
    const AsymmetricTop rest = ozoneGround(), bending = ozoneBending(),
                        stretching = ozoneStretching(), bentStretching = ozoneBentStretching(),
                        overtones = ozoneOvertones();
    const double root2 = std::sqrt(2.0);

    // Reaching below the range, for what is moved into it.
    std::vector<Line> fundamentals;
    add(fundamentals,
        transitions(rest, stretching, {between(0, 0, nu1), between(0, 1, nu3)}, highestJ,
                    ozoneFrom_per_cm - 50.0, ozoneTo_per_cm + 50.0),
        widths);
    std::vector<Line> lines = fundamentals;
    add(lines,
        transitions(bending, bentStretching, {between(0, 0, nu1), between(0, 1, nu3)}, highestJ,
                    ozoneFrom_per_cm, ozoneTo_per_cm),
        widths);
    add(lines,
        transitions(stretching, overtones,
                    {between(0, 0, nu1, root2), between(1, 1, nu1), between(0, 1, nu3),
                     between(1, 2, nu3, root2)},
                    highestJ, ozoneFrom_per_cm, ozoneTo_per_cm),
        widths);
    // nu3 and nu1 of 16O16O18O: 1028.112 and 1090.354 cm-1, of 16O18O16O: 1008.453 and 1074.308,
    // and HITRAN's abundances.
    constexpr double between_per_cm = 1075.0;
    for (const Likeness& like : std::array<Likeness, 4>{
             {{2, 0.0, between_per_cm, 1028.112 - 1042.084, 0.0, 3.98194e-3 / mainAbundance},
              {2, between_per_cm, 1e4, 1090.354 - 1103.138, 0.0, 3.98194e-3 / mainAbundance},
              {3, 0.0, between_per_cm, 1008.453 - 1042.084, 0.0, 1.99097e-3 / mainAbundance},
              {3, between_per_cm, 1e4, 1074.308 - 1103.138, 0.0, 1.99097e-3 / mainAbundance}}})
        addLike(lines, fundamentals, like);
    std::erase_if(lines, [](const Line& line) {
        return line.wavenumber_per_cm < ozoneFrom_per_cm ||
               line.wavenumber_per_cm >= ozoneTo_per_cm;
    });

    std::vector<Line> higher;
    add(higher,
        transitions(rest, bentStretching, {{0, 0, Axis::b, moment110}, {0, 1, Axis::a, moment011}},
                    highestJ, ozoneOvertoneFrom_per_cm, ozoneOvertoneTo_per_cm),
        widths);
    std::vector<Line> stretchings;
    add(stretchings,
        transitions(rest, overtones, {twiceNu1, nu1nu3, twiceNu3}, highestJ,
                    ozoneOvertoneFrom_per_cm, ozoneOvertoneTo_per_cm),
        widths);
    higher.insert(higher.end(), stretchings.begin(), stretchings.end());
    // (111) lies 2084.31 cm-1 above (010).
    addLike(higher, stretchings,
            {1, 0.0, 1e4, 2084.31 - 2110.785, state010.origin,
             std::exp(-secondRadiationConstant_cm_K * state010.origin / referenceTemperature_K)});
    lines.insert(lines.end(), higher.begin(), higher.end());
    std::ranges::stable_sort(lines, {}, &Line::wavenumber_per_cm);
    return lines;
}

} // namespace irsg::lbl
