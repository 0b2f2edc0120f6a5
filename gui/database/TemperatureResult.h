#pragma once

#include <array>

#include <QWidget>

#include "irsg/signature/SurfaceTemperature.h"

class QLabel;
class QTreeWidget;
class QToolButton;

namespace smat::gui {

class NumberField;

/// What eq. 7 gives in a state, term by term. The state is the project's until a person tries
/// another one here, which changes nothing but this view.
class TemperatureResult : public QWidget {
    Q_OBJECT

  public:
    explicit TemperatureResult(QWidget* parent = nullptr);

    void setTerms(const irsg::TemperatureTerms& terms);
    void setProjectState(const irsg::EntityState& state);
    const irsg::EntityState& state() const { return state_; }

  private:
    void showState();
    void refresh();

    irsg::TemperatureTerms terms_;
    irsg::EntityState project_, state_;
    bool tried_ = false;
    std::array<NumberField*, 5> fields_{};
    QToolButton* back_ = nullptr;
    QTreeWidget* list_ = nullptr;
    QLabel* sum_ = nullptr;
};

} // namespace smat::gui
