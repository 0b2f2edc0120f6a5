#include "irsg/scene/SceneEvaluation.h"

#include <algorithm>

namespace irsg {

std::vector<double> SceneEvaluation::ranges_m() const {
    std::vector<double> ranges_m;
    for (const ObjectGeometry& object : geometry)
        ranges_m.push_back(object.path.range_m);
    return ranges_m;
}

EvaluatedScene& SceneEvaluation::turned(const std::vector<Entity>& entities) const {
    evaluated->turnTo(entities, geometry);
    evaluated->seeAlong(sampled);
    evaluated->radiances.setBackground(background());
    return *evaluated;
}

bool FrameBackgrounds::areUniform() const {
    return std::ranges::all_of(ofSums, &FrameBackground::isUniform);
}

std::vector<FrameBackground> FrameBackgrounds::varying() const {
    std::vector<FrameBackground> varying;
    for (const FrameBackground& background : ofSums)
        if (!background.isUniform())
            varying.push_back(background);
    return varying;
}

std::vector<int> FrameBackgrounds::numbersOfVarying() const {
    std::vector<int> numbers;
    int number = 0;
    for (const FrameBackground& background : ofSums)
        numbers.push_back(background.isUniform() ? -1 : number++);
    return numbers;
}

} // namespace irsg
