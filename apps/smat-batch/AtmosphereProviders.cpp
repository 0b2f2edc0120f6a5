#include "apps/smat-batch/AtmosphereProviders.h"

#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/smat-batch/Command.h"
#include "apps/smat-batch/Output.h"
#include "irsg/radiometry/Band.h"
#include "smatcore/project/EnvironmentInput.h"
#include "smatcore/tools/QuantityProviders.h"

namespace smat::batch {

namespace {

void print(const BandProviders& answers) {
    fmt::print("{:.6g} to {:.6g} um\n", answers.band.min_um, answers.band.max_um);
    for (const QuantityProvider& source : answers.sources) {
        fmt::print("  {:<26}{}\n", source.quantity,
                   source.providedBy.empty() ? "none" : source.providedBy);
        for (const std::string& refusal : source.refusals)
            fmt::print("  {:<26}  {}\n", "", refusal);
    }
}

nlohmann::ordered_json jsonOf(const BandProviders& answers) {
    nlohmann::ordered_json sources = nlohmann::ordered_json::array();
    for (const QuantityProvider& source : answers.sources)
        sources.push_back({{"quantity", source.quantity},
                           {"answered_by", source.providedBy},
                           {"refusals", source.refusals}});
    return {{"band_um", {answers.band.min_um, answers.band.max_um}}, {"sources", sources}};
}

} // namespace

int printAtmosphereProviders(const std::vector<std::string>& atmospheres,
                             const std::vector<std::string>& bands, const Context& context) {
    std::vector<irsg::SpectralRange> ranges;
    for (const std::string& band : bands)
        ranges.push_back(irsg::Band::fromText(band).range());
    irsg::Environment environment;
    addAtmosphere(environment, {atmospheres.begin(), atmospheres.end()});
    const std::vector<BandProviders> all = providersFor(environment, ranges);
    if (!context.json) {
        for (const BandProviders& one : all)
            print(one);
        return done;
    }
    nlohmann::ordered_json result = nlohmann::ordered_json::array();
    for (const BandProviders& one : all)
        result.push_back(jsonOf(one));
    fmt::print("{}\n", jsonText(result));
    return done;
}

} // namespace smat::batch
