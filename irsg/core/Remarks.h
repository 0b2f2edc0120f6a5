#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace irsg {

/// Says what a reader took for granted in a file that it could use: "FILE: columns are separated by
/// semicolons". The sentence goes to the CollectedRemarks of this thread, else to the listener of
/// the process; without either it is lost, and nothing else changes.
void remarkOn(const std::string& file, std::string_view sentence);

/// Receives the remarks of all threads that do not collect their own; empty: nobody does. May be
/// called from several threads at once.
void setRemarkListener(std::function<void(const std::string&)> listener);

/// While it lives, keeps the remarks that its thread makes, each once. The latest of a thread
/// receives them.
class CollectedRemarks {
  public:
    CollectedRemarks();
    ~CollectedRemarks();
    CollectedRemarks(const CollectedRemarks&) = delete;
    CollectedRemarks& operator=(const CollectedRemarks&) = delete;

    const std::vector<std::string>& sentences() const { return sentences_; }
    void add(const std::string& sentence);

  private:
    CollectedRemarks* outer_;
    std::vector<std::string> sentences_;
};

} // namespace irsg
