#include "irsg/atmosphere/lbl/CompleteLines.h"

#include <string>

#include "irsg/atmosphere/lbl/LineListFile.h"

namespace irsg::lbl {

std::vector<LineList> completeLineLists(const std::filesystem::path& dataFolder) {
    std::vector<LineList> lists;
    for (std::size_t gas = 0; gas < lineGasCount; ++gas)
        lists.push_back(readLineList(static_cast<Gas>(gas),
                                     dataFolder / "lines" / (std::string(gasNames[gas]) + ".par.gz")));
    return lists;
}

} // namespace irsg::lbl
