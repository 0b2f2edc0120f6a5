#include "gui/database/DatabasePreview.h"

#include <QApplication>

#include "gui/Workbench.h"
#include "gui/database/DatabaseDock.h"
#include "gui/view/SceneView.h"

namespace smat::gui {

DatabasePreview::DatabasePreview(Workbench& workbench, DatabaseDock& dock, SceneView& view,
                                 QObject* parent)
    : QObject(parent), workbench_(workbench), dock_(dock), view_(view) {
    auto& session = workbench_.database();
    connect(&session, &DatabaseSession::stateChanged, this, &DatabasePreview::followEdits);
    connect(&session, &DatabaseSession::changed, this, [this] {
        followEdits();
        view_.setHighlighted({});
    });
    connect(&workbench_, &Workbench::projectOpened, this, &DatabasePreview::followEdits);
    connect(&workbench_, &Workbench::projectChanged, this, &DatabasePreview::followEdits);
    connect(&dock_, &DatabaseDock::currentChanged, this, [this] {
        // By a person, not by what was just opened.
        const QWidget* focus = QApplication::focusWidget();
        if (focus != nullptr && dock_.isAncestorOf(focus))
            markCurrent();
    });
    connect(&view_, &SceneView::facePicked, this,
            [this](int temperature, int material, int model, const irsg::Vec3&) {
                if (model == 0)
                    dock_.selectCodes(temperature, material);
                view_.setHighlighted(
                    {.temperature = temperature, .material = material, .model = model});
            });
    connect(&view_, &SceneView::nothingPicked, this, [this] { view_.setHighlighted({}); });
    followEdits();
}

void DatabasePreview::followEdits() {
    const auto edited = workbench_.editedDatabases();
    const auto file = edited.empty() ? std::filesystem::path() : edited.begin()->first;
    const auto database = edited.empty() ? nullptr : edited.begin()->second;
    if (!file_.empty() && file != file_)
        view_.setEditedDatabase(file_, nullptr);
    if (!file.empty() && (file != file_ || database != shown_))
        view_.setEditedDatabase(file, database);
    file_ = file;
    shown_ = database;
}

void DatabasePreview::markCurrent() {
    FaceSelection selection;
    selection.model = 0;
    if (const auto key = dock_.current(); key && key->kind == EntryKind::temperature)
        selection.temperature = key->index;
    else if (key && key->kind == EntryKind::material)
        selection.material = key->index;
    view_.setHighlighted(selection.empty() ? FaceSelection() : selection);
}

} // namespace smat::gui
