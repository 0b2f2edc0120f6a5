#include "gui/settings/SettingForm.h"

#include <algorithm>

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/settings/TypedSetting.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/RefusedText.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/ThemeColors.h"
#include "smatcore/settings/SettingAvailability.h"

namespace smat::gui {
namespace {

/// Whether a value is typed, so that one should know what may be; the others are seen in the field.
bool isTyped(const SettingInfo& info) {
    return info.names.empty() && info.kind != SettingKind::choice &&
           info.kind != SettingKind::boolean;
}

} // namespace

QString SettingForm::helpText(const SettingInfo& info) {
    return QStringLiteral("<p style='white-space:normal'>%1</p><p><i>%2</i></p>")
        .arg(textOf(info.help).toHtmlEscaped(),
             (expectedText(info) + "; " + textOf(info.key)).toHtmlEscaped());
}

SettingForm::SettingForm(const std::vector<std::string>& keys, FileChooser chooseFile,
                         QWidget* parent, bool withHelp)
    : QWidget(parent), chooseFile_(std::move(chooseFile)), keys_(keys) {
    auto* form = layout_ = new QFormLayout(this);
    form->setContentsMargins(12, 12, 12, 12);
    form->setHorizontalSpacing(12);
    form->setVerticalSpacing(8);
    form->setLabelAlignment(Qt::AlignRight | (withHelp ? Qt::AlignTop : Qt::AlignVCenter));
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    int unitWidth = 28;
    for (const auto& key : keys)
        unitWidth = std::max(
            unitWidth, fontMetrics().horizontalAdvance(formattedUnit(settingInfo(key).unit)) + 2);
    for (const auto& key : keys) {
        const SettingInfo& info = settingInfo(key);
        QWidget* field = makeField(info);
        field->setToolTip(helpText(info));
        auto* label = new QLabel(textOf(info.label), this);
        label->setToolTip(field->toolTip());
        label->setBuddy(fields_.at(key).widget);
        const QString missing = textOf(whyUnavailable(info));
        if (!missing.isEmpty())
            for (QWidget* widget : {field, static_cast<QWidget*>(label)}) {
                widget->setEnabled(false);
                widget->setToolTip(missing);
            }

        auto* row = new QHBoxLayout;
        row->setSpacing(8);
        row->addWidget(field, 1);
        auto* unit = new QLabel(formattedUnit(info.unit), this);
        unit->setForegroundRole(QPalette::PlaceholderText);
        unit->setMinimumWidth(unitWidth); // so that all fields end in one line
        row->addWidget(unit);
        if (!withHelp) {
            form->addRow(label, row);
            continue;
        }
        QString words = textOf(info.help).toHtmlEscaped();
        if (!missing.isEmpty())
            words = tr("Not available: %1.").arg(missing.toHtmlEscaped()) + " " + words;
        if (isTyped(info)) {
            QString expected = expectedText(info).toHtmlEscaped();
            expected.replace(0, 1, expected.left(1).toUpper());
            words += QStringLiteral(" <i>%1.</i>").arg(expected);
        }
        auto* help = new QLabel(words, this);
        help->setObjectName(textOf(info.key) + ".help");
        help->setTextFormat(Qt::RichText);
        help->setWordWrap(true);
        help->setForegroundRole(QPalette::PlaceholderText);
        auto* column = new QVBoxLayout;
        column->setSpacing(3);
        column->addLayout(row);
        column->addWidget(help);
        column->addSpacing(6);
        form->addRow(label, column);
    }
    setValues(Settings());
}

QWidget* SettingForm::makeField(const SettingInfo& info) {
    switch (info.kind) {
    case SettingKind::boolean:
        return makeCheck(info);
    case SettingKind::choice:
        return info.names.empty() ? makeChoice(info, false) : makeNamed(info);
    case SettingKind::choiceOrReal:
    case SettingKind::realList:
        return makeChoice(info, true);
    case SettingKind::path:
    case SettingKind::pathList:
        return makeText(info, true);
    case SettingKind::integer:
        return info.names.empty() ? makeText(info, false) : makeNamed(info);
    case SettingKind::real:
    case SettingKind::band:
        break;
    }
    return makeText(info, false);
}

QWidget* SettingForm::makeText(const SettingInfo& info, bool isFile) {
    auto* edit = new QLineEdit(this);
    edit->setObjectName(textOf(info.key));
    edit->setMinimumWidth(90);
    fields_[info.key] = {[edit] { return edit->text(); },
                         [edit](const QString& text) { edit->setText(text); }, edit};
    connect(edit, &QLineEdit::textEdited, this, [this, key = info.key] { onEdited(key); });
    connect(edit, &QLineEdit::editingFinished, this, [this, key = info.key] { finish(key); });
    if (!isFile)
        return edit;

    auto* holder = new QWidget(this);
    auto* row = new QHBoxLayout(holder);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    auto* browse = new QToolButton(holder);
    browse->setIcon(icon("open"));
    browse->setObjectName(textOf(info.key) + ".browse");
    browse->setToolTip(tr("Choose a file"));
    row->addWidget(edit, 1);
    row->addWidget(browse);
    const bool list = info.kind == SettingKind::pathList;
    connect(browse, &QToolButton::clicked, this, [this, edit, list, key = info.key] {
        const QString file = chooseFile_(tr("Choose a file"), tr("All files (*)"));
        if (file.isEmpty())
            return;
        const bool append = list && !edit->text().isEmpty() && edit->text() != "none";
        edit->setText(append ? edit->text() + ";" + file : file);
        onEdited(key);
    });
    return holder;
}

QWidget* SettingForm::makeChoice(const SettingInfo& info, bool editable) {
    auto* box = new QComboBox(this);
    box->setObjectName(textOf(info.key));
    box->setEditable(editable);
    for (const auto& choice : info.choices)
        box->addItem(textOf(choice));
    fields_[info.key] = {[box] { return box->currentText(); },
                         [box](const QString& text) {
                             box->isEditable() ? box->setEditText(text) : box->setCurrentText(text);
                         },
                         box};
    connect(box, &QComboBox::textActivated, this, [this, key = info.key] { onEdited(key); });
    if (editable)
        connect(box->lineEdit(), &QLineEdit::textEdited, this,
                [this, key = info.key] { onEdited(key); });
    return box;
}

QWidget* SettingForm::makeNamed(const SettingInfo& info) {
    auto* box = new QComboBox(this);
    box->setObjectName(textOf(info.key));
    for (std::size_t i = 0; i < info.names.size(); ++i)
        box->addItem(textOf(info.names[i]),
                     info.kind == SettingKind::choice
                         ? textOf(info.choices[i])
                         : QString::number(static_cast<int>(info.minimum) + static_cast<int>(i)));
    fields_[info.key] = {[box] { return box->currentData().toString(); },
                         [box](const QString& text) { box->setCurrentIndex(box->findData(text)); },
                         box};
    connect(box, &QComboBox::activated, this, [this, key = info.key] { onEdited(key); });
    return box;
}

QWidget* SettingForm::makeCheck(const SettingInfo& info) {
    auto* check = new QCheckBox(this);
    check->setObjectName(textOf(info.key));
    fields_[info.key] = {[check] { return check->isChecked() ? "true" : "false"; },
                         [check](const QString& text) { check->setChecked(text == "true"); },
                         check};
    connect(check, &QCheckBox::clicked, this, [this, key = info.key] { onEdited(key); });
    return check;
}

bool SettingForm::mark(const std::string& key) {
    Field& field = fields_.at(key);
    const bool before = field.valid;
    field.valid = typedSetting(settingInfo(key), field.read()).has_value();
    // Only what is marked has colours of its own: all else follows the theme.
    QPalette colours;
    if (!field.valid) {
        const QColor wrong = colors::wrongField(palette());
        colours.setColor(QPalette::Base, wrong);
        colours.setColor(QPalette::Button, wrong);
    }
    field.widget->setPalette(colours);
    return before != field.valid;
}

void SettingForm::onEdited(const std::string& key) {
    if (mark(key))
        emit validityChanged();
    if (fields_.at(key).valid)
        emit edited(key);
}

void SettingForm::finish(const std::string& key) {
    Field& field = fields_.at(key);
    if (field.valid) {
        // Shows what was understood: 2000 for "2 km".
        const std::string understood = value(key);
        field.before = understood;
        if (!canonicalText(settingInfo(key), field.read().trimmed().toStdString()))
            field.write(textOf(understood));
        return;
    }
    if (!isLive_)
        return;
    sayRefused(*field.widget, problemOf(settingInfo(key), field.read()), textOf(field.before));
    setValue(key, field.before);
    emit edited(key);
}

void SettingForm::setValues(const Settings& settings) {
    for (const auto& [key, field] : fields_)
        setValue(key, settings.text(key));
}

void SettingForm::setValue(const std::string& key, const std::string& text) {
    fields_.at(key).before = text;
    fields_.at(key).write(textOf(text));
    if (mark(key))
        emit validityChanged();
}

std::string SettingForm::value(const std::string& key) const {
    return typedSetting(settingInfo(key), fields_.at(key).read()).value_or("");
}

bool SettingForm::isValid() const {
    return std::all_of(fields_.begin(), fields_.end(),
                       [](const auto& f) { return f.second.valid; });
}

QStringList SettingForm::problems() const {
    QStringList list;
    for (const auto& [key, field] : fields_) {
        const SettingInfo& info = settingInfo(key);
        if (!field.valid)
            list << textOf(info.label) + ": " + problemOf(info, field.read());
    }
    return list;
}

void SettingForm::writeTo(Settings& settings) const {
    for (const auto& [key, field] : fields_) {
        const std::string text = value(key);
        if (field.valid && settings.text(key) != text)
            settings.set(key, text);
    }
}

void SettingForm::setExpertVisible(bool visible, const std::vector<std::string>& always) {
    for (std::size_t row = 0; row < keys_.size(); ++row) {
        const SettingInfo& info = settingInfo(keys_[row]);
        const bool isShown = visible || info.audience == SettingAudience::basic ||
                             std::find(always.begin(), always.end(), info.key) != always.end() ||
                             value(info.key) != info.defaultText;
        layout_->setRowVisible(static_cast<int>(row), isShown);
    }
}

void SettingForm::setUnused(const std::vector<std::string>& keys) {
    for (auto& [key, field] : fields_) {
        const SettingInfo& info = settingInfo(key);
        if (!whyUnavailable(info).empty() || !field.valid)
            continue;
        const bool isUsed = std::find(keys.begin(), keys.end(), key) == keys.end();
        QPalette colours;
        if (!isUsed)
            colours.setColor(QPalette::Text, palette().color(QPalette::PlaceholderText));
        field.widget->setPalette(colours);
        field.widget->setToolTip(isUsed ? helpText(info) : tr("Not used by this analysis"));
    }
}

int SettingForm::showMatching(const QStringList& words) {
    int shown = 0;
    for (std::size_t row = 0; row < keys_.size(); ++row) {
        const SettingInfo& info = settingInfo(keys_[row]);
        const QString text =
            textOf(info.label + " " + info.key + " " + info.option + " " + info.help);
        const bool matches = std::all_of(words.begin(), words.end(), [&](const QString& word) {
            return text.contains(word, Qt::CaseInsensitive);
        });
        layout_->setRowVisible(static_cast<int>(row), matches);
        shown += matches ? 1 : 0;
    }
    return shown;
}

std::vector<std::string> settingKeys(const std::string& section, bool withExpert) {
    std::vector<std::string> keys;
    for (const auto& info : settingTable())
        if (info.section() == section && (withExpert || info.audience == SettingAudience::basic))
            keys.push_back(info.key);
    return keys;
}

} // namespace smat::gui

#include "moc_SettingForm.cpp"
