#pragma once

#include <functional>
#include <map>
#include <memory>

#include <QColor>

#include "gui/database/DatabaseEdits.h"
#include "gui/paint/PaintDock.h"
#include "gui/view/SceneView.h"
#include "gui/widgets/Dialogs.h"
#include "gui/widgets/LatestTask.h"
#include "irsg/geometry/model/FaceChoice.h"

namespace smat::gui {

class BoxMouse;
class Workbench;

/// Joins the painter's fields with the view and the models: while the fields are in sight, a click
/// in the view chooses faces, and painting them changes what the window has of their model. Keeps
/// the models of the view as they are painted, whoever does and undoes it.
class FacePainter : public QObject {
    Q_OBJECT

  public:
    FacePainter(Workbench& workbench, const Dialogs& dialogs, SceneView& view, PaintDock& dock,
                std::function<void(const EntryKey&)> openEntry, QObject* parent);

    /// The view shows other models.
    void followScene();
    /// The faces of the model can be chosen, and the view shows what is painted.
    bool isReady() const;
    const std::shared_ptr<const irsg::FaceMesh>& mesh() const { return mesh_; }
    const irsg::FaceNumbers& chosen() const { return chosen_; }
    void choose(const irsg::FaceNumbers& faces, irsg::Choosing how = irsg::Choosing::anew);

  private:
    void connectDock();
    void setActive(bool active);
    void readMesh();
    /// Brings the models of this file in the view up to what is painted.
    void showPaint(const std::filesystem::path& file);
    bool click(const QPointF& point, Qt::KeyboardModifiers modifiers, PickBy by);
    void takeBox(const QRectF& box, Qt::KeyboardModifiers modifiers);
    void paint(bool erase);
    void addEntry(EntryKind kind);
    void chooseIndex(int index);
    void refreshChosen();
    void refreshCodes();
    void fillBoxes();
    const DisplayModel* shown() const;
    /// Of the shown model, as the renderer has it; null where it cannot be read.
    std::shared_ptr<const irsg::Model> model() const;
    std::string nameOf(EntryKind kind, int index) const;
    const irsg::SignatureDatabase* database() const;

    Workbench& workbench_;
    const Dialogs& dialogs_;
    SceneView& view_;
    PaintDock& dock_;
    std::function<void(const EntryKey&)> openEntry_;
    BoxMouse* box_ = nullptr;
    bool isActive_ = false;
    int number_ = 0; ///< of the model in the project
    ModelKey key_;   ///< whose faces mesh_ has
    std::shared_ptr<const irsg::FaceMesh> mesh_;
    irsg::FaceNumbers chosen_;
    std::map<int, QColor> colors_[2]; ///< of temperatures and materials, as they first came
    LatestTask reading_;
    std::map<std::filesystem::path, std::unique_ptr<LatestTask>> paints_; ///< by file
};

} // namespace smat::gui
