#include <cmath>
#include <span>
#include <string_view>

#include "irsg/atmosphere/import/Tape7.h"
#include "irsg/atmosphere/path/Earth.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

struct CardField {
    const char* name;
    std::size_t first;
    std::size_t columns;
};
constexpr CardField card1[] = {
    {"MODEL", 4, 1}, {"ITYPE", 5, 5}, {"IEMSCT", 10, 5}, {"IMULT", 15, 5},  {"M1", 20, 5},
    {"M2", 25, 5},   {"M3", 30, 5},   {"M4", 35, 5},     {"M5", 40, 5},     {"M6", 45, 5},
    {"MDEF", 50, 5}, {"IM", 55, 5},   {"NOPRNT", 60, 5}, {"TBOUND", 65, 8}, {"SALB", 73, 7}};
constexpr CardField card2[] = {{"IHAZE", 2, 3},    {"ISEASN", 6, 4},  {"IVULCN", 13, 2},
                               {"ICSTL", 15, 5},   {"ICLD", 20, 5},   {"IVSA", 25, 5},
                               {"VIS", 30, 10},    {"WSS", 40, 10},   {"WHH", 50, 10},
                               {"RAINRT", 60, 10}, {"GNDALT", 70, 10}};
constexpr CardField card3[] = {{"H1", 0, 10},     {"H2", 10, 10},   {"ANGLE", 20, 10},
                               {"RANGE", 30, 10}, {"BETA", 40, 10}, {"RO", 50, 12},
                               {"LEN", 62, 3}};
constexpr CardField card3a1[] = {
    {"IPARM", 0, 5}, {"IPH", 5, 5}, {"IDAY", 10, 5}, {"ISOURC", 15, 5}};
constexpr CardField card3a2[] = {{"PARM1", 0, 10},  {"PARM2", 10, 10}, {"PARM3", 20, 10},
                                 {"PARM4", 30, 10}, {"TIME", 40, 10},  {"PSIPO", 50, 10}};
constexpr CardField card4[] = {{"V1", 0, 10}, {"V2", 10, 10}, {"DV", 20, 10}, {"FWHM", 30, 10}};

double cardOf(const SpectralRun& run, const char* name) {
    const auto found = run.cards.find(name);
    return found == run.cards.end() ? 0.0 : found->second;
}

} // namespace

std::map<std::string, double> tape7Cards(const TextLines& text, std::size_t first,
                                         std::size_t names, std::vector<Diagnostic>& diagnostics) {
    std::map<std::string, double> cards;
    const auto read = [&](std::size_t line, std::span<const CardField> fields) {
        for (const CardField& wanted : fields) {
            const std::string_view cell = field(text.lines[line], wanted.first, wanted.columns);
            if (const std::optional<double> value = fortranNumber(cell)) {
                cards[wanted.name] = *value;
            } else {
                diagnostics.push_back(
                    text.diagnostic(line, "'" + std::string(cell) + "'",
                                    "a number for " + std::string(wanted.name) + " in columns " +
                                        std::to_string(wanted.first + 1) + " to " +
                                        std::to_string(wanted.first + wanted.columns)));
            }
        }
    };
    read(first, card1);
    read(first + 1, card2);
    read(names - 5, card3);
    read(names - 4, card3a1);
    read(names - 3, card3a2);
    read(names - 2, card4);
    if (const std::optional<double> asymmetry = fortranNumber(field(text.lines[names - 3], 70, 10)))
        cards["G"] = *asymmetry;
    return cards;
}

void placeRun(SpectralRun& run, const std::string& file, const std::string& position,
              std::vector<Diagnostic>& diagnostics) {
    const auto report = [&](std::string value, std::string expected) {
        diagnostics.push_back({file, position, std::move(value), std::move(expected)});
    };
    const double type = cardOf(run, "ITYPE");
    if (type != 1.0 && type != 2.0 && type != 3.0) {
        report("ITYPE " + numberText(type), "1 (horizontal), 2 (slant) or 3 (to space)");
        return;
    }
    const double ground_m = 1e3 * cardOf(run, "GNDALT");
    const double radius_m = cardOf(run, "RO") > 0.0 ? 1e3 * cardOf(run, "RO") : earthRadius_m;
    const double zenith_deg = cardOf(run, "ANGLE");
    RunGeometry& geometry = run.geometry;
    geometry = {.path = static_cast<RunPath>(static_cast<int>(type)),
                .sensorAltitude_m = 1e3 * cardOf(run, "H1") - ground_m,
                .targetAltitude_m = 1e3 * cardOf(run, "H2") - ground_m,
                .range_m = 1e3 * cardOf(run, "RANGE"),
                .elevation_rad = radians(90.0 - zenith_deg),
                .sunElevation_rad = {}};
    if (geometry.path == RunPath::horizontal) {
        geometry.targetAltitude_m = geometry.sensorAltitude_m;
        geometry.elevation_rad = 0.0;
    } else if (zenith_deg < 0.0 || zenith_deg > 180.0) {
        report("ANGLE " + numberText(zenith_deg), "a zenith angle of 0 to 180 deg");
    }
    if (geometry.sensorAltitude_m < 0.0)
        report("H1 " + numberText(cardOf(run, "H1")), "at least GNDALT");
    if (geometry.path == RunPath::slant && geometry.targetAltitude_m < 0.0)
        report("H2 " + numberText(cardOf(run, "H2")), "at least GNDALT");
    if (geometry.path == RunPath::slant && !(geometry.range_m > 0.0)) {
        const std::optional<double> chord =
            chord_m(geometry.sensorAltitude_m, geometry.targetAltitude_m, geometry.elevation_rad,
                    radius_m + ground_m, cardOf(run, "LEN") == 1.0);
        geometry.range_m = chord.value_or(0.0);
        if (chord) {
            run.warnings.push_back("RANGE is not stated; " + numberText(std::round(*chord)) +
                                   " m is the straight chord from H1, H2 and ANGLE");
        }
    }
    if (geometry.path != RunPath::toSpace && !(geometry.range_m > 0.0)) {
        report("RANGE " + numberText(cardOf(run, "RANGE")),
               "a path of more than 0 km, or H1, H2 and ANGLE that make one");
    }
    if (run.kind == RunKind::sunlight) {
        if (geometry.path == RunPath::toSpace)
            geometry.sunElevation_rad = geometry.elevation_rad;
        else
            report("ITYPE " + numberText(type), "3, a path to the sun, for IEMSCT 3");
    } else if (run.kind == RunKind::solarRadiance) {
        const double parameters = cardOf(run, "IPARM");
        if (parameters == 2.0 || parameters == 12.0) {
            geometry.sunElevation_rad = radians(90.0 - cardOf(run, "PARM2"));
        } else {
            run.warnings.push_back("the sun stands where IPARM " + numberText(parameters) +
                                   " puts it; its elevation is not derived from that");
        }
    }
}

} // namespace irsg
