#include "demos/film/channel.h"

#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace demos {
namespace {

struct Header {
    MessageKind kind;
    std::int32_t frame;
    std::uint64_t stateHash, firstSize, secondSize;
};
constexpr std::uint64_t kLargest = std::uint64_t{4} << 30;  // bytes; more is a torn header

}  // namespace

Message Message::ofText(MessageKind kind, const std::string& text) {
    Message message;
    message.kind = kind;
    message.first.assign(text.begin(), text.end());
    return message;
}

Channel::~Channel() { close(); }
Channel::Channel(Channel&& other) noexcept : socket_(std::exchange(other.socket_, -1)) {}
Channel& Channel::operator=(Channel&& other) noexcept {
    std::swap(socket_, other.socket_);
    return *this;
}

void Channel::close() {
    if (socket_ >= 0) ::close(socket_);
    socket_ = -1;
}

bool Channel::sendAll(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(sent));
    }
    return true;
}

bool Channel::receiveAll(std::span<std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t got = ::recv(socket_, bytes.data(), bytes.size(), 0);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(got));
    }
    return true;
}

bool Channel::send(const Message& message) {
    const Header header{message.kind, message.frame, message.stateHash, message.first.size(),
                        message.second.size()};
    std::uint8_t bytes[sizeof header];
    std::memcpy(bytes, &header, sizeof header);
    return sendAll(bytes) && sendAll(message.first) && sendAll(message.second);
}

bool Channel::receive(Message& message) {
    std::uint8_t bytes[sizeof(Header)];
    if (!receiveAll(bytes)) return false;
    Header header;
    std::memcpy(&header, bytes, sizeof header);
    if (header.firstSize > kLargest || header.secondSize > kLargest) return false;
    message.kind = header.kind;
    message.frame = header.frame;
    message.stateHash = header.stateHash;
    message.first.resize(header.firstSize);
    message.second.resize(header.secondSize);
    return receiveAll(message.first) && receiveAll(message.second);
}

}  // namespace demos
