#include "gui/image/ComparedPair.h"

#include <algorithm>

#include <QStringList>

#include "gui/image/ColoredPlane.h"
#include "gui/image/ImageExport.h"
#include "gui/image/ShownImage.h"
#include "gui/widgets/Sentences.h"
#include "irsg/core/Errors.h"
#include "irsg/core/ProgramVersion.h"
#include "irsg/image/ComparisonFigures.h"
#include "irsg/image/ImageFile.h"
#include "smatcore/data/Provenance.h"

namespace smat::gui {

QString differenceName(irsg::DifferenceMode mode) {
    switch (mode) {
    case irsg::DifferenceMode::signedDifference:
        return QStringLiteral("A − B");
    case irsg::DifferenceMode::absolute:
        return QStringLiteral("|A − B|");
    case irsg::DifferenceMode::relative:
        return QStringLiteral("(A − B) / ½(|A| + |B|)");
    case irsg::DifferenceMode::ratio:
        return QStringLiteral("A / B");
    }
    return {};
}

ComparedPair::ComparedPair(QObject* parent) : QObject(parent) {}

void ComparedPair::setSides(ComparisonSide a, ComparisonSide b) {
    sides_ = {std::move(a), std::move(b)};
    options_.nameA = sides_[0].name.toStdString();
    options_.nameB = sides_[1].name.toStdString();
    difference_.reset(); // of other images: not shown until the new one is there
}

void ComparedPair::setThresholds(const irsg::ComparisonLevel& fail,
                                 const irsg::ComparisonLevel& warn) {
    options_.fail = fail;
    options_.warn = warn;
}

bool ComparedPair::isBusy() const {
    return compareTask_.isBusy() || partTask_.isBusy() || differenceTask_.isBusy();
}

std::vector<std::pair<QString, std::string>> ComparedPair::planeChoices() const {
    std::vector<std::pair<QString, std::string>> choices;
    if (!hasBoth())
        return choices;
    const irsg::RadianceImage& a = *sides_[0].image;
    const irsg::RadianceImage& b = *sides_[1].image;
    std::string usual;
    try {
        usual = irsg::chosenPlane(a, "", "A").name;
        const std::string other = irsg::chosenPlane(b, "", "B").name;
        choices.emplace_back(planeTitle(*a.find(usual)) +
                                 (usual == other ? QString() : " | " + planeTitle(*b.find(other))),
                             std::string());
        usual = usual == other ? usual : std::string();
    } catch (const irsg::InputError&) {
        usual.clear(); // there is no usual one: a name has to be chosen
    }
    for (const auto& channel : a.channels)
        if (b.find(channel.name) != nullptr && channel.name != usual)
            choices.emplace_back(planeTitle(channel), channel.name);
    // A plane of one image with the usual plane of the other, which has none of its name.
    const auto addAlone = [&](const irsg::RadianceImage& has, const irsg::RadianceImage& lacks,
                              bool isFirst) {
        try {
            const irsg::ImageChannel& other = irsg::chosenPlane(lacks, "", "");
            for (const auto& channel : has.channels) {
                if (lacks.find(channel.name) != nullptr)
                    continue;
                const QString own = planeTitle(channel), of = planeTitle(other);
                choices.emplace_back(isFirst ? own + " | " + of : of + " | " + own, channel.name);
            }
        } catch (const irsg::InputError&) {
            // It has no usual one.
        }
    };
    if (choices.empty()) {
        addAlone(a, b, true);
        addAlone(b, a, false);
    }
    return choices;
}

const irsg::ImageChannel* ComparedPair::plane(std::size_t index) const {
    const auto& image = sides_[index].image;
    if (!image)
        return nullptr;
    try {
        // A name that only the other image has leaves the usual plane of this one.
        const bool has = image->find(options_.channel) != nullptr;
        return &irsg::chosenPlane(*image, has ? options_.channel : "",
                                  sides_[index].name.toStdString());
    } catch (const irsg::InputError&) {
        return &image->primary(); // to look at; the comparison says what is wrong
    }
}

void ComparedPair::findDifference() {
    const irsg::ImageChannel* a = plane(0);
    const irsg::ImageChannel* b = plane(1);
    differenceTask_.cancel();
    const bool sameSize = a != nullptr && b != nullptr &&
                          sides_[0].image->width() == sides_[1].image->width() &&
                          sides_[0].image->height() == sides_[1].image->height();
    const bool keeps = sameSize && difference_ != nullptr &&
                       difference_->width() == sides_[0].image->width() &&
                       difference_->height() == sides_[0].image->height();
    if (!keeps) {
        difference_.reset();
        emit differenceFound();
    }
    if (!sameSize)
        return;
    const auto work = [imageA = sides_[0].image, imageB = sides_[1].image, a, b, mode = mode_] {
        irsg::ImageChannel plane = irsg::differencePlane(*a, *b, mode);
        auto image = std::make_shared<irsg::RadianceImage>(imageA->width(), imageA->height(),
                                                           plane.name, plane.unit);
        image->primary().values = std::move(plane.values);
        return Image(std::move(image));
    };
    const auto use = [this](const Image& image) {
        difference_ = image;
        emit differenceFound();
    };
    if (sides_[0].image->pixelCount() <= quickPixels)
        use(work());
    else
        differenceTask_.run<Image>(work, use);
}

ComparedPair::Answer ComparedPair::work(const irsg::RadianceImage& a, const irsg::RadianceImage& b,
                                        const irsg::ComparisonOptions& options,
                                        const Rectangle& part) {
    Answer answer;
    answer.whole = irsg::compareImages(a, b, options);
    if (part) {
        irsg::ComparisonOptions ofPart = options;
        ofPart.rectangle = part;
        answer.part = irsg::compareImages(a, b, ofPart);
    }
    const irsg::ComparedPlanes planes = irsg::comparedPlanes(a, b, options);
    const auto& planeA = planes.a.values;
    const auto& planeB = planes.b.values;
    answer.marks.resize(planeA.size());
    std::ranges::transform(planeA, planeB, answer.marks.begin(), [&options](float x, float y) {
        const auto verdict =
            irsg::pixelVerdict(static_cast<double>(x), static_cast<double>(y), options);
        return static_cast<std::uint8_t>(
            verdict >= irsg::PixelVerdict::overFail   ? ColoredPlane::failed
            : verdict == irsg::PixelVerdict::overWarn ? ColoredPlane::warned
                                                      : ColoredPlane::unmarked);
    });
    return answer;
}

void ComparedPair::compare(const Rectangle& rectangle) {
    compareTask_.cancel();
    partTask_.cancel();
    whole_.reset();
    part_.reset();
    marks_.clear();
    refusal_.clear();
    if (!hasBoth()) {
        emit compared();
        return;
    }
    const Image a = sides_[0].image, b = sides_[1].image;
    const auto refuse = [this](const std::exception_ptr& thrown) {
        refusal_ = sentencesOf(thrown).join('\n');
        emit compared();
    };
    if (a->pixelCount() <= quickPixels) {
        try {
            take(work(*a, *b, options_, rectangle));
        } catch (const irsg::InputError&) {
            refuse(std::current_exception());
        }
        return;
    }
    compareTask_.run<Answer>(
        [a, b, options = options_, rectangle] { return work(*a, *b, options, rectangle); },
        [this](Answer answer) { take(std::move(answer)); }, refuse);
    emit compared();
}

void ComparedPair::compareRectangle(const Rectangle& rectangle) {
    if (!whole_) {
        compare(rectangle);
        return;
    }
    partTask_.cancel();
    if (!rectangle) {
        takePart(std::nullopt);
        return;
    }
    irsg::ComparisonOptions options = options_;
    options.rectangle = rectangle;
    const auto work = [a = sides_[0].image, b = sides_[1].image, options] {
        return irsg::compareImages(*a, *b, options);
    };
    const auto pixels =
        static_cast<std::size_t>(rectangle->width) * static_cast<std::size_t>(rectangle->height);
    if (pixels <= quickPixels)
        takePart(work());
    else
        partTask_.run<irsg::Comparison>(work,
                                        [this](const irsg::Comparison& part) { takePart(part); });
}

void ComparedPair::take(Answer answer) {
    marks_ = std::move(answer.marks);
    whole_ = std::move(answer.whole);
    takePart(std::move(answer.part));
    emit marksFound();
}

void ComparedPair::takePart(std::optional<irsg::Comparison> part) {
    part_ = std::move(part);
    emit compared();
}

QString ComparedPair::readoutAt(int x, int y) const {
    QString text = QStringLiteral("x %1   y %2").arg(x).arg(y);
    std::array<double, 2> values{};
    for (std::size_t i = 0; i < 2; ++i) {
        const irsg::ImageChannel* of = plane(i);
        if (of == nullptr || x >= sides_[i].image->width() || y >= sides_[i].image->height())
            continue;
        values[i] = static_cast<double>(of->values[sides_[i].image->offset(x, y)]);
        const QString value = unitOfPlane(*of) != nullptr
                                  ? valueWithUnit(values[i], of->unit)
                                  : storedValueWithUnit(values[i], of->unit);
        text += QStringLiteral("          %1  %2").arg(i == 0 ? "A" : "B", value);
    }
    if (difference_ && !differenceTask_.isBusy())
        text += QStringLiteral("          %1  %2")
                    .arg(differenceName(mode_),
                         storedValueWithUnit(irsg::difference(values[0], values[1], mode_),
                                             difference_->primary().unit));
    return text.trimmed();
}

irsg::RadianceImage ComparedPair::exported() const {
    if (!whole_)
        throw irsg::LogicError("two images that were not compared");
    auto image =
        irsg::differenceImage(*sides_[0].image, *sides_[1].image, *whole_, options_, mode_);
    image.attributes["program"] = irsg::programWithVersion();
    return image;
}

} // namespace smat::gui

#include "moc_ComparedPair.cpp"
