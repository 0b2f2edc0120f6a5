#include "smatcore/tools/RoundJetText.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "irsg/core/Errors.h"
#include "smatcore/tools/KeyNumbers.h"

namespace smat {

namespace {

using irsg::RoundJet;

struct JetField {
    NumberKey key;
    double RoundJet::*number;
};

const std::array<JetField, 13>& jetFields() {
    static const std::array<JetField, 13> all = {{{{"D_m", true}, &RoundJet::diameter_m},
                                                  {{"T_K", true}, &RoundJet::temperature_K},
                                                  {{"velocity_m_s", true}, &RoundJet::velocity_m_s},
                                                  {{"fuel_air", true}, &RoundJet::fuelAirRatio},
                                                  {{"air_K"}, &RoundJet::air_K},
                                                  {{"coflow_m_s"}, &RoundJet::coflow_m_s},
                                                  {{"p_atm"}, &RoundJet::pressure_atm},
                                                  {{"carbon"}, &RoundJet::carbon},
                                                  {{"hydrogen"}, &RoundJet::hydrogen},
                                                  {{"air_H2O"}, &RoundJet::airWater},
                                                  {{"air_CO2"}, &RoundJet::airCO2},
                                                  {{"soot_ppmv"}, &RoundJet::soot_ppmv},
                                                  {{"ends_at"}, &RoundJet::endsAt}}};
    return all;
}

} // namespace

RoundJet roundJetFromText(const std::string& text, const std::string& name) {
    std::vector<NumberKey> keys;
    for (const JetField& field : jetFields())
        keys.push_back(field.key);
    RoundJet jet;
    std::vector<irsg::Diagnostic> diagnostics =
        readKeyNumbers(text, name, keys, "T_K=800", [&](std::size_t number, double value) {
            jet.*(jetFields()[number].number) = value;
        });
    if (!diagnostics.empty())
        throw irsg::InputError(std::move(diagnostics));
    return jet;
}

} // namespace smat
