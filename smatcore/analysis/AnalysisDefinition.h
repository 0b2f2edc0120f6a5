#pragma once

#include <cstddef>
#include <vector>

#include "irsg/core/Errors.h"
#include "irsg/core/Quantity.h"
#include "smatcore/project/AnalysisKind.h"
#include "smatcore/settings/SettingInfo.h"
#include "smatcore/settings/Settings.h"

namespace smat {

struct AnalysisPlan;
struct Project;

/// What an analysis comes to.
enum class AnalysisForm {
    image,    ///< one picture, with a row of sums
    spectrum, ///< one view, a row for each wavenumber
    sweep,    ///< a row for each case
    table     ///< of a tool: neither planned nor drawn here
};

/// All that the program knows of one kind of analysis: command, project file, menu, dialog, manual,
/// planning, columns and summary come from here. A new kind is a file with its definition, its name
/// in the list ANALYSES of smatcore/CMakeLists.txt, and an icon.
struct AnalysisDefinition {
    const char* name;  ///< "polar"
    const char* title; ///< "Polar plot"
    const char* help;  ///< one line, for the command
    const char* icon;  ///< of resources/icons
    AnalysisForm form = AnalysisForm::sweep;
    /// Of a plot whose `<name>.steps` are adaptive or fixed: the setting that fixes its cases,
    /// which is `auto` or a number. Null of others.
    const char* step = nullptr;
    /// Of this kind alone; their keys begin with `name` and a dot. Null where there are none.
    std::vector<SettingInfo> (*settings)() = nullptr;
    /// Fills coordinate, columns and cases. What does not fit goes into `diagnostics`, by the key
    /// of the setting. Null of a tool.
    void (*plan)(AnalysisPlan& plan, const Project& project, const Settings& settings,
                 std::vector<irsg::Diagnostic>& diagnostics) = nullptr;
    /// Keys of settings of the view that it takes no notice of, because it varies them or sets them
    /// by itself. Null where there are none.
    std::vector<std::string> (*ignored)(const Settings& settings) = nullptr;
    /// Its table is one over azimuth and elevation, which tableFormats() write, too.
    bool isOverDirections = false;
    /// What earlier versions called it: still a command, with a remark, and read in results.
    const char* formerName = nullptr;
};

/// Of sweeps: at most so many cases.
inline constexpr double mostCases = 1e6;

/// `first + i step` without the digits that binary fractions leave behind: 0.3, not
/// 0.30000000000000004.
double stepped(double first, std::size_t i, double step);

} // namespace smat
