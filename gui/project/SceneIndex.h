#pragma once

#include <map>
#include <vector>

#include <QString>

#include "gui/workbench/ModelStore.h"
#include "irsg/signature/SignatureDatabase.h"
#include "smatcore/project/Project.h"

namespace smat::gui {

enum class IndexKind { temperature, material };

/// One index of temperature or material: what of the model carries it and what the database says.
struct IndexUse {
    QString name;            ///< of the entry; empty without one
    int faces = 0;           ///< as irsg::CodeUse counts them
    double area_m2 = 0.0;    ///< drawn
    bool hasEntry = false;   ///< in the database
    bool isReplaced = false; ///< without an entry, but the project names one that stands in
    bool isMissing() const { return faces > 0 && !hasEntry && !isReplaced; }
};

/// What a model and its database hold, by index; or why they cannot be read.
struct ModelIndex {
    QString modelProblem, databaseProblem;
    std::map<int, IndexUse> temperatures, materials;
};

using ModelCodes = std::map<irsg::IrCodes, irsg::CodeUse>;

/// Puts what a model uses beside what a database has.
ModelIndex makeModelIndex(const ProjectModel& model, const ModelCodes& codes,
                          const irsg::SignatureDatabase& database);

/// Reads the files of all models; takes its time. Nothing is thrown: what is wrong is in the index.
std::vector<ModelIndex> loadSceneIndex(const Project& project, ModelStore& models);

} // namespace smat::gui
