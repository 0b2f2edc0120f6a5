#include "gui/widgets/ThemeColors.h"

#include <array>

#include "gui/widgets/Theme.h"

namespace smat::gui::colors {

namespace {

QColor shade(const QPalette& palette, const char* light, const char* dark) {
    return isDark(palette) ? QColor(dark) : QColor(light);
}

} // namespace

QColor wrongField(const QPalette& palette) {
    return shade(palette, "#ffe3e3", "#5a2a2e");
}
QColor errorText(const QPalette& palette) {
    return shade(palette, "#b3261e", "#ff9d9d");
}
QColor warningText(const QPalette& palette) {
    return shade(palette, "#c2410c", "#ff9a6b");
}
QColor notice(const QPalette& palette) {
    return shade(palette, "#fff6dd", "#3a3322");
}
QColor noticeFrame(const QPalette& palette) {
    return shade(palette, "#ecd48a", "#6b5a2a");
}

QColor imageSurround(const QPalette& palette) {
    return shade(palette, "#e3e6eb", "#14161a");
}
QColor imageMark() {
    return {"#ffd43b"};
}
QColor imageMarkSeam() {
    return Qt::black;
}
QColor outline() {
    return Qt::white;
}
QColor outlineSeam() {
    return {0, 0, 0, 150};
}
QColor textUpon(const QColor& pixel) {
    return pixel.lightness() > 140 ? QColor("#101010") : QColor("#f4f4f4");
}
QColor warnedPixel() {
    return {"#f5a600"};
}
QColor failedPixel() {
    return {"#e218a4"};
}

QColor verdictPass() {
    return {"#1f8a4c"};
}
QColor verdictWarning() {
    return {"#b36b00"};
}
QColor verdictFailure() {
    return {"#c2283c"};
}
QColor verdictDifferent() {
    return {"#56657a"};
}

QColor overlayInk(bool dark) {
    return dark ? QColor("#d6dbe4") : QColor("#333b48");
}
QColor overlayPaper(bool dark) {
    return dark ? QColor("#14171c") : QColor("#ffffff");
}
QColor axis(int which) {
    static constexpr std::array shades = {"#d64545", "#2f9e58", "#3b7be0"};
    return {shades.at(static_cast<std::size_t>(which))};
}
QColor sun() {
    return {"#ffcc00"};
}
QColor sunRim() {
    return {"#8a6a00"};
}
QColor tileFrustum() {
    return {"#e07b24"};
}
QColor ballLine(bool dark) {
    return dark ? Qt::white : Qt::black;
}
QColor problemFrame() {
    return {"#d08a1d"};
}
QColor unknownIndex() {
    return {"#808080"};
}
QColor measuredEntry() {
    return {"#3b7be0"};
}
QColor paper() {
    return Qt::white;
}

} // namespace smat::gui::colors
