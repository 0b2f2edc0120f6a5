#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "irsg/signature/Lint.h"
#include "smatcore/project/SceneBuilder.h"

namespace smat {

/// Which models of a project name a signature database, whether it exists yet or not, in the order
/// of the project.
std::vector<std::size_t> modelsWith(const Project& project, const std::filesystem::path& database);

/// What a project asks of one of its signature databases: the models it stands for with the entries
/// that stand in for codes without one, the bands of the sensor, and every state that the analyses
/// take (without any, that of the project's own settings). The scope's models are those of
/// modelsWith(), in its order. The aspect angle is that of the target;
/// another model's changes with its place and is left at 0.
///
/// `builder` loads the models. Throws InputError where no model of the project names the database,
/// and with the diagnostics of models, sensors, atmospheres and sweeps that cannot be used.
irsg::LintScope lintScopeOf(const Project& project, const std::filesystem::path& database,
                            SceneBuilder& builder);

} // namespace smat
