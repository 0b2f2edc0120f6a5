#pragma once

#include <vector>

#include <QWidget>

#include "gui/atmosphere/AtmosphereDocument.h"
#include "gui/widgets/Dialogs.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;

namespace smat::gui {

/// The parameters of an air as fields, made from the table of AtmosphereSmart: words, unit, range,
/// help with the name in files, codes by their words. Each field has the object name of its
/// parameter. What is typed in one go is one step of the document; a text that is no value of its
/// parameter, or out of its range, is marked and goes when the typing is over. Names of values that
/// differ from the default are bold.
class ParameterForm : public QWidget {
    Q_OBJECT

  public:
    ParameterForm(AtmosphereDocument& document, Dialogs dialogs, QWidget* parent = nullptr);

    /// What is wrong with the text that is being typed; empty where nothing is.
    QString problem() const { return problem_; }

  signals:
    /// The field of this parameter has the focus.
    void entered(const irsg::SmartParameter& parameter);
    void problemChanged();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    struct Field {
        const irsg::SmartParameter* parameter;
        QLabel* label = nullptr;
        QLineEdit* text = nullptr; ///< or
        QComboBox* codes = nullptr;
    };
    void addGroup(irsg::SmartGroup group);
    void addField(QFormLayout& form, const irsg::SmartParameter& parameter);
    QWidget* makeText(Field& field);
    QWidget* makeCodes(Field& field);
    /// Shows what the document says.
    void follow();
    /// The document takes a text for a parameter, or the field is marked.
    void type(const Field& field, const QString& text);
    void finish();
    void chooseFile(const Field& field);
    void mark(const Field& field, const QString& problem);

    AtmosphereDocument& document_;
    Dialogs dialogs_;
    std::vector<Field> fields_;
    int gesture_ = AtmosphereDocument::noGesture;
    irsg::AtmosphereSmartParameters before_; ///< the typing that goes on
    QString problem_;
};

/// "Measured pressure" of PressureMH.
QString labelOf(const irsg::SmartParameter& parameter);

/// Help, range, default and name of a parameter for a tooltip or a panel, as rich text.
QString helpText(const irsg::SmartParameter& parameter);

} // namespace smat::gui
