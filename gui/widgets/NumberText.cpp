#include "gui/widgets/NumberText.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include "irsg/core/CsvTable.h"

namespace smat::gui {
namespace {

QString trRows(const char* text) {
    return QCoreApplication::translate("smat::gui::PastedRows", text);
}

/// The cells of a line, apart by the first of these that it holds.
QStringList cellsOf(const QString& line) {
    for (const QChar separator : {QChar('\t'), QChar(';')})
        if (line.contains(separator))
            return line.split(separator);
    static const QRegularExpression blanks("\\s+");
    // "4,2 0,5" has commas in its numbers, "4.2,0.5" and "4.2, 0.5" between them.
    const QString trimmed = line.trimmed();
    const QStringList words = trimmed.split(blanks, Qt::SkipEmptyParts);
    const bool commasEndWords = std::any_of(words.begin(), words.end(), [](const QString& word) {
        return word.endsWith(',') || word.startsWith(',');
    });
    if (words.size() > 1 && !commasEndWords)
        return words;
    return trimmed.contains(',') ? trimmed.split(',') : words;
}

} // namespace

std::optional<double> numberOf(const QString& text) {
    QString plain = text.trimmed();
    plain.replace(QChar(0x2212), '-');
    if (plain.count(',') == 1 && !plain.contains('.'))
        plain.replace(',', '.');
    bool right = false;
    const double value = plain.toDouble(&right);
    return right && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

QString textOf(double value) {
    return QString::fromStdString(irsg::numberText(value));
}

PastedRows rowsOf(const QString& text) {
    PastedRows pasted;
    static const QRegularExpression lineEnds("\r\n|\r|\n");
    int row = 0;
    bool first = true;
    for (const QString& line : text.split(lineEnds)) {
        ++row;
        if (line.trimmed().isEmpty() || line.startsWith('#'))
            continue;
        QStringList cells = cellsOf(line);
        while (cells.size() > 1 && cells.back().trimmed().isEmpty())
            cells.removeLast();
        const bool isFirst = std::exchange(first, false);
        if (isFirst && std::none_of(cells.begin(), cells.end(), numberOf))
            continue;
        std::vector<double> numbers;
        for (int column = 0; column < cells.size(); ++column) {
            const auto number = numberOf(cells[column]);
            if (!number) {
                pasted.problem = trRows("row %1, column %2: '%3' is not a number")
                                     .arg(row)
                                     .arg(column + 1)
                                     .arg(cells[column].trimmed());
                return pasted;
            }
            numbers.push_back(*number);
        }
        if (!pasted.rows.empty() && numbers.size() != pasted.rows.front().size()) {
            pasted.problem = trRows("row %1: %2 columns, but %3 in the rows before")
                                 .arg(row)
                                 .arg(numbers.size())
                                 .arg(pasted.rows.front().size());
            return pasted;
        }
        pasted.rows.push_back(std::move(numbers));
    }
    if (pasted.rows.empty())
        pasted.problem = trRows("the clipboard holds no numbers");
    return pasted;
}

} // namespace smat::gui
