#pragma once

#include <map>
#include <optional>
#include <string>

#include <QComboBox>

namespace smat::gui {

/// Which index of a database faces are to get: that of an entry, any other number as it is typed,
/// or that none is given.
class IndexBox : public QComboBox {
    Q_OBJECT

  public:
    explicit IndexBox(QWidget* parent = nullptr);

    /// What there is to choose from, by index; what is chosen stays.
    void setEntries(const std::map<int, std::string>& names, bool mayAdd);
    /// Nothing where faces keep theirs.
    std::optional<int> index() const;
    void setIndex(std::optional<int> index);
    /// False while the text is no index.
    bool isRight() const;

  signals:
    void edited();
    /// The last of the list: an entry that is not there yet.
    void newEntryWanted();

  private:
    QString textOf(int index) const;
    std::map<int, std::string> names_;
    std::optional<int> last_;
};

} // namespace smat::gui
