#pragma once

#include <filesystem>

#include <QList>
#include <QWidget>

class QHBoxLayout;
class QToolButton;
class QVBoxLayout;

namespace smat::gui {

/// What is seen while nothing is open: samples with their pictures, the projects of last time, and
/// where to begin with a model of one's own. It lies over the page of the model.
class StartPage : public QWidget {
    Q_OBJECT

  public:
    /// Covers `page`, whatever its size.
    explicit StartPage(QWidget* page);

    void setRecentFiles(const QStringList& files);

  signals:
    /// A sample or a recent file.
    void fileChosen(const QString& file);
    void modelWanted();
    void projectWanted();
    void openWanted();
    void guideWanted();

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    /// Cards as large as three fit into the page, smaller ones where it is narrow.
    void fitCards();
    /// What lies below is not seen, and gets no keys.
    void letKeysBelow(bool let);
    QWidget* makeSamples();
    QWidget* makeOwn();
    QWidget* makeRecent();

    QVBoxLayout* recent_ = nullptr;
    QList<QToolButton*> cards_;
};

} // namespace smat::gui
