#include "irsg/gas/BentJet.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

constexpr double shearEntrainment = 0.1;
constexpr double onAxisOverMean = 2.0;
constexpr double longest = 3000.0; // diameters of the nozzle

void refuseWind(const BentJet& jet, double along_m, const char* what) {
    throw InputError({"jet", "wind_m_s",
                      numberText(lengthOf(jet.wind_m_s)) + " m/s, which " + what + " at " +
                          numberText(std::round(100.0 * along_m) / 100.0) + " m along its axis",
                      "a wind that bends the jet by less than its width, or a larger ends_at"});
}

/// The part of exhaust across a section: a bell about a core.
struct Bell {
    double onAxis, core_m, half_m;

    double at(double r_m) const {
        const double over = std::max(0.0, r_m - core_m) / half_m;
        return onAxis * std::exp(-std::numbers::ln2 * over * over);
    }
    double reach_m(double least) const {
        return core_m + half_m * std::sqrt(std::log(1.0 / least) / std::numbers::ln2);
    }
};

/// As wide as the section carries all exhaust.
Bell bellOf(const RoundJet& nozzle, const BentJet::Section& section, double coreEnds_m) {
    const double radius_m = 0.5 * nozzle.diameter_m;
    const double coreLeft = std::max(0.0, 1.0 - section.along_m / coreEnds_m);
    Bell bell{section.onAxis(), radius_m * coreLeft, 0.0};
    const double heat = nozzle.temperature_K / nozzle.air_K - 1.0;
    const auto flow = [&] {
        constexpr int steps = 400;
        const double step_m = bell.reach_m(1e-6) / steps;
        double sum = 0.0;
        for (int i = 0; i < steps; ++i) {
            const double r_m = (i + 0.5) * step_m, part = bell.at(r_m);
            sum += part / (1.0 + part * heat) * 2.0 * r_m * step_m;
        }
        return sum * section.velocity_m_s;
    };
    const double all = radius_m * radius_m * nozzle.velocity_m_s / (1.0 + heat);
    double least_m = 1e-6 * radius_m, most_m = 20.0 * radius_m + section.along_m;
    for (int i = 0; i < 60; ++i) {
        bell.half_m = 0.5 * (least_m + most_m);
        (flow() < all ? least_m : most_m) = bell.half_m;
    }
    return bell;
}

} // namespace

double BentJet::Section::onAxis() const {
    return std::min(1.0, onAxisOverMean * part);
}

