#include "tools/samples/BentJet.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "irsg/core/FileReplacement.h"

namespace smat {
namespace {

using irsg::Vec3;

constexpr double shearEntrainment = 0.1;
constexpr double gravity_m_s2 = 9.80665;
constexpr double onAxisOverMean = 2.0;

/// The jet at a distance along its axis.
struct Section {
    double along_m = 0.0;
    AxisPlace axis;
    double part = 1.0; ///< of exhaust, mean by mass
    double velocity_m_s = 0.0;

    double onAxis() const { return std::min(1.0, onAxisOverMean * part); }
};

std::vector<Section> sectionsOf(const BentJet& jet) {
    const irsg::RoundJet& nozzle = jet.nozzle;
    const double step_m = 0.01 * nozzle.diameter_m;
    const double rise_K = nozzle.temperature_K - nozzle.air_K;
    // Of mass and momentum over pi and the density of the air.
    const double mass0 = nozzle.air_K / nozzle.temperature_K * nozzle.velocity_m_s * 0.25 *
                         nozzle.diameter_m * nozzle.diameter_m;
    double mass = mass0;
    Vec3 momentum = jet.along * (mass * nozzle.velocity_m_s);
    double lastRadius_m = 0.5 * nozzle.diameter_m;
    double lastAlong_m_s = dot(jet.wind_m_s, jet.along);
    std::vector<Section> sections{{0.0, {jet.place, jet.along}, 1.0, nozzle.velocity_m_s}};
    while (sections.back().onAxis() > nozzle.endsAt) {
        const Section& here = sections.back();
        const double density = nozzle.air_K / (nozzle.air_K + here.part * rise_K);
        const double radius_m = std::sqrt(mass / (density * here.velocity_m_s));
        const double goesAlong_m_s = dot(jet.wind_m_s, here.axis.along);
        const double across_m_s = length(jet.wind_m_s - here.axis.along * goesAlong_m_s);
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
        momentum = momentum + jet.wind_m_s * takesIn +
                   Vec3{0.0, 0.0, gravity_m_s2 * (1.0 - density) * radius_m * radius_m * step_m};
        const double velocity_m_s = length(momentum) / mass;
        sections.push_back({here.along_m + step_m,
                            {here.axis.place + here.axis.along * step_m, normalized(momentum)},
                            mass0 / mass,
                            velocity_m_s});
    }
    return sections;
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
Bell bellOf(const irsg::RoundJet& nozzle, const Section& section, double coreEnds_m) {
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

BentJet::Flow BentJet::flow() const {
    constexpr std::size_t alongNodes = 48, acrossNodes = 28;
    const irsg::GasLayer hot = nozzle.nozzleGas(), cold = nozzle.air();
    const auto sections = std::make_shared<const std::vector<Section>>(sectionsOf(*this));
    const double step_m = sections->at(1).along_m, end_m = sections->back().along_m;
    const auto coreEnd = std::ranges::find_if(
        *sections, [](const Section& section) { return onAxisOverMean * section.part < 1.0; });
    std::vector<double> x_m, r_m;
    std::vector<Bell> bells;
    double widest_m = 0.0;
    for (std::size_t i = 0; i < alongNodes; ++i) { // by squares: it is short-lived at the nozzle
        const double part = static_cast<double>(i) / (alongNodes - 1);
        x_m.push_back(end_m * part * part);
        const auto number = static_cast<std::size_t>(std::lround(x_m.back() / step_m));
        bells.push_back(bellOf(nozzle, sections->at(number), coreEnd->along_m));
        widest_m = std::max(widest_m, bells.back().reach_m(0.01));
    }
    for (std::size_t j = 0; j < acrossNodes; ++j) {
        const double part = static_cast<double>(j) / (acrossNodes - 1);
        r_m.push_back(widest_m * part * part);
    }
    std::vector<irsg::GasLayer> nodes;
    for (const Bell& bell : bells)
        for (const double r : r_m) {
            const double part = bell.at(r);
            irsg::GasLayer& gas = nodes.emplace_back(cold);
            gas.temperature_K = std::lerp(cold.temperature_K, hot.temperature_K, part);
            // The rest of the air's own gases is in the air of the scene.
            for (std::size_t g = 0; g < irsg::hotGasCount; ++g)
                gas.moleFraction[g] =
                    part * std::max(0.0, hot.moleFraction[g] - cold.moleFraction[g]);
            gas.oxygenFraction = std::lerp(cold.oxygenFraction, hot.oxygenFraction, part);
        }
    const auto axis = [sections, step_m](double along_m) {
        const double at =
            std::clamp(along_m / step_m, 0.0, static_cast<double>(sections->size() - 1));
        const auto number = std::min(static_cast<std::size_t>(at), sections->size() - 2);
        const double part = at - static_cast<double>(number);
        const AxisPlace &one = sections->at(number).axis, &next = sections->at(number + 1).axis;
        return AxisPlace{one.place + (next.place - one.place) * part,
                         normalized(one.along + (next.along - one.along) * part)};
    };
    return {irsg::PlumeTable::ofNodes(std::move(x_m), std::move(r_m), std::move(nodes)), axis,
            normalized(cross(along, wind_m_s))};
}

void savePlumeTable(const irsg::PlumeTable& table, const std::filesystem::path& file) {
    std::string text = "x [m],r [m],T [K],CO2,H2O,O2\n";
    for (std::size_t x = 0; x < table.x_m().size(); ++x)
        for (std::size_t r = 0; r < table.r_m().size(); ++r) {
            const irsg::GasLayer& gas = table.node(x, r);
            text += fmt::format("{:.5g},{:.5g},{:.6g},{:.5g},{:.5g},{:.5g}\n", table.x_m()[x],
                                table.r_m()[r], gas.temperature_K, gas.fraction(irsg::HotGas::CO2),
                                gas.fraction(irsg::HotGas::H2O), gas.oxygenFraction);
        }
    irsg::writeFileDurably(file, text);
}

} // namespace smat
