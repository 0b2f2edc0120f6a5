#include "gui/paint/IndexBox.h"

#include <QLineEdit>
#include <QSignalBlocker>

namespace smat::gui {
namespace {

constexpr int newEntryMark = 1;

} // namespace

IndexBox::IndexBox(QWidget* parent) : QComboBox(parent) {
    setEditable(true);
    setInsertPolicy(QComboBox::NoInsert);
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(14);
    lineEdit()->setPlaceholderText(tr("leave as it is"));
    setEntries({}, false);
    connect(this, &QComboBox::editTextChanged, this, [this] {
        if (isRight())
            last_ = index();
        emit edited();
    });
    connect(this, &QComboBox::activated, this, [this](int item) {
        if (itemData(item).toInt() != newEntryMark)
            return;
        setIndex(last_);
        emit newEntryWanted();
    });
}

QString IndexBox::textOf(int index) const {
    const auto named = names_.find(index);
    return named == names_.end() || named->second.empty()
               ? QString::number(index)
               : QStringLiteral("%1  %2").arg(index).arg(QString::fromStdString(named->second));
}

void IndexBox::setEntries(const std::map<int, std::string>& names, bool mayAdd) {
    const auto kept = index();
    const bool wasRight = isRight();
    const QString text = currentText();
    const QSignalBlocker quiet(this);
    names_ = names;
    clear();
    addItem(QString());
    for (const auto& [index, name] : names_)
        addItem(textOf(index));
    if (mayAdd) {
        insertSeparator(count());
        addItem(tr("New entry…"), newEntryMark);
    }
    if (wasRight)
        setIndex(kept);
    else
        setEditText(text);
}

std::optional<int> IndexBox::index() const {
    const QString number = currentText().trimmed().section(' ', 0, 0);
    bool whole = false;
    const int index = number.toInt(&whole);
    return whole ? std::optional(index) : std::nullopt;
}

void IndexBox::setIndex(std::optional<int> index) {
    last_ = index;
    setEditText(index ? textOf(*index) : QString());
    emit edited();
}

bool IndexBox::isRight() const {
    return currentText().trimmed().isEmpty() || index().has_value();
}

} // namespace smat::gui

#include "moc_IndexBox.cpp"
