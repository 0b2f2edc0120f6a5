#include "smatcore/tools/PlumeJetText.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/tools/KeyNumbers.h"

namespace smat {

namespace {

using irsg::RoundJet;

struct JetField {
    NumberKey key;
    std::function<void(PlumeJet&, double)> take;
};

const std::vector<JetField>& jetFields() {
    const auto nozzle = [](double RoundJet::*number) {
        return [number](PlumeJet& jet, double value) { jet.nozzle.*number = value; };
    };
    const auto bend = [](std::optional<double> PlumeJet::*number) {
        return [number](PlumeJet& jet, double value) { jet.*number = value; };
    };
    static const std::vector<JetField> all = {
        {{"D_m", true}, nozzle(&RoundJet::diameter_m)},
        {{"T_K", true}, nozzle(&RoundJet::temperature_K)},
        {{"velocity_m_s", true}, nozzle(&RoundJet::velocity_m_s)},
        {{"fuel_air", true}, nozzle(&RoundJet::fuelAirRatio)},
        {{"air_K"}, nozzle(&RoundJet::air_K)},
        {{"coflow_m_s"}, nozzle(&RoundJet::coflow_m_s)},
        {{"p_atm"}, nozzle(&RoundJet::pressure_atm)},
        {{"carbon"}, nozzle(&RoundJet::carbon)},
        {{"hydrogen"}, nozzle(&RoundJet::hydrogen)},
        {{"air_H2O"}, nozzle(&RoundJet::airWater)},
        {{"air_CO2"}, nozzle(&RoundJet::airCO2)},
        {{"soot_ppmv"}, nozzle(&RoundJet::soot_ppmv)},
        {{"ends_at"}, nozzle(&RoundJet::endsAt)},
        {{"up_deg"}, bend(&PlumeJet::up_deg)},
        {{"wind_m_s"}, bend(&PlumeJet::wind_m_s)},
        {{"wind_from_deg"}, bend(&PlumeJet::windFrom_deg)}};
    return all;
}

} // namespace

irsg::BentJet PlumeJet::bent() const {
    const double up = irsg::radians(elevation_deg());
    const double from = irsg::radians(windFrom_deg.value_or(0.0)),
                 speed_m_s = wind_m_s.value_or(0.0);
    irsg::BentJet jet;
    jet.nozzle = nozzle;
    jet.along = {1.0, 0.0, 0.0};
    // Downstream, to starboard and up without the elevation: wind from ahead goes downstream.
    const double aft_m_s = speed_m_s * std::cos(from);
    jet.wind_m_s = {aft_m_s * std::cos(up), -speed_m_s * std::sin(from), -aft_m_s * std::sin(up)};
    jet.up = {std::sin(up), 0.0, std::cos(up)};
    jet.gravity_m_s2 = up_deg ? irsg::BentJet::standardGravity_m_s2 : 0.0;
    return jet;
}

PlumeJet plumeJetFromText(const std::string& text, const std::string& name) {
    std::vector<NumberKey> keys;
    for (const JetField& field : jetFields())
        keys.push_back(field.key);
    PlumeJet jet;
    std::vector<irsg::Diagnostic> diagnostics =
        readKeyNumbers(text, name, keys, "T_K=800", [&](std::size_t number, double value) {
            jetFields()[number].take(jet, value);
        });
    const auto check = [&](const char* key, const std::optional<double>& value, double least,
                           double most, const char* expected) {
        if (value && !(*value >= least && *value <= most))
            diagnostics.push_back({name, key, irsg::numberText(*value), expected});
    };
    check("up_deg", jet.up_deg, -90.0, 90.0, "degrees over the horizon, -90 to 90");
    check("wind_m_s", jet.wind_m_s, 0.0, 1000.0, "0 to 1000 m/s");
    check("wind_from_deg", jet.windFrom_deg, -360.0, 360.0,
          "degrees clockwise from the nose, -360 to 360");
    if (jet.windFrom_deg && !jet.wind_m_s)
        diagnostics.push_back(
            {name, "wind_from_deg", "no wind_m_s beside it", "the speed as well"});
    if (!jet.isStraight() && jet.nozzle.coflow_m_s != 0.0)
        diagnostics.push_back({name, "coflow_m_s", irsg::numberText(jet.nozzle.coflow_m_s),
                               "wind_m_s instead, where there is up_deg or wind_m_s"});
    if (!diagnostics.empty())
        throw irsg::InputError(std::move(diagnostics));
    return jet;
}

} // namespace smat
