#include "gui/database/DatabasePreview.h"

#include <QApplication>

#include "gui/database/DatabaseDock.h"
#include "gui/view/SceneView.h"
#include "gui/workbench/Workbench.h"

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
                workbench_.chooseModel(static_cast<std::size_t>(model));
                dock_.selectCodes(temperature, material);
                view_.setHighlighted(
                    {.temperature = temperature, .material = material, .model = model});
            });
    connect(&view_, &SceneView::nothingPicked, this, [this] { view_.setHighlighted({}); });
    followEdits();
}

void DatabasePreview::followEdits() {
    auto edited = workbench_.editedDatabases();
    for (const auto& [file, database] : shown_)
        if (!edited.contains(file))
            view_.setEditedDatabase(file, nullptr);
    for (const auto& [file, database] : edited)
        if (const auto before = shown_.find(file);
            before == shown_.end() || before->second != database)
            view_.setEditedDatabase(file, database);
    shown_ = std::move(edited);
}

void DatabasePreview::markCurrent() {
    FaceSelection selection;
    selection.model = static_cast<int>(workbench_.chosenModel());
    if (const auto key = dock_.current(); key && key->kind == EntryKind::temperature)
        selection.temperature = key->index;
    else if (key && key->kind == EntryKind::material)
        selection.material = key->index;
    view_.setHighlighted(selection.empty() ? FaceSelection() : selection);
}

} // namespace smat::gui

#include "moc_DatabasePreview.cpp"
