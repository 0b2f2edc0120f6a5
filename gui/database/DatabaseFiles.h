#pragma once

#include <QCoreApplication>
#include <QStringList>

#include "gui/database/EditorContext.h"
#include "gui/widgets/LatestTask.h"
#include "gui/workbench/ModelStore.h"
#include "irsg/geometry/model/IndexNames.h"

namespace smat::gui {

/// Of dialogs that ask for a signature database.
QStringList databaseFilters();

/// Opens and saves the database that is edited, and asks where that would lose something.
class DatabaseFiles {
    Q_DECLARE_TR_FUNCTIONS(smat::gui::DatabaseFiles)

  public:
    explicit DatabaseFiles(EditorContext& context) : context_(context) {}

    /// False where a person wants to go on editing what is not saved.
    bool mayClose();
    /// The same of the databases of all models.
    bool mayCloseAll();
    void open();
    /// With an entry for every index of the model, named as the model names those faces. The model
    /// is read for it in the background: the database opens a moment later.
    void makeNew();
    void save();
    void saveAs();
    /// What the file holds now is known, and given up.
    void overwrite();

  private:
    void useNew(const ModelKey& key, const irsg::Model& model, const std::filesystem::path& file,
                const irsg::IndexNames& names);
    /// The two scaling files beside the model, where they are not there.
    void createScalings();

    EditorContext& context_;
    LatestTask naming_;
};

} // namespace smat::gui
