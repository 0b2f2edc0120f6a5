#pragma once

#include <QScrollArea>

class QLabel;

namespace smat::gui {

/// Words below a plot: as high as they need, and scrolled beyond `most_px`, so that many of them
/// leave the plot its room.
class NotesArea : public QScrollArea {
    Q_OBJECT

  public:
    NotesArea(QLabel* notes, int most_px, QWidget* parent);

  protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void fit();
    int most_px_;
};

} // namespace smat::gui
