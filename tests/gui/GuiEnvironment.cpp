#include "tests/gui/GuiEnvironment.h"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <vector>

#include <QApplication>
#include <QDir>
#include <QFontMetricsF>
#include <QLockFile>
#include <QPainter>
#include <QSettings>
#include <QTest>
#include <QWindow>
#include <gtest/gtest.h>

#include "gui/view/SceneView.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WheelGuard.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::gui::test {
namespace {

/// One QApplication for all tests of this program, with settings and data kept apart from the
/// user's own.
class QtForTests : public ::testing::Environment {
  public:
    void SetUp() override {
        if (qEnvironmentVariableIsEmpty("DISPLAY") &&
            qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
            qputenv("QT_QPA_PLATFORM", "offscreen");
        }
        // Not the test mode of QStandardPaths: its folders are shared by tests that run side by
        // side.
        for (const char* folder : {"XDG_DATA_HOME", "XDG_CONFIG_HOME"}) {
            qputenv(folder, freshFolder(folder).string().c_str());
        }
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                           QString::fromStdString(freshFolder("settings").string()));
        application_ = std::make_unique<QApplication>(argumentCount_, arguments_);
        QApplication::setOrganizationName("smat-tests");
        applyTheme(*application_, ThemeMode::light);
        application_->installEventFilter(new WheelGuard(application_.get()));
    }
    void TearDown() override { application_.reset(); }

  private:
    int argumentCount_ = 1;
    char name_[9] = "test_gui";
    char* arguments_[2] = {name_, nullptr};
    std::unique_ptr<QApplication> application_;
};

const auto* const environment = ::testing::AddGlobalTestEnvironment(new QtForTests);

} // namespace

void keepScreenshot(QWidget& widget, const std::string& name) {
    const std::filesystem::path folder = std::filesystem::path(SMAT_BINARY_DIR) / "screenshots";
    std::filesystem::create_directories(folder);
    widget.grab().save(QString::fromStdString((folder / (name + ".png")).string()));
}

bool showsColorAt(QWidget& widget, const QPointF& point, const QColor& wanted) {
    const QImage picture = widget.grab().toImage();
    const QPoint middle = (point * picture.devicePixelRatio()).toPoint();
    for (int dy = -3; dy <= 3; ++dy) {
        for (int dx = -3; dx <= 3; ++dx) {
            const QPoint at = middle + QPoint(dx, dy);
            if (!picture.valid(at)) {
                continue;
            }
            const QColor color = picture.pixelColor(at);
            if (std::abs(color.red() - wanted.red()) + std::abs(color.green() - wanted.green()) +
                    std::abs(color.blue() - wanted.blue()) <
                60) {
                return true;
            }
        }
    }
    return false;
}

QColor colorAt(const QImage& picture, const QPointF& point) {
    const QPointF at = point * picture.devicePixelRatio();
    return picture.pixelColor(static_cast<int>(at.x()), static_cast<int>(at.y()));
}

bool holdsWords(const QImage& picture, const QString& words, const QFont& font) {
    // What is dark of the words, in a box that is as large as they are.
    const QSizeF size(QFontMetricsF(font).horizontalAdvance(words), QFontMetricsF(font).height());
    const double ratio = picture.devicePixelRatio();
    QImage wanted((size * ratio).toSize(), QImage::Format_RGB32);
    wanted.setDevicePixelRatio(ratio);
    wanted.fill(Qt::white);
    QPainter painter(&wanted);
    painter.setFont(font);
    painter.drawText(QRectF(QPointF(0, 0), size), Qt::AlignLeft | Qt::AlignTop, words);
    painter.end();
    std::vector<QPoint> ink, blank;
    for (int y = 0; y < wanted.height(); ++y) {
        for (int x = 0; x < wanted.width(); ++x) {
            const int grey = qGray(wanted.pixel(x, y));
            if (grey < 40) {
                ink.emplace_back(x, y);
            } else if (grey > 250) {
                blank.emplace_back(x, y);
            }
        }
    }
    const auto isInk = [&](const QPoint& at) { return qGray(picture.pixel(at)) < 160; };
    const auto isBlank = [&](const QPoint& at) { return qGray(picture.pixel(at)) > 235; };
    const int down = std::min(picture.height() - wanted.height(), 200);
    for (int y = 0; y < down; ++y) {
        for (int x = 0; x < picture.width() - wanted.width(); ++x) {
            const QPoint corner(x, y);
            if (std::ranges::all_of(ink, [&](const QPoint& p) { return isInk(corner + p); }) &&
                std::ranges::all_of(blank, [&](const QPoint& p) { return isBlank(corner + p); })) {
                return !ink.empty();
            }
        }
    }
    return false;
}

bool lacksGl() {
    const QString problem = SceneView::problem();
    if (!problem.isEmpty() && !qEnvironmentVariableIsEmpty("SMAT_GL_REQUIRED")) {
        ADD_FAILURE() << "SMAT_GL_REQUIRED is set, and yet: " << problem.toStdString();
    }
    return !problem.isEmpty();
}

std::filesystem::path freshFolder(const std::string& name) {
    static const smat::test::TemporaryFolder process;
    std::filesystem::remove_all(process / name);
    std::filesystem::create_directories(process / name);
    return process / name;
}

void keepClipboard() {
    // Not in the folder for temporary files, of which each test has its own.
    const QDir folder(QStringLiteral(SMAT_BINARY_DIR "/temporary"));
    folder.mkpath(QStringLiteral("."));
    static QLockFile lock(folder.filePath("clipboard.lock"));
    if (lock.isLocked()) {
        return;
    }
    lock.setStaleLockTime(0); // only that of a process that is gone
    ASSERT_TRUE(lock.lock());
    // The display refuses an owner whose time, that of the last event it saw, is before that of the
    // owner before: a window that gets another title sees an event now.
    QWindow window;
    window.create();
    for (int i = 0; i < 3; ++i) {
        window.setTitle(QString::number(i));
        QTest::qWait(5);
    }
}

} // namespace smat::gui::test
