#include "smatcore/support/Log.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

namespace smat {

namespace {

spdlog::logger& logger() {
    static const std::shared_ptr<spdlog::logger> instance = [] {
        auto made = std::make_shared<spdlog::logger>(
            "smat", std::make_shared<spdlog::sinks::stderr_color_sink_mt>());
        made->set_pattern("%H:%M:%S.%e %v");
        made->set_level(spdlog::level::off);
        made->flush_on(spdlog::level::debug);
        return made;
    }();
    return *instance;
}

} // namespace

void setLogLevel(LogLevel level) {
    logger().set_level(level == LogLevel::quiet  ? spdlog::level::off
                       : level == LogLevel::info ? spdlog::level::info
                                                 : spdlog::level::debug);
}

void logInfo(const std::string& sentence) {
    logger().info("{}", sentence);
}

void logDebug(const std::string& sentence) {
    logger().debug("{}", sentence);
}

} // namespace smat
