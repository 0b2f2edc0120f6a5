#include "tools/atmosphere-tables/lines/PublishedRun.h"

#include <algorithm>
#include <array>
#include <sstream>

#include "irsg/atmosphere/engine/Profile.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "tools/atmosphere-tables/lines/LineListFile.h"

namespace irsg::lbl {

PublishedRun PublishedRun::read(const std::filesystem::path& data) {
    constexpr std::size_t headerLines = 13, waterColumn = 2, continuumColumn = 7,
                          methaneColumn = 15, oxygenColumn = 17;
    constexpr std::array columns = {waterColumn, continuumColumn, methaneColumn, oxygenColumn};
    const auto file = data / "modtran" / "pyradi" / "horizon5kmtropical.fl7";
    PublishedRun run;
    std::vector<Diagnostic> diagnostics;
    std::size_t number = 0;
    for (const std::string& line : readTextLines(file)) {
        if (++number <= headerLines)
            continue;
        std::istringstream words(line);
        std::vector<double> values;
        for (std::string word; values.size() <= oxygenColumn && words >> word;)
            values.push_back(parseNumber(word).value_or(-1.0));
        if (values.size() == 1) // the mark of the end
            break;
        auto isTransmittance = [&](std::size_t column) {
            return values[column] >= 0.0 && values[column] <= 1.0;
        };
        if (values.size() <= oxygenColumn || values[0] <= 0.0 ||
            !std::ranges::all_of(columns, isTransmittance)) {
            diagnostics.push_back({file.string(), "line " + std::to_string(number),
                                   line.substr(0, 60), "a wavenumber and transmittances"});
            continue;
        }
        run.wavenumber_per_cm.push_back(values[0]);
        run.water.push_back(values[waterColumn]);
        run.waterContinuum.push_back(values[continuumColumn]);
        run.methane.push_back(values[methaneColumn]);
        run.oxygen.push_back(values[oxygenColumn]);
    }
    if (diagnostics.empty() && run.wavenumber_per_cm.empty())
        diagnostics.push_back({file.string(), "", "no rows", "rows of a MODTRAN run"});
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    return run;
}

AtmosphericState PublishedRun::air() {
    return Profile::model(ModelAtmosphere::tropical).at(0.0);
}

} // namespace irsg::lbl
