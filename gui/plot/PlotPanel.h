#pragma once

#include <filesystem>
#include <map>

#include <QWidget>

#include "gui/plot/PlotExport.h"
#include "gui/widgets/Dialogs.h"

class QAction;
class QHBoxLayout;
class QMenu;

namespace smat::gui {

class PlotSurface;

enum class PlotKind { cartesian, polar };

/// A plot with its toolbar; the same commands are in the menu of the right button. Whoever shows
/// it puts what is its own in front of the bar.
class PlotPanel : public QWidget {
    Q_OBJECT

  public:
    PlotPanel(PlotKind kind, Dialogs dialogs, QWidget* parent = nullptr);

    /// The one of its kind; the other is null.
    CartesianPlot* cartesian() const { return cartesian_; }
    PolarPlot* polar() const { return polar_; }
    PlotSurface& surface() const { return *surface_; }
    void addInFront(QWidget* widget);
    /// By object name: "logX", "logY", "decibel", "resetView", "undoZoom", "crosshair",
    /// "errorBands", "axisLimits", "copyPicture", "copyValues", "copyAllValues", "savePlot",
    /// "saveValues", "saveAllValues". LogicError for another, and for one of the other kind.
    QAction* action(const QString& name) const;
    /// What the data brought along: whether axes are logarithmic, whether there are errors.
    void refresh();

    /// Writes a picture, or the visible values as .csv. Throws irsg::InputError.
    void exportTo(const std::filesystem::path& file) const;
    void copyPicture() const;
    void copyValues(PlotPart part) const;

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void makeViewActions();
    void makeCopyAndSaveActions();
    void makeBar();
    QAction* add(const QString& name, const QString& icon, const QString& text);
    QMenu* menuOf(const QString& name, const QStringList& actions);
    void typeLimits();
    void savePicture();
    void saveValues(PlotPart part);
    QString valuesOf(PlotPart part, QChar separator) const;

    Dialogs dialogs_;
    CartesianPlot* cartesian_ = nullptr;
    PolarPlot* polar_ = nullptr;
    PlotSurface* surface_ = nullptr;
    QHBoxLayout* front_ = nullptr;
    std::map<QString, QAction*> actions_;
};

} // namespace smat::gui
