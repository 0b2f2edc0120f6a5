#include "gui/widgets/Sentences.h"

#include <algorithm>

#include <QCoreApplication>

#include "irsg/core/Errors.h"
#include "smatcore/settings/SettingInfo.h"

namespace smat::gui {
namespace {

QString trSentence(const char* text) {
    return QCoreApplication::translate("smat::gui::Sentences", text);
}

/// "Sensor, Width" of a key of a setting; other places are as they are.
QString placeOf(const std::string& position) {
    const SettingInfo* setting = findSetting(position);
    if (setting == nullptr)
        return QString::fromStdString(position);
    return QString::fromStdString(sectionTitle(setting->section()) + ", " + setting->label);
}

/// What is expected, and what follows it behind a colon or a semicolon: why.
std::pair<QString, QString> neededAndWhy(const QString& expected) {
    qsizetype end = expected.size();
    for (const QString& mark : {QStringLiteral(": "), QStringLiteral("; ")})
        if (const qsizetype at = expected.indexOf(mark); at > 0)
            end = std::min(end, at);
    return {expected.left(end), expected.mid(end)};
}

/// What a system refuses is said as people say it; empty for all else.
QString refusalOf(const QString& value) {
    struct Refusal {
        const char *found, *sentence;
    };
    static constexpr Refusal refusals[] = {
        {"no such file", QT_TRANSLATE_NOOP("smat::gui::Sentences", "file not found")},
        {"a full disk", QT_TRANSLATE_NOOP("smat::gui::Sentences",
                                          "the disk is full; nothing was saved, and the old "
                                          "file is unchanged")},
        {"a file larger than is allowed here",
         QT_TRANSLATE_NOOP("smat::gui::Sentences", "the file would be larger than this system "
                                                   "allows; the old file is unchanged")},
        {"a place that cannot be written",
         QT_TRANSLATE_NOOP("smat::gui::Sentences", "no permission to write here")},
        {"a folder that does not exist",
         QT_TRANSLATE_NOOP("smat::gui::Sentences", "the folder does not exist")}};
    for (const Refusal& refusal : refusals)
        if (value == QLatin1String(refusal.found))
            return trSentence(refusal.sentence);
    return {};
}

QString findingOf(const irsg::Diagnostic& diagnostic) {
    const QString value = QString::fromStdString(diagnostic.value);
    if (const QString refusal = refusalOf(value); !refusal.isEmpty())
        return refusal;
    const auto [needed, why] = neededAndWhy(QString::fromStdString(diagnostic.expected));
    if (needed.isEmpty())
        return value;
    if (value.isEmpty())
        return trSentence("%1 is needed%2").arg(needed, why);
    if (value == "nothing")
        return trSentence("%1 is missing%2").arg(needed, why);
    return neededInstead(needed, value) + why;
}

} // namespace

QString neededInstead(const QString& needed, const QString& given) {
    return trSentence("%1 is needed instead of %2").arg(needed, given);
}

QString sentenceOf(const irsg::Diagnostic& diagnostic) {
    QStringList parts;
    for (const QString& part :
         {QString::fromStdString(diagnostic.file), placeOf(diagnostic.position)})
        if (!part.isEmpty())
            parts << part;
    const QString where = parts.join(", "), finding = findingOf(diagnostic);
    if (where.isEmpty() || finding.isEmpty())
        return where + finding;
    return where + ": " + finding;
}

QStringList sentencesOf(const irsg::InputError& error) {
    QStringList sentences;
    for (const irsg::Diagnostic& diagnostic : error.diagnostics())
        sentences << sentenceOf(diagnostic);
    return sentences;
}

QStringList sentencesOf(const std::exception_ptr& thrown) {
    try {
        std::rethrow_exception(thrown);
    } catch (const irsg::InputError& error) {
        return sentencesOf(error);
    } catch (const std::exception& error) {
        return {QString::fromLocal8Bit(error.what())};
    }
}

} // namespace smat::gui
