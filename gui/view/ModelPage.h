#pragma once

#include <functional>

#include <QWidget>

#include "gui/view/SceneView.h"
#include "gui/widgets/Exportable.h"

class QAction;
class QActionGroup;
class QComboBox;
class QMenu;
class QToolButton;

namespace smat::gui {

class ColorBar;
class FlowBar;

/// The tab of the model: the 3-D view under a strip that switches between its displays, beside the
/// colour bar of the infrared one. Owns the actions of the view, for the menu and their shortcuts.
class ModelPage : public QWidget, public Exportable {
    Q_OBJECT

  public:
    explicit ModelPage(QWidget* parent = nullptr);

    SceneView* view() const { return view_; }
    ColorBar* colorBar() const { return bar_; }
    /// Puts a field of somebody else beside the displays, above the view.
    void addField(QWidget* field);
    void showHandles(bool on);
    /// Those that need a model.
    QList<QAction*> modelActions() const { return QList<QAction*>{fit_} + sides_; }
    /// The one that needs several.
    QAction* fitChosenAction() const { return fitChosen_; }
    /// Of exported pictures: the name of what is open.
    void setTitle(const QString& title) { title_ = title; }
    /// Displays, quantity, colour map, wireframe, axes, sun vector.
    void fillMenu(QMenu* menu);

    /// .png: the view as it is seen, with its conditions and the colour bar of the infrared
    /// display. Of that also the values: .exr with all planes, .csv with the one that is shown.
    QStringList exportFilters() const override;
    void exportTo(const std::filesystem::path& file) const override;

  private:
    QAction* toggle(const char* name, const QString& text, const QKeySequence& keys,
                    const QString& tip, bool on, const std::function<void(bool)>& set);
    void makeActions();
    void makeCameraActions();
    void makeStrip();
    void refresh();
    void refreshBar();
    QImage pictureOfPage() const;

    QString title_;
    SceneView* view_ = nullptr;
    ColorBar* bar_ = nullptr;
    QWidget* barHolder_ = nullptr;
    QAction* infrared_ = nullptr;
    QAction* apparent_ = nullptr;
    QAction* nextMap_ = nullptr;
    QActionGroup* maps_ = nullptr;
    QList<QAction*> toggles_, onStrip_; ///< in the menu; of them, in the strip
    QAction* handles_ = nullptr;
    QAction* inspection_ = nullptr;
    QAction *fit_ = nullptr, *fitChosen_ = nullptr;
    QList<QAction*> sides_;
    FlowBar* strip_ = nullptr;
    QToolButton* sensorButton_ = nullptr;
    QToolButton* inspectButton_ = nullptr;
    QToolButton* visibleButton_ = nullptr;
    QToolButton* infraredButton_ = nullptr;
    QComboBox* quantityBox_ = nullptr;
    QComboBox* mapBox_ = nullptr;
};

} // namespace smat::gui
