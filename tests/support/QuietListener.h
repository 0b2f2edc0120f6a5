#pragma once

#include <stdexcept>
#include <string>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace smat::test {

/// A port on loopback that should hear nothing.
class QuietListener {
  public:
    QuietListener() : socket_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        auto* any = reinterpret_cast<sockaddr*>(&address);
        if (socket_ < 0 || bind(socket_, any, size) != 0 || listen(socket_, 8) != 0 ||
            getsockname(socket_, any, &size) != 0) {
            throw std::runtime_error("nothing can listen on loopback");
        }
        port_ = ntohs(address.sin_port);
    }
    ~QuietListener() { close(socket_); }
    QuietListener(const QuietListener&) = delete;
    QuietListener& operator=(const QuietListener&) = delete;

    /// "http://127.0.0.1:PORT/NAME".
    std::string address(const std::string& name) const {
        return "http://127.0.0.1:" + std::to_string(port_) + "/" + name;
    }
    int port() const { return port_; }
    /// Whether anybody has called so far.
    bool heard() const {
        pollfd end{socket_, POLLIN, 0};
        return poll(&end, 1, 0) > 0;
    }

  private:
    int socket_ = -1, port_ = 0;
};

} // namespace smat::test
