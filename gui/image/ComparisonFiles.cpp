#include "gui/image/ComparisonFiles.h"

#include <array>

#include <QPointer>
#include <QWidget>

#include "gui/image/ChosenImage.h"
#include "gui/image/ImageExport.h"
#include "gui/widgets/Sentences.h"
#include "irsg/core/Errors.h"
#include "irsg/image/ImageFile.h"

namespace smat::gui {
namespace {

/// The first thing that is wrong with a file, and how much more there is.
QString sentenceOf(const irsg::InputError& error) {
    const QStringList all = sentencesOf(error);
    return all.size() == 1
               ? all.front()
               : ComparisonFiles::tr("%1 (and %2 more)").arg(all.front()).arg(all.size() - 1);
}

} // namespace

ComparisonFiles::ComparisonFiles(const ComparedPair& pair, Dialogs dialogs, QWidget* window)
    : QObject(window), pair_(pair), dialogs_(std::move(dialogs)), window_(window) {}

ComparisonFiles::Reading ComparisonFiles::readingOf(const QStringList& files,
                                                    const std::vector<irsg::ImageReading>& what) {
    Reading reading;
    for (qsizetype i = 0; i < files.size(); ++i) {
        const QString& file = files[i];
        try {
            reading.sides.push_back(ComparisonSide::of(
                irsg::readImageFile(file.toStdString(), what[static_cast<std::size_t>(i)]), file));
        } catch (const irsg::InputError& error) {
            reading.sides.emplace_back();
            reading.wrong << sentenceOf(error);
        }
    }
    return reading;
}

void ComparisonFiles::open(const QStringList& files, std::optional<int> side) {
    if (files.isEmpty() || files.size() > 2) {
        dialogs_.tell(window_, tr("These files cannot be compared"),
                      {tr("Two images are compared, or one takes the place of A or B; these are %1 "
                          "files.")
                           .arg(files.size())});
        return;
    }
    const bool lacksB = pair_.side(0).image && !pair_.side(1).image;
    const int first = files.size() == 2 ? 0 : side.value_or(lacksB);
    std::vector<irsg::ImageReading> what;
    for (const QString& file : files)
        what.push_back(chosenImage(dialogs_, window_, file));
    emit begun(files);
    task_.run<Reading>([files, what] { return readingOf(files, what); },
                       [this, first](Reading reading) { take(std::move(reading), first); });
}

void ComparisonFiles::take(Reading reading, int first) {
    if (reading.wrong.isEmpty() || !pair_.hasAny()) {
        std::array<ComparisonSide, 2> sides{pair_.side(0), pair_.side(1)};
        for (std::size_t i = 0; i < reading.sides.size(); ++i)
            if (reading.sides[i].image)
                sides[static_cast<std::size_t>(first) + i] = std::move(reading.sides[i]);
        emit read(sides[0], sides[1]);
    }
    emit ended();
    if (reading.wrong.isEmpty())
        return;
    const QPointer<ComparisonFiles> stillThere(this); // a message box lets other things happen
    dialogs_.tell(window_,
                  reading.wrong.size() > 1 ? tr("These images cannot be read")
                                           : tr("This image cannot be read"),
                  reading.wrong);
    if (stillThere && !pair_.hasAny())
        emit nothingRead();
}

void ComparisonFiles::ask(int side) {
    const QString file =
        dialogs_.openFile(window_, side == 0 ? tr("Open image A") : tr("Open image B"),
                          {tr("Images (%1)").arg(readableImagePatterns()), tr("All files (*)")});
    if (!file.isEmpty())
        open({file}, side);
}

} // namespace smat::gui

#include "moc_ComparisonFiles.cpp"
