#include "tests/guide/GuideWalk.h"

#include <QFile>
#include <QRegularExpression>

namespace smat::gui::test {
namespace {

QString withoutMarks(QString text) {
    text.replace(QRegularExpression(R"(\[([^\]]*)\]\([^)]*\))"), "\\1");
    text.remove(QRegularExpression("[*`]"));
    return text.simplified();
}

bool isRow(const QString& line) {
    return line.startsWith('|');
}
bool isListEntry(const QString& line) {
    static const QRegularExpression mark(R"(^(\d+\.|-) )");
    return mark.match(line).hasMatch();
}

} // namespace

std::vector<GuideUnit> unitsOf(const QString& page) {
    QFile file(page);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << page.toStdString();
    const QStringList lines = QString::fromUtf8(file.readAll()).split('\n');
    std::vector<GuideUnit> units;
    QString section, open;
    bool isCode = false;
    const auto close = [&] {
        const QString words = withoutMarks(open);
        if (!words.isEmpty() && !words.startsWith('!')) {
            units.push_back({section, words});
        }
        open.clear();
    };
    for (qsizetype i = 0; i < lines.size(); ++i) {
        const QString& line = lines[i];
        const bool isFence = line.startsWith("```");
        isCode ^= isFence;
        if (isFence || line.trimmed().isEmpty() || line.startsWith('#')) {
            close();
            if (line.startsWith("## ") && !isCode) {
                section = line.mid(3).simplified();
            }
        } else if (isCode || line.startsWith("    ")) {
            close();
            open = line;
            close();
        } else if (isRow(line)) {
            close();
            const bool isHead = i + 1 < lines.size() && lines[i + 1].startsWith("|-");
            if (!isHead && !line.startsWith("|-")) {
                open = line;
                close();
            }
        } else {
            if (isListEntry(line)) {
                close();
            }
            open += " " + line;
        }
    }
    close();
    return units;
}

QStringList sectionsOf(const QString& page) {
    QStringList sections;
    for (const GuideUnit& unit : unitsOf(page)) {
        if (!sections.contains(unit.section)) {
            sections << unit.section;
        }
    }
    return sections;
}

GuideWalk::GuideWalk(const QString& chapter, const QString& section)
    : name_(section.isEmpty() ? chapter : chapter + ", " + section),
      units_(unitsOf(QString(SMAT_SOURCE_DIR) + "/docs/user-guide/" + chapter + ".md")) {
    if (!section.isNull()) {
        std::erase_if(units_, [&](const GuideUnit& unit) { return unit.section != section; });
    }
    EXPECT_FALSE(units_.empty()) << name_.toStdString();
    walked_.resize(units_.size());
}

GuideWalk::~GuideWalk() {
    trace_.reset();
    if (testing::Test::HasFatalFailure() || testing::Test::IsSkipped()) {
        return;
    }
    for (std::size_t i = 0; i < units_.size(); ++i) {
        EXPECT_TRUE(walked_[i]) << name_.toStdString() << " says what no step here does: "
                                << units_[i].words.toStdString();
    }
}

void GuideWalk::step(const char* words) {
    trace_.reset();
    const QString wanted = withoutMarks(QString::fromUtf8(words));
    while (at_ < units_.size() && !units_[at_].words.contains(wanted)) {
        ++at_;
    }
    if (at_ == units_.size()) {
        at_ = 0; // so that the steps after it are looked for all the same
        ADD_FAILURE() << name_.toStdString() << " does not say here: " << words;
        return;
    }
    walked_[at_] = true;
    trace_ =
        std::make_unique<testing::ScopedTrace>(__FILE__, __LINE__, "step: " + std::string(words));
}

} // namespace smat::gui::test
