#pragma once

#include <utility>

#include <QDoubleSpinBox>
#include <QSpinBox>

namespace smat::gui {

/// A box with arrows whose text follows the rule of typedNumber(): nothing that is typed is
/// swallowed, a text that is no number of the range gives way to the value before the typing and is
/// refused with a sentence. A value is in force when the typing is over. `Box` is QDoubleSpinBox,
/// or QSpinBox for whole numbers.
template <typename Box>
class TypedBox : public Box {
  public:
    /// `unit` may follow the number, as another of its quantity may.
    TypedBox(const QString& name, const QString& unit, QWidget* parent);

  protected:
    using Value = decltype(std::declval<const Box&>().value());
    QValidator::State validate(QString& text, int& position) const override;
    Value valueFromText(const QString& text) const override;
    void fixup(QString& text) const override;

  private:
    QString typedIn(const QString& text) const;
    QString problemOf(const QString& text) const;
    bool isSpecial(const QString& text) const;

    QString unit_;
};

/// A number with its unit as the suffix.
class RealBox : public TypedBox<QDoubleSpinBox> {
  public:
    RealBox(const QString& name, const QString& unit, QWidget* parent = nullptr);
    /// Without zeros behind the last digit that counts: "5", "0.25".
    QString textFromValue(double value) const override;
};

/// A whole number; a suffix may be words.
class WholeBox : public TypedBox<QSpinBox> {
  public:
    explicit WholeBox(const QString& name, QWidget* parent = nullptr)
        : TypedBox(name, {}, parent) {}
};

} // namespace smat::gui
