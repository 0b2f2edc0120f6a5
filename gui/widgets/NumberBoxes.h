#pragma once

#include <QDoubleSpinBox>
#include <QSpinBox>

namespace smat::gui {

/// Boxes with arrows whose text follows the rule of typedNumber(): nothing that is typed is
/// swallowed, a text that is no number of the range gives way to the value before the typing and is
/// refused with a sentence. A value is in force when the typing is over.

/// A number with its unit as the suffix.
class RealBox : public QDoubleSpinBox {
    Q_OBJECT

  public:
    RealBox(const QString& name, const QString& unit, QWidget* parent = nullptr);

  protected:
    QValidator::State validate(QString& text, int& position) const override;
    double valueFromText(const QString& text) const override;
    void fixup(QString& text) const override;

  private:
    QString problemOf(const QString& text) const;

    QString unit_;
};

/// A whole number; a suffix may be words.
class WholeBox : public QSpinBox {
    Q_OBJECT

  public:
    explicit WholeBox(const QString& name, QWidget* parent = nullptr);

  protected:
    QValidator::State validate(QString& text, int& position) const override;
    int valueFromText(const QString& text) const override;
    void fixup(QString& text) const override;

  private:
    QString problemOf(const QString& text) const;
};

} // namespace smat::gui