std::vector<BentJet::Section> BentJet::sections() const {
    nozzle.nozzleGas(); // refuses what cannot be
    const double step_m = 0.01 * nozzle.diameter_m;
    const double rise_K = nozzle.temperature_K - nozzle.air_K;
    // Of mass and momentum over pi and the density of the air.
    const double mass0 = nozzle.air_K / nozzle.temperature_K * nozzle.velocity_m_s * 0.25 *
                         nozzle.diameter_m * nozzle.diameter_m;
    double mass = mass0;
    GasVector momentum = sumOf({}, along, mass * nozzle.velocity_m_s);
    double lastRadius_m = 0.5 * nozzle.diameter_m;
    double lastAlong_m_s = dotOf(wind_m_s, along);
    std::vector<Section> sections{{0.0, place_m, along, 1.0, nozzle.velocity_m_s}};
    while (sections.back().onAxis() > nozzle.endsAt) {
        const Section& here = sections.back();
        const double density = nozzle.air_K / (nozzle.air_K + here.part * rise_K);
        const double radius_m = std::sqrt(mass / (density * here.velocity_m_s));
        const double goesAlong_m_s = dotOf(wind_m_s, here.along);
        const double across_m_s = lengthOf(sumOf(wind_m_s, here.along, -goesAlong_m_s));
        const double shear = 2.0 * radius_m * shearEntrainment *
                             std::abs(here.velocity_m_s - goesAlong_m_s) * step_m;
        // What wind the section, its growth and its bend meet.
        const double forced =
            2.0 / std::numbers::pi * radius_m * across_m_s * step_m +
            radius_m * std::max(0.0, radius_m - lastRadius_m) * goesAlong_m_s +
            0.5 * radius_m * radius_m * std::max(0.0, goesAlong_m_s - lastAlong_m_s);
        lastRadius_m = radius_m;
        lastAlong_m_s = goesAlong_m_s;
        const double takesIn = std::max(shear, forced);
        mass += takesIn;
        momentum = sumOf(momentum, wind_m_s, takesIn);
        momentum =
            sumOf(momentum, up, gravity_m_s2 * (1.0 - density) * radius_m * radius_m * step_m);
        const double velocity_m_s = lengthOf(momentum) / mass;
        if (!(velocity_m_s > 1e-3 * nozzle.velocity_m_s))
            refuseWind(*this, here.along_m, "stops the jet");
        const GasVector goesOn = unitOf(momentum);
        // The radius of the bend is step_m over the turn.
        constexpr double tightest = 0.25; // of the radius
        if (tightest * radius_m * lengthOf(differenceOf(goesOn, here.along)) > step_m)
            refuseWind(*this, here.along_m, "turns the jet within its own width");
        if (here.along_m > longest * nozzle.diameter_m)
            throw InputError({"jet", "ends_at", numberText(nozzle.endsAt),
                              "a part that the axis reaches within " + numberText(longest) +
                                  " diameters of the nozzle"});
        sections.push_back({here.along_m + step_m, sumOf(here.place_m, here.along, step_m), goesOn,
                            mass0 / mass, velocity_m_s});
    }
    return sections;
}

BentJet::Section BentJet::Flow::axisAt(double along_m) const {
    const double step_m = sections.at(1).along_m;
    const double at = std::clamp(along_m / step_m, 0.0, static_cast<double>(sections.size() - 1));
    const auto number = std::min(static_cast<std::size_t>(at), sections.size() - 2);
    const double part = at - static_cast<double>(number);
    const Section &one = sections[number], &next = sections[number + 1];
    return {std::lerp(one.along_m, next.along_m, part),
            sumOf(one.place_m, differenceOf(next.place_m, one.place_m), part),
            unitOf(sumOf(one.along, differenceOf(next.along, one.along), part)),
            std::lerp(one.part, next.part, part),
            std::lerp(one.velocity_m_s, next.velocity_m_s, part)};
}

BentJet::Flow BentJet::flow(std::size_t alongNodes, std::size_t acrossNodes) const {
    std::vector<Section> all = sections();
    const double step_m = all.at(1).along_m, end_m = all.back().along_m;
    const auto coreEnd = std::ranges::find_if(
        all, [](const Section& section) { return onAxisOverMean * section.part < 1.0; });
    std::vector<double> x_m, r_m;
    std::vector<Bell> bells;
    double widest_m = 0.0;
    for (std::size_t i = 0; i < alongNodes; ++i) { // by squares: it is short-lived at the nozzle
        const double part = static_cast<double>(i) / static_cast<double>(alongNodes - 1);
        x_m.push_back(end_m * part * part);
        const auto number = static_cast<std::size_t>(std::lround(x_m.back() / step_m));
        bells.push_back(bellOf(nozzle, all.at(number), coreEnd->along_m));
        widest_m = std::max(widest_m, bells.back().reach_m(0.01));
    }
    for (std::size_t j = 0; j < acrossNodes; ++j) {
        const double part = static_cast<double>(j) / static_cast<double>(acrossNodes - 1);
        r_m.push_back(widest_m * part * part);
    }
    const ExhaustInAir exhaust(nozzle);
    std::vector<GasLayer> nodes;
    for (const Bell& bell : bells)
        for (const double r : r_m)
            nodes.push_back(exhaust.at(bell.at(r)));
    return {PlumeTable::ofNodes(std::move(x_m), std::move(r_m), std::move(nodes)), std::move(all)};
}

} // namespace irsg
