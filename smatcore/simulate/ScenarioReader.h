#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "smatcore/project/JsonFields.h"
#include "smatcore/simulate/Scenario.h"

namespace smat {

/// Reads the parts of a scenario and collects what is wrong with them (used by ScenarioFile alone).
class ScenarioReader : private JsonFields {
  public:
    ScenarioReader(std::string fileName, const std::string& text);

    /// Throws InputError with everything that was wrong.
    Scenario read();

  private:
    void readTimes(Scenario& scenario);
    /// The objects of a list, each with its key path; `what` names one.
    std::vector<std::pair<std::string, Json>> takeList(const char* key, const char* what);
    ScenarioEntity readEntity(Json json, const std::string& path);
    ScenarioSensor readSensor(Json json, const std::string& path);
    void readMount(ScenarioSensor& sensor, Json& json, const std::string& path);
    void checkNames(const Scenario& scenario);
    void checkReference(const Scenario& scenario, const std::string& name, const std::string& path);

    /// A required number.
    double requireNumber(Json& json, const char* key, const std::string& path, double minimum,
                         double maximum);
    std::string requireText(Json& json, const char* key, const std::string& path, const char* what);
    std::optional<double> takeOptional(Json& json, const char* key, const std::string& path,
                                       double minimum, double maximum);
    Settings takeScenarioSettings(Json& json, const std::string& path);
    /// Refuses these keys, because `reason`.
    void refuseKeys(Json& json, const std::vector<std::string>& keys, const std::string& path,
                    const std::string& reason);
    /// Refuses everything that nobody took.
    void refuseLeftOver(const Json& json, const std::string& path);
};

} // namespace smat
