#pragma once

#include <QCoreApplication>
#include <QStringList>

#include "gui/database/EditorContext.h"

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
    void open();
    /// With an entry for every index of the model.
    void makeNew();
    void save();
    void saveAs();
    /// What the file holds now is known, and given up.
    void overwrite();

  private:
    /// The two scaling files beside the model, where they are not there.
    void createScalings();

    EditorContext& context_;
};

} // namespace smat::gui
