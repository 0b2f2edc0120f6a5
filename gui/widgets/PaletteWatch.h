#pragma once

#include <functional>

#include <QApplication>
#include <QEvent>
#include <QPalette>
#include <QWidget>

namespace smat::gui {

/// Of a widget that colours its parts by the application's palette: a change of theme at run time
/// dresses it anew. Such a widget changes its own palette by that, which is no change of theme.
class PaletteWatch {
  public:
    /// The widget has the colours of now.
    void taken() { key_ = QApplication::palette().cacheKey(); }
    /// To be called in changeEvent. The event of the application comes to windows alone, so that of
    /// the widget's own palette is what tells.
    void follow(QWidget& widget, const QEvent& event, std::function<void()> dress) const {
        // Later: Qt still gives palettes to the widgets inside.
        if (event.type() == QEvent::PaletteChange && key_ != 0 &&
            key_ != QApplication::palette().cacheKey())
            QMetaObject::invokeMethod(&widget, std::move(dress), Qt::QueuedConnection);
    }

  private:
    qint64 key_ = 0; ///< before it was dressed
};

} // namespace smat::gui
