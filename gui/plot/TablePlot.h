#pragma once

#include <memory>
#include <optional>

#include <QWidget>

#include "gui/plot/TableDrawing.h"

namespace smat::gui {

/// A signature table in a window: map and ball. The ball follows a drag and the arrow keys; what is
/// under the mouse is read.
class TablePlot : public QWidget {
    Q_OBJECT

  public:
    explicit TablePlot(std::shared_ptr<const ResultTable> table, QWidget* parent = nullptr);

    TableDrawing& drawing() { return drawing_; }
    const TableDrawing& drawing() const { return drawing_; }
    /// After a change of the drawing.
    void refresh();
    /// Middle of the ball, for whoever wants to take hold of it.
    QPointF ballCentre() const;
    int directionAt(const QPointF& point) const;

  signals:
    /// Of what is under the mouse; empty beside map and ball.
    void hovered(const QString& words);
    /// The ball, or what is shown.
    void changed();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

  private:
    double letter() const;
    void turn(double azimuth_deg, double elevation_deg);

    TableDrawing drawing_;
    std::optional<QPointF> heldAt_;
};

/// Size of a table on paper, pixels of 1/96 inch.
inline constexpr QSize tablePaper{1100, 560};
/// Writes map, ball and bar, black on white: .svg, .pdf, .png, or the shown cells as .csv. Throws
/// irsg::InputError as exportPlot does.
void exportTable(const TableDrawing& drawing, const std::filesystem::path& file,
                 QSize size = tablePaper);
QImage tablePicture(const TableDrawing& drawing, QSize size = tablePaper);

} // namespace smat::gui
