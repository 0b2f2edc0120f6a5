#pragma once

#include <array>

#include <QWidget>

#include "irsg/signature/SurfaceTemperature.h"

class QCheckBox;
class QTabBar;

namespace smat::gui {

class NodeEditor;
class NumberField;

/// The terms of eq. 7: four numbers, and four lookup tables of which one is shown at a time.
class TermsPanel : public QWidget {
    Q_OBJECT

  public:
    explicit TermsPanel(QWidget* parent = nullptr);

    void setTerms(const irsg::TemperatureTerms& terms);
    QTabBar* tables() const { return tables_; }

  signals:
    /// By the user. `field` names what was edited, for merging; `what` is the name of the step less
    /// its entry: "T0", "f(power) at 0.5".
    void edited(const irsg::TemperatureTerms& terms, const QString& field, const QString& what);
    void gestureEnded();

  private:
    NumberField* makeField(const QString& name, const QString& unit, double step,
                           const QString& help, double irsg::TemperatureTerms::*member,
                           const QString& word);
    irsg::LookupTable& table(int number);
    void showTable();

    irsg::TemperatureTerms terms_;
    std::array<NumberField*, 4> fields_{};
    QTabBar* tables_ = nullptr;
    QCheckBox* loop_ = nullptr;
    NodeEditor* nodes_ = nullptr;
    int shownTable_ = -1;
};

} // namespace smat::gui
