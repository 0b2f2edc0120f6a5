#include "irsg/geometry/reading/OsgNotices.h"

#include <algorithm>
#include <mutex>
#include <sstream>
#include <utility>

#include <osg/Notify>
#include <osg/ref_ptr>

namespace irsg {
namespace {
thread_local OsgNotices* listener = nullptr;
} // namespace

class OsgNoticeHandler : public osg::NotifyHandler {
  public:
    explicit OsgNoticeHandler(osg::NotifyHandler* before) : before_(before) {}
    void notify(osg::NotifySeverity severity, const char* message) override {
        if (listener)
            listener->text_ += message;
        else if (before_.valid())
            before_->notify(severity, message);
    }

  private:
    osg::ref_ptr<osg::NotifyHandler> before_;
};

OsgNotices::OsgNotices() : outer_(listener) {
    static std::once_flag once;
    std::call_once(once,
                   [] { osg::setNotifyHandler(new OsgNoticeHandler(osg::getNotifyHandler())); });
    listener = this;
}

OsgNotices::~OsgNotices() {
    listener = outer_;
}

std::vector<std::string> OsgNotices::take() {
    std::istringstream in(std::exchange(text_, {}));
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);)
        if (!line.empty() && std::find(lines.begin(), lines.end(), line) == lines.end())
            lines.push_back(line);
    return lines;
}

void addNotices(std::vector<std::string>& remarks, const std::vector<std::string>& lines) {
    constexpr std::size_t most = 8;
    for (std::size_t i = 0; i < std::min(most, lines.size()); ++i)
        remarks.push_back("OpenSceneGraph: " + lines[i]);
    if (lines.size() > most)
        remarks.push_back("OpenSceneGraph: " + std::to_string(lines.size() - most) +
                          " more lines like these");
}

} // namespace irsg
