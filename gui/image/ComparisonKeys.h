#pragma once

#include <QList>
#include <QObject>
#include <QString>

class QKeyEvent;

namespace smat::gui {

class ComparisonBar;
class ComparisonPanes;
class ComparisonReport;
class ComparisonWindow;

/// What the keys of a comparison do, on its buttons, images and numbers.
class ComparisonKeys : public QObject {
    Q_OBJECT

  public:
    ComparisonKeys(ComparisonWindow* window, ComparisonBar& bar, ComparisonPanes& panes,
                   ComparisonReport& report);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool press(const QKeyEvent& event);
    bool pressOnColors(const QKeyEvent& event);

    ComparisonBar& bar_;
    ComparisonPanes& panes_;
    ComparisonReport& report_;
};

/// Keys of the comparison and what they do, beside those of images.
QList<std::pair<QString, QString>> comparisonKeys();

} // namespace smat::gui
