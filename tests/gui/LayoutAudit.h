#pragma once

#include <QStringList>
#include <QWidget>

namespace smat::gui::test {

/// What a person would find wrong with the layout of a widget that is shown: fields and buttons
/// that lie on each other, are narrower than their words, or are cut off by what is around them,
/// and areas that scroll sideways; a line each, with the names of the widgets.
QStringList layoutFaults(const QWidget& page);

} // namespace smat::gui::test
