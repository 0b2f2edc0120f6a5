#pragma once

#include <string>
#include <vector>

namespace irsg {

/// While an object lives, what OpenSceneGraph says on this thread is kept instead of printed. What
/// it says elsewhere goes where it went before.
class OsgNotices {
  public:
    OsgNotices();
    ~OsgNotices();
    OsgNotices(const OsgNotices&) = delete;
    OsgNotices& operator=(const OsgNotices&) = delete;

    /// Sentences so far, without line ends, each once.
    std::vector<std::string> take();

  private:
    OsgNotices* outer_;
    std::string text_;
    friend class OsgNoticeHandler;
};

/// Adds the first of such sentences to what a reader has to say.
void addNotices(std::vector<std::string>& remarks, const std::vector<std::string>& lines);

} // namespace irsg
