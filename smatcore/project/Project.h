#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "irsg/geometry/model/Model.h"
#include "irsg/geometry/view/Pose.h"
#include "smatcore/data/StateOverride.h"
#include "smatcore/project/AnalysisKind.h"
#include "smatcore/settings/Settings.h"

namespace smat {

/// What one unit of a model's file may be.
inline constexpr double leastModelUnit_m = 1e-6, mostModelUnit_m = 1e6;

/// One model of a project. The first is the target: it stands at the origin at `target.altitude`
/// with the attitude of `target.yaw`, `.pitch` and `.roll`, and the camera looks at its reference
/// point. The others stand where their own pose says and do what their own state says; where it
/// says nothing, they do what the target does.
struct ProjectModel {
    std::string name = {};          ///< the file's name where it is empty
    std::filesystem::path file;     ///< relative to the project file, or absolute
    std::filesystem::path database; ///< the same
    irsg::ModelOptions options = {};
    irsg::Pose pose = {};   ///< world: m east, north, altitude; not of the target
    StateOverride own = {}; ///< not of the target
    /// In model axes; the centre of the bounding box where it is not set.
    std::optional<irsg::Vec3> referencePoint_m = {};
    std::optional<int> fallbackTemperature = {}; ///< entries that stand in for codes without one
    std::optional<int> fallbackMaterial = {};
    std::string unknownKeys = {}; ///< JSON object of keys this version does not know, kept on save

    /// The name, or that of the file.
    std::string shownName() const { return name.empty() ? file.stem().string() : name; }
    bool operator==(const ProjectModel&) const = default;
};

/// An analysis with its name; its settings override those of the project.
struct NamedAnalysis {
    std::string name;
    AnalysisKind kind = AnalysisKind::image;
    Settings settings = {};
    std::string notes = {};
    std::string unknownKeys = {};

    bool operator==(const NamedAnalysis&) const = default;
};

/// Everything a `.smat` file holds: a value, copied and compared like one.
struct Project {
    std::filesystem::path file; ///< where it was loaded from; empty for a new one
    std::string title;
    std::string notes;
    std::vector<ProjectModel> models;
    Settings settings;
    std::vector<NamedAnalysis> analyses; ///< sorted by name, names unique
    std::string unknownKeys = {};
    /// Name of the folder beside the file that keeps its results (ResultFolder); empty where there
    /// are none.
    std::string results = {};

    /// A path of the project as a path from here.
    std::filesystem::path resolve(const std::filesystem::path& path) const;
    const NamedAnalysis* find(std::string_view analysis) const;
    /// "turboprop4.smat", or the title, or "new project".
    std::string displayName() const;
    bool operator==(const Project&) const = default;
};

/// A model as a project names it: its file, resolved, and how it is read.
struct ModelKey {
    std::filesystem::path file;
    irsg::ModelOptions options = {};
    auto operator<=>(const ModelKey&) const = default;

    static ModelKey of(const Project& project, const ProjectModel& model);
};

/// A project of one model with defaults: what opening a bare model gives. A database of the same
/// name beside it (`ship.sigdb` for `ship.flt`), or `signature.sigdb`, is taken where `database` is
/// empty.
Project projectOfModel(const std::filesystem::path& model,
                       const std::filesystem::path& database = {});

} // namespace smat
