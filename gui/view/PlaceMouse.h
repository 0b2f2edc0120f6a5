#pragma once

#include <functional>
#include <optional>

#include <QObject>
#include <QPointF>

#include "gui/view/PlaceHandles.h"

class QMouseEvent;
class QWidget;

namespace smat::gui {

/// Lets the left button drag the handles of a view; all else is left to the view.
class PlaceMouse : public QObject {
    Q_OBJECT

  public:
    /// What there is to drag now; nothing where there are no handles.
    struct Seen {
        PlaceHandles handles;
        ViewProjection projection;
    };
    PlaceMouse(QWidget* view, std::function<std::optional<Seen>()> seen);

    /// Under the mouse, or dragged.
    std::optional<PlaceHandle> lit() const { return dragged_ ? dragged_ : lit_; }
    bool isDragging() const { return dragged_.has_value(); }
    /// Nothing is dragged any more.
    void drop();

  signals:
    void litChanged();
    void begun(smat::gui::PlaceHandle handle);
    /// How much the value has changed since it began, in m or degrees.
    void dragged(smat::gui::PlaceHandle handle, double change);
    void ended();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool move(const QMouseEvent& event);
    void light(std::optional<PlaceHandle> handle);

    QWidget* view_;
    std::function<std::optional<Seen>()> seen_;
    std::optional<PlaceHandle> lit_, dragged_;
    QPointF last_;
    double change_ = 0.0;
};

} // namespace smat::gui
