#include "smatcore/simulate/Scenario.h"

#include <algorithm>
#include <cmath>

#include "smatcore/project/NamedPaths.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

namespace {

template <typename Named>
std::optional<std::size_t> indexOf(const std::vector<Named>& list, const std::string& name) {
    const auto found =
        std::find_if(list.begin(), list.end(), [&](const Named& one) { return one.name == name; });
    return found == list.end() ? std::nullopt
                               : std::optional(static_cast<std::size_t>(found - list.begin()));
}

} // namespace

std::filesystem::path Scenario::resolve(const std::filesystem::path& path) const {
    return namedPath(file, path).file;
}

std::string Scenario::displayName() const {
    if (!file.empty())
        return file.filename().string();
    return title.empty() ? "new scenario" : title;
}

std::vector<double> Scenario::times_s() const {
    // A hundred thousandth of a step is rounding: 3 steps of 0.1 s end at 0.3 s.
    const auto last = static_cast<std::size_t>(std::floor((end_s - start_s) / dt_s + 1e-5));
    std::vector<double> times;
    for (std::size_t step = 0; step <= last; ++step)
        times.push_back(start_s + static_cast<double>(step) * dt_s);
    return times;
}

std::optional<std::size_t> Scenario::findEntity(const std::string& name) const {
    return indexOf(entities, name);
}

std::optional<std::size_t> Scenario::findSensor(const std::string& name) const {
    return indexOf(sensors, name);
}

bool isScenarioSetting(const SettingInfo& setting) {
    const std::string section = setting.section();
    return section != "camera" && section != "target" && section != "state" &&
           (section == "image" || !isAnalysisSection(section));
}

const Settings& scenarioDefaults() {
    static const Settings defaults = [] {
        Settings made;
        made.set(key::scalingUse, "true");
        made.set(key::renderSunDisc, "true");
        return made;
    }();
    return defaults;
}

} // namespace smat
