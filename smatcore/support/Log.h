#pragma once

#include <string>

namespace smat {

enum class LogLevel { quiet, info, debug };

/// How much is said on standard error; quiet until asked. A line is a sentence printed before the
/// act, so that the last line names the culprit.
void setLogLevel(LogLevel level);
void logInfo(const std::string& sentence);
void logDebug(const std::string& sentence);

} // namespace smat
