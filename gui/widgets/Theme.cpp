#include "gui/widgets/Theme.h"

#include <algorithm>
#include <array>
#include <optional>

#include <QApplication>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QStyleFactory>
#include <QSvgRenderer>

#include "irsg/core/Errors.h"

namespace smat::gui {
namespace {

struct Shades {
    const char *window, *base, *alternate, *button, *text, *faint, *accent, *tip, *link;
};
constexpr Shades lightShades{"#f4f5f7", "#ffffff", "#f0f2f5", "#fafbfc", "#1f2430",
                             "#697080", "#2f6fde", "#ffffff", "#1d5bc4"};
constexpr Shades darkShades{"#23262d", "#1b1d23", "#22252c", "#2d3139", "#e6e8ec",
                            "#949ba8", "#4c8dff", "#31353e", "#7fb0ff"};

QPalette makePalette(const Shades& shades) {
    QPalette palette{QColor(shades.button), QColor(shades.window)};
    const QColor text(shades.text);
    const QColor faint(shades.faint);
    palette.setColor(QPalette::Base, QColor(shades.base));
    palette.setColor(QPalette::AlternateBase, QColor(shades.alternate));
    palette.setColor(QPalette::ToolTipBase, QColor(shades.tip));
    palette.setColor(QPalette::Link, QColor(shades.link));
    palette.setColor(QPalette::Highlight, QColor(shades.accent));
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::PlaceholderText, faint);
    for (const auto role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
        palette.setColor(role, text);
        palette.setColor(QPalette::Disabled, role, faint);
    }
    palette.setColor(QPalette::Disabled, QPalette::Highlight, faint);
    return palette;
}

/// Draws an SVG in the palette's text colour at whatever size and pixel ratio is asked, so that a
/// change of theme or screen needs no new icons.
class DrawnIcon : public QIconEngine {
  public:
    DrawnIcon(QByteArray svg, std::optional<QPalette> palette)
        : svg_(std::move(svg)), palette_(std::move(palette)) {}
    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        const QPalette palette = palette_.value_or(QApplication::palette());
        QByteArray svg = svg_;
        svg.replace(
            "currentColor",
            palette
                .color(mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active,
                       mode == QIcon::Selected ? QPalette::HighlightedText : QPalette::ButtonText)
                .name()
                .toLatin1());
        const double side = std::min(rect.width(), rect.height());
        QSvgRenderer(svg).render(painter, QRectF(rect.center().x() + 0.5 - side / 2,
                                                 rect.center().y() + 0.5 - side / 2, side, side));
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(0, 0), size), mode, state);
        return pixmap;
    }
    QIconEngine* clone() const override { return new DrawnIcon(*this); }

  private:
    QByteArray svg_;
    std::optional<QPalette> palette_;
};

QIcon drawn(const QString& name, std::optional<QPalette> palette) {
    QFile file(":/icons/" + name + ".svg");
    if (!file.open(QIODevice::ReadOnly))
        throw irsg::LogicError("no icon named " + name.toStdString());
    return QIcon(new DrawnIcon(file.readAll(), std::move(palette)));
}

} // namespace

bool isDark(const QPalette& palette) {
    return palette.color(QPalette::Window).lightness() < 128;
}

bool isDark(ThemeMode mode, const QPalette& desktop) {
    return mode == ThemeMode::dark || (mode == ThemeMode::system && isDark(desktop));
}

