#include "smatcore/analysis/ChangedAir.h"

#include <memory>
#include <utility>

#include "irsg/atmosphere/AtmosphereSmart.h"

namespace smat {

std::optional<irsg::Environment>
withAir(const irsg::Environment& environment,
        const std::function<bool(irsg::AtmosphereSmartParameters&)>& change) {
    bool isChanged = false;
    irsg::Environment made = environment.with(
        [&](const irsg::Atmosphere& one) -> std::shared_ptr<const irsg::Atmosphere> {
            const auto* computed = dynamic_cast<const irsg::AtmosphereSmart*>(&one);
            if (computed == nullptr)
                return nullptr;
            irsg::AtmosphereSmartParameters parameters = computed->parameters();
            if (!change(parameters))
                return nullptr;
            isChanged = true;
            return computed->withParameters(std::move(parameters));
        });
    return isChanged ? std::optional(std::move(made)) : std::nullopt;
}

} // namespace smat
