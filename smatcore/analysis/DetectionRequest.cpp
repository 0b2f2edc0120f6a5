#include "smatcore/analysis/DetectionRequest.h"

#include "irsg/core/Errors.h"
#include "irsg/sensor/NormalQuantile.h"
#include "smatcore/analysis/AnalysisDefinition.h"

namespace smat {

AnalysisKind detectionKind() {
    return resultKindFromName("detection");
}

const std::vector<std::string>& pointPlaceWords() {
    static const std::vector<std::string> words = {"centre", "mean", "corner"};
    return words;
}

const std::vector<std::string>& criterionWords() {
    static const std::vector<std::string> words = {"point", "johnson", "ttp"};
    return words;
}

const std::vector<irsg::JohnsonTask>& tasksOf(RangeCriterion criterion) {
    return criterion == RangeCriterion::targeting ? irsg::targetingTasks() : irsg::johnsonTasks();
}

const irsg::TaskLaw& lawOf(RangeCriterion criterion) {
    return criterion == RangeCriterion::targeting ? irsg::targetingLaw : irsg::johnsonLaw;
}

double thresholdOfFalseAlarms(double probability) {
    if (!(probability > 0.0 && probability < 0.5))
        throw irsg::InputError({"", "probability of a false alarm", irsg::numberText(probability),
                                "a number between 0 and 0.5, both exclusive"});
    return -irsg::normalQuantile(probability);
}

std::vector<std::string> rangeTaskWords() {
    std::vector<std::string> words;
    for (const irsg::JohnsonTask& task : irsg::johnsonTasks())
        words.emplace_back(task.name);
    return words;
}

} // namespace smat
