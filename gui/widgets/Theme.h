#pragma once

#include <QColor>
#include <QIcon>
#include <QPalette>
#include <QString>

class QApplication;

namespace smat::gui {

enum class ThemeMode { system, light, dark };

/// Fusion in a light or a dark palette; `system` takes the darkness of the desktop's own palette.
/// Every colour of the program derives from this palette or from PlotStyle.
void applyTheme(QApplication& application, ThemeMode mode = ThemeMode::system);
bool isDark(const QPalette& palette);
/// Whether a theme is dark on a desktop of this palette, which ThemeMode::system follows.
bool isDark(ThemeMode mode, const QPalette& desktop);

/// The drawing resources/icons/NAME.svg in the text colour of a palette, by itself of the one the
/// application has when it is drawn. An unknown name is a LogicError.
QIcon icon(const QString& name, const QPalette& palette);
QIcon icon(const QString& name);

/// Colours of a plot: on screen they follow the palette, on paper they are black on white.
struct PlotStyle {
    QColor background, canvas, text, faintText, frame, grid, minorGrid, crosshair;
    bool dark = false;

    static PlotStyle screen(const QPalette& palette);
    static PlotStyle paper();
    /// Distinct colours that stay apart for the usual kinds of colour blindness; repeats after 8.
    QColor curve(int index) const;
};

} // namespace smat::gui
