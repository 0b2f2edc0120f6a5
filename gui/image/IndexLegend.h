#pragma once

#include <optional>
#include <vector>

#include <QListWidget>

#include "gui/image/IndexColors.h"

class QPainter;

namespace smat::gui {

struct PlotStyle;

/// The colours of a picture that is coloured by index, with the names of the indices; beside them
/// how many pixels each has. The one under the mouse, or at the pixel that is read, is marked.
class IndexLegend : public QListWidget {
    Q_OBJECT

  public:
    explicit IndexLegend(QWidget* parent = nullptr);

    void setIndices(const QString& title, std::vector<SeenIndex> seen);
    const std::vector<SeenIndex>& indices() const { return seen_; }
    /// Marks an index; none for what has none.
    void mark(std::optional<int> index);
    /// Colours and names as they are exported: as many as there is room for, and how many more.
    void drawLegend(QPainter& painter, QSize size, const PlotStyle& style, const QFont& font) const;

  private:
    QString title_;
    std::vector<SeenIndex> seen_;
};

} // namespace smat::gui
