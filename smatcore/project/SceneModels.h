#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "smatcore/project/Project.h"

namespace smat {

/// The model of this name, as results call it, or of this number, 0 for the target. Throws
/// InputError that calls the place of the text `where`: for none, and for several of one name.
std::size_t findModel(const Project& project, std::string_view nameOrNumber,
                      const std::string& where);

/// A name that no model of the project has: "box", then "box-2".
std::string freeModelName(const Project& project, const std::string& wanted);

/// The greatest distance that a point of its bounding box has from its origin, m.
double reachOf(const irsg::Model& model);

/// What adding a file gives: named after it, with the database that lies beside it (see
/// projectOfModel), where nothing else stands. `radii_m` are the reaches of the models of the
/// project, the last that of the new one. It stands east of them
/// all, north 0, at the altitude and with the heading of the target.
ProjectModel besideOthers(const Project& project, const std::filesystem::path& file,
                          const std::vector<double>& radii_m);

/// Puts another model in the place of the target, and the origin of the world with it: nothing
/// moves and nothing changes its state, but the camera now looks at this one. What it did of its
/// own becomes the state of the settings; models that did as the old target did keep that as their
/// own. The settings of single analyses stay: what they say of the target they say of the new one.
/// Throws InputError where settings cannot hold its place, and then the project is as it was.
void makeTarget(Project& project, std::size_t model);

/// Takes a model out. Where it is the target, the next one takes its place (makeTarget). Throws
/// InputError for the last one.
void removeModel(Project& project, std::size_t model);

} // namespace smat
