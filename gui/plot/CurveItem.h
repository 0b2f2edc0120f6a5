#pragma once

#include <QColor>
#include <QPen>
#include <QwtText>

namespace smat::gui {

/// Of the areas of a stack.
inline constexpr float layerOpacity = 0.6F;

/// What a plot does with its curves, whatever its coordinates.
class CurveItem {
  public:
    virtual ~CurveItem() = default;
    virtual void setShown(bool shown) = 0;
    virtual bool isShown() const = 0;
    /// The name in the legend, in its colour.
    virtual void setName(const QwtText& name) = 0;
    virtual void setLine(const QPen& pen) = 0;

    /// Errors are drawn as a band, where there are any.
    void setBandVisible(bool visible) { bandVisible_ = visible; }
    bool isBandVisible() const { return bandVisible_; }

    /// The colour inside the points that warn of something: that of the canvas.
    void setHollowFill(const QColor& color) { hollowFill_ = color; }
    const QColor& hollowFill() const { return hollowFill_; }

  private:
    bool bandVisible_ = true;
    QColor hollowFill_;
};

/// A curve of Qwt as such an item.
template <typename QwtCurve>
class CurveItemOf : public QwtCurve, public CurveItem {
  public:
    using QwtCurve::QwtCurve;
    void setShown(bool shown) override { QwtCurve::setVisible(shown); }
    bool isShown() const override { return QwtCurve::isVisible(); }
    void setName(const QwtText& name) override { QwtCurve::setTitle(name); }
    void setLine(const QPen& pen) override {
        QwtCurve::setPen(pen);
        QwtCurve::legendChanged(); // its line, too, which the curves of polar plots forget
    }
};

} // namespace smat::gui
