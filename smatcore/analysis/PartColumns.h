#pragma once

#include <string>
#include <vector>

#include "irsg/render/values/RenderReport.h"
#include "irsg/scene/Scene.h"
#include "smatcore/settings/Settings.h"

namespace smat {

/// What a table tells the parts of an object apart by.
enum class PartsBy { none, temperature, material };

/// What the setting `render.parts` asks for.
PartsBy partsByOf(const Settings& settings);

/// The faces of an object that carry one index.
struct ObjectPart {
    int index = 0;
    std::string label; ///< the name of its entry, "temperature 5" where it has none
};

/// The parts of an object, by ascending index; their labels are distinct (distinctLabels). None for
/// PartsBy::none.
std::vector<ObjectPart> partsOf(const irsg::Entity& entity, PartsBy by);

/// What such a part adds to the sums of its object.
irsg::SurfaceRadiometry sumOfPart(const irsg::ObjectRadiometry& object, PartsBy by, int index);

} // namespace smat
