#include "apps/atmosphere-tables/PublishedRun.h"

#include <sstream>

#include "irsg/atmosphere/engine/Profile.h"
#include "irsg/atmosphere/lbl/LineListFile.h"
#include "irsg/radiometry/CsvTable.h"
#include "irsg/radiometry/Errors.h"

namespace smat::tables {

PublishedRun PublishedRun::read(const std::filesystem::path& data) {
    constexpr std::size_t headerLines = 13, waterColumn = 7, oxygenColumn = 17;
    const auto file = data / "modtran" / "pyradi" / "horizon5kmtropical.fl7";
    PublishedRun run;
    std::vector<irsg::Offence> offences;
    std::size_t number = 0;
    for (const std::string& line : irsg::lbl::readTextLines(file)) {
        if (++number <= headerLines)
            continue;
        std::istringstream words(line);
        std::vector<double> values;
        for (std::string word; values.size() <= oxygenColumn && words >> word;)
            values.push_back(irsg::parseNumber(word).value_or(-1.0));
        if (values.size() == 1) // the mark of the end
            break;
        auto isTransmittance = [](double value) { return value >= 0.0 && value <= 1.0; };
        if (values.size() <= oxygenColumn || values[0] <= 0.0 ||
            !isTransmittance(values[waterColumn]) || !isTransmittance(values[oxygenColumn])) {
            offences.push_back({file.string(), "line " + std::to_string(number), line.substr(0, 60),
                                "a wavenumber and transmittances"});
            continue;
        }
        run.wavenumber_cm.push_back(values[0]);
        run.waterContinuum.push_back(values[waterColumn]);
        run.oxygen.push_back(values[oxygenColumn]);
    }
    if (offences.empty() && run.wavenumber_cm.empty())
        offences.push_back({file.string(), "", "no rows", "rows of a MODTRAN run"});
    if (!offences.empty())
        throw irsg::InputError(std::move(offences));
    return run;
}

irsg::AirState PublishedRun::air() {
    return irsg::Profile::model(irsg::ModelAtmosphere::tropical).at(0.0);
}

} // namespace smat::tables
