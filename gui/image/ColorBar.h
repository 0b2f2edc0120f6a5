#pragma once

#include <QWidget>

#include "irsg/image/ColorMap.h"

class QComboBox;
class QLineEdit;

namespace smat::gui {

/// How the limits of the colours are found.
enum class LimitMode {
    target, ///< irsg::objectLimits
    full,   ///< least to largest
    locked  ///< as typed in
};

/// The legend of a false-colour picture: the colours with their values and unit, the two limits as
/// numbers to edit, and the rule that sets them.
class ColorBar : public QWidget {
    Q_OBJECT

  public:
    explicit ColorBar(QWidget* parent = nullptr);

    void setTitle(const QString& title);
    void setColors(const irsg::ColorMap& map, const irsg::DisplayLimits& limits);
    const irsg::DisplayLimits& limits() const { return limits_; }
    LimitMode mode() const;
    void setMode(LimitMode mode);

  signals:
    void limitsEdited(const irsg::DisplayLimits& limits);
    void modeChosen(LimitMode mode);

  private:
    class Scale;
    void readLimits();

    const irsg::ColorMap* map_ = nullptr;
    irsg::DisplayLimits limits_;
    Scale* scale_ = nullptr;
    QLineEdit* low_ = nullptr;
    QLineEdit* high_ = nullptr;
    QComboBox* mode_ = nullptr;
};

} // namespace smat::gui
