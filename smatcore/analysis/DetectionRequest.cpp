#include "smatcore/analysis/DetectionRequest.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/sensor/NormalQuantile.h"
#include "smatcore/analysis/AnalysisDefinition.h"

namespace smat {

AnalysisKind detectionKind() {
    return resultKindFromName("detection");
}

AnalysisKind kindOf(RangeCases cases) {
    return cases == RangeCases::directions ? AnalysisKind::table : AnalysisKind::polar;
}

const std::vector<std::string>& pointPlaceWords() {
    static const std::vector<std::string> words = {"centre", "mean", "corner"};
    return words;
}

const std::vector<std::string>& criterionWords() {
    static const std::vector<std::string> words = {"point", "johnson", "ttp"};
    return words;
}

RangeComparison::Place rangePlaceOf(const std::string& what, const std::string& text) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        parts.emplace_back(irsg::trimmed(text.substr(begin, end - begin)));
        begin = end + 1;
    }
    const auto angle = [&](std::size_t i, double most_deg) {
        const auto angle_deg = parts.size() == 3 ? irsg::parseNumber(parts[i]) : std::nullopt;
        if (!angle_deg || std::abs(*angle_deg) > most_deg)
            throw irsg::InputError({"", what, text,
                                    "a day, a latitude and a longitude in deg, such as "
                                    "2025-06-21,54.3,10.1"});
        return *angle_deg;
    };
    const double latitude_deg = angle(1, 90.0);
    return {parts[0], latitude_deg, angle(2, 360.0)};
}

const std::vector<std::string>& rangeCasesWords() {
    static const std::vector<std::string> words = {"aspects", "directions"};
    return words;
}

const std::vector<std::string>& rangeAgainstWords() {
    static const std::vector<std::string> words = {"wind", "visibility", "humidity",
                                                   "hour", "band",       "paint"};
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
