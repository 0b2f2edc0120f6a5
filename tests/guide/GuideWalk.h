#pragma once

#include <memory>
#include <string>
#include <vector>

#include <QString>
#include <QStringList>
#include <gtest/gtest.h>

namespace smat::gui::test {

/// A page of the documentation in its units: each paragraph, row of a table, entry of a list and
/// line of a command is one, without marks of Markdown. Titles, heads of tables and pictures are
/// none.
struct GuideUnit {
    QString section; ///< the title of the second level above it; none before the first
    QString words;
};
std::vector<GuideUnit> unitsOf(const QString& page);
/// The sections of a page that have units, "" where some stand before the first title.
QStringList sectionsOf(const QString& page);

/// A chapter of the user guide, or a section of one, while a test does what it says. Each unit of
/// it must be named, in the order of the text, by words that it has: whoever writes a step, or
/// another number into one, has to do it here. `UserGuideTest` finds chapters and sections that no
/// test walks by the constructor's words in the sources of the tests, which are
/// `GuideWalk walk("chapter", "Section")`.
class GuideWalk {
  public:
    /// Without a section the whole chapter.
    explicit GuideWalk(const QString& chapter, const QString& section = {});
    ~GuideWalk();
    GuideWalk(const GuideWalk&) = delete;
    GuideWalk& operator=(const GuideWalk&) = delete;

    /// What comes next is what these words say; a failure from here on names them.
    void step(const char* words);
    /// The same where words say nothing to be done or seen: what a thing is, or where more stands.
    void note(const char* words) { step(words); }

  private:
    QString name_;
    std::vector<GuideUnit> units_;
    std::vector<bool> walked_;
    std::size_t at_ = 0;
    std::unique_ptr<testing::ScopedTrace> trace_;
};

} // namespace smat::gui::test
