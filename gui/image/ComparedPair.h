#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QObject>

#include "gui/widgets/LatestTask.h"
#include "irsg/image/ImageComparison.h"
#include "irsg/image/RadianceImage.h"

namespace smat::gui {

/// One of two images that are compared.
struct ComparisonSide {
    std::shared_ptr<const irsg::RadianceImage> image; ///< null: none yet
    QString name;                                     ///< of its file, or of its result
    QString file; ///< that holds the image; empty for a result that is not saved

    /// Of a file.
    static ComparisonSide of(irsg::RadianceImage image, const QString& file) {
        return {std::make_shared<const irsg::RadianceImage>(std::move(image)), file, file};
    }
};

/// Two images, the plane of them that is compared, their difference and the numbers of it; those of
/// large images are worked out off this thread. Knows no widget.
class ComparedPair : public QObject {
    Q_OBJECT

  public:
    using Image = std::shared_ptr<const irsg::RadianceImage>;
    using Rectangle = std::optional<irsg::PixelRectangle>;
    explicit ComparedPair(QObject* parent = nullptr);

    /// What was known of others is forgotten, without a word.
    void setSides(ComparisonSide a, ComparisonSide b);
    const ComparisonSide& side(std::size_t index) const { return sides_[index]; }
    bool hasBoth() const { return sides_[0].image && sides_[1].image; }
    bool hasAny() const { return sides_[0].image || sides_[1].image; }
    /// Planes to choose among, by titles and names: the usual ones of both under the name "", then
    /// every other name that both have.
    std::vector<std::pair<QString, std::string>> planeChoices() const;
    /// That of an image which is compared, or one to look at where it has none of this name; null
    /// without an image.
    const irsg::ImageChannel* plane(std::size_t index) const;

    /// In effect with the next work below.
    void setChannel(const std::string& name) { options_.channel = name; }
    void setThresholds(const irsg::ComparisonLevel& fail, const irsg::ComparisonLevel& warn);
    void setMode(irsg::DifferenceMode mode) { mode_ = mode; }
    irsg::DifferenceMode mode() const { return mode_; }
    const irsg::ComparisonOptions& options() const { return options_; }

    void findDifference();
    /// All numbers anew.
    void compare(const Rectangle& rectangle);
    /// After another rectangle: what is known of the whole stays.
    void compareRectangle(const Rectangle& rectangle);
    bool isComparing() const { return compareTask_.isBusy(); }
    bool isBusy() const;

    /// Null where there is none.
    const Image& difference() const { return difference_; }
    /// None where the images cannot be compared, and while the numbers are worked out.
    const std::optional<irsg::Comparison>& whole() const { return whole_; }
    const std::optional<irsg::Comparison>& part() const { return part_; }
    /// A mark of ColoredPlane for each pixel over the thresholds.
    const std::vector<std::uint8_t>& marks() const { return marks_; }
    /// Why the images cannot be compared; empty where they can.
    const QString& refusal() const { return refusal_; }
    /// "x 3   y 4     A 1.2     B 1     A − B 0.2 W·m⁻²·sr⁻¹".
    QString readoutAt(int x, int y) const;
    /// A, B, their difference and all numbers. LogicError where there are none.
    irsg::RadianceImage exported() const;

  signals:
    /// There is another one, or none any more.
    void differenceFound();
    void marksFound();
    /// Numbers, why there are none, or that they are being worked out.
    void compared();

  private:
    struct Answer {
        irsg::Comparison whole;
        std::optional<irsg::Comparison> part;
        std::vector<std::uint8_t> marks;
    };
    static Answer work(const irsg::RadianceImage& a, const irsg::RadianceImage& b,
                       const irsg::ComparisonOptions& options, const Rectangle& part);
    void take(Answer answer);
    void takePart(std::optional<irsg::Comparison> part);

    std::array<ComparisonSide, 2> sides_;
    irsg::ComparisonOptions options_;
    irsg::DifferenceMode mode_ = irsg::DifferenceMode::signedDifference;
    Image difference_;
    std::optional<irsg::Comparison> whole_, part_;
    std::vector<std::uint8_t> marks_;
    QString refusal_;
    LatestTask compareTask_, partTask_, differenceTask_;
};

/// "A − B", "|A − B|", "(A − B) / mean", "A / B".
QString differenceName(irsg::DifferenceMode mode);

} // namespace smat::gui