void applyTheme(QApplication& application, ThemeMode mode) {
    static const QPalette desktop = QApplication::palette(); // before it is ours
    const bool dark = isDark(mode, desktop);
    // Each change of the style, too, polishes every widget anew: once in a program is enough.
    static const char* const styled = "smat-style";
    if (!application.property(styled).toBool()) {
        application.setStyle(QStyleFactory::create("Fusion"));
        application.setProperty(styled, true);
    }
    application.setPalette(makePalette(dark ? darkShades : lightShades));
    const Shades& shades = dark ? darkShades : lightShades;
    application.setStyleSheet(
        QStringLiteral("QToolTip { padding: 4px; color: %1; background: %2; border: 1px solid %3; }"
                       "QToolBar { border: 0; padding: 4px; spacing: 4px; }"
                       "QDockWidget { titlebar-close-icon: url(:/icons/close-%7.svg);"
                       "              titlebar-normal-icon: url(:/icons/float-%7.svg); }"
                       "QDockWidget::title { padding: 6px 8px; }"
                       "QDockWidget::close-button, QDockWidget::float-button"
                       " { border: 0; padding: 0; icon-size: 14px; }"
                       "QTabBar::close-button { image: url(:/icons/close-%7.svg); }"
                       "QTabBar::close-button:hover { background: %4; border-radius: 3px; }"
                       "QTabWidget::pane { border: 0; border-top: 1px solid %4; }"
                       "QTabBar::tab { padding: 7px 14px; border: 0; color: %3;"
                       "               border-bottom: 2px solid transparent; }"
                       "QTabBar::tab:hover { color: %1; }"
                       "QTabBar::tab:selected { color: %1; border-bottom: 2px solid %5; }"
                       "QCheckBox::indicator, QTreeView::indicator"
                       " { width: 14px; height: 14px; border: 1px solid %3;"
                       "   border-radius: 3px; background: %6; }"
                       "QCheckBox::indicator:checked, QTreeView::indicator:checked"
                       " { background: %5; border-color: %5; image: url(:/icons/check.svg); }"
                       "QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }"
                       "QTabBar { qproperty-drawBase: 0; }"
                       "QTreeView::item { padding: 1px 0; }"
                       "QStatusBar::item { border: 0; }")
            .arg(shades.text, shades.tip, shades.faint, dark ? "#3a3f49" : "#d9dde4", shades.accent,
                 shades.base, dark ? "dark" : "light"));
}

QIcon icon(const QString& name, const QPalette& palette) {
    return drawn(name, palette);
}

QIcon icon(const QString& name) {
    return drawn(name, std::nullopt);
}

PlotStyle PlotStyle::screen(const QPalette& palette) {
    PlotStyle style;
    style.dark = isDark(palette);
    style.background = palette.color(QPalette::Base);
    style.canvas = palette.color(QPalette::Base);
    style.text = palette.color(QPalette::Active, QPalette::Text);
    style.faintText = palette.color(QPalette::PlaceholderText);
    style.frame = style.dark ? QColor("#4a505c") : QColor("#b9bfca");
    style.grid = style.dark ? QColor("#3a3f49") : QColor("#dde1e8");
    style.minorGrid = style.dark ? QColor("#2b2f37") : QColor("#eef0f4");
    style.crosshair = style.dark ? QColor("#aeb4c0") : QColor("#5d6472");
    return style;
}

PlotStyle PlotStyle::paper() {
    PlotStyle style;
    style.background = style.canvas = Qt::white;
    style.text = QColor("#1a1a1a");
    style.faintText = QColor("#6b6b6b");
    style.frame = QColor("#8a8f98");
    style.grid = QColor("#d5d9e0");
    style.minorGrid = QColor("#eceef2");
    style.crosshair = QColor("#5d6472");
    return style;
}

QColor PlotStyle::curve(int index) const {
    static constexpr std::array<const char*, 8> onLight{"#1f5fd0", "#d9480f", "#0b8a6a", "#a02c8f",
                                                        "#b38600", "#0c7ea8", "#8a4b2a", "#5b6270"};
    static constexpr std::array<const char*, 8> onDark{"#6ea8ff", "#ff8a4c", "#3fd0a6", "#e07bd2",
                                                       "#f0c445", "#5cc8f0", "#d39a74", "#b4bac6"};
    const auto wrapped = static_cast<std::size_t>(index) % onLight.size();
    return QColor(dark ? onDark[wrapped] : onLight[wrapped]);
}

} // namespace smat::gui
