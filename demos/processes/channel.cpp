#include "demos/processes/channel.h"

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
    std::uint64_t stateHash, firstSize, secondSize, incidentSize, notesSize, dataCount;
};
constexpr std::uint64_t kMostData = 64;  // files
constexpr std::uint64_t kLargest = std::uint64_t{4} << 30;  // bytes; more means a damaged header

std::vector<std::uint8_t> bytesOf(const std::string& text) { return {text.begin(), text.end()}; }

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
                        message.second.size(), message.incident.size(), message.notes.size(),
                        message.data.size()};
    std::uint8_t bytes[sizeof header];
    std::memcpy(bytes, &header, sizeof header);
    bool sent = sendAll(bytes) && sendAll(message.first) && sendAll(message.second) &&
                sendAll(bytesOf(message.incident)) && sendAll(bytesOf(message.notes));
    for (const std::vector<std::uint8_t>& file : message.data) {
        const std::uint64_t size = file.size();
        std::uint8_t sizeBytes[sizeof size];
        std::memcpy(sizeBytes, &size, sizeof size);
        sent = sent && sendAll(sizeBytes) && sendAll(file);
    }
    if (!sent) ::shutdown(socket_, SHUT_WR);  // half a message: the other side waits no longer
    return sent;
}

bool Channel::receiveBlock(std::uint64_t size, std::vector<std::uint8_t>& block) {
    if (size > kLargest) return false;
    block.resize(size);
    return receiveAll(block);
}

bool Channel::receive(Message& message) {
    std::uint8_t bytes[sizeof(Header)];
    if (!receiveAll(bytes)) return false;
    Header header;
    std::memcpy(&header, bytes, sizeof header);
    if (header.dataCount > kMostData) return false;
    message.kind = header.kind;
    message.frame = header.frame;
    message.stateHash = header.stateHash;
    message.data.resize(header.dataCount);
    if (!receiveBlock(header.firstSize, message.first)) return false;
    if (!receiveBlock(header.secondSize, message.second)) return false;
    std::vector<std::uint8_t> text;
    if (!receiveBlock(header.incidentSize, text)) return false;
    message.incident.assign(text.begin(), text.end());
    if (!receiveBlock(header.notesSize, text)) return false;
    message.notes.assign(text.begin(), text.end());
    for (std::vector<std::uint8_t>& file : message.data) {
        std::uint64_t size = 0;
        std::uint8_t sizeBytes[sizeof size];
        if (!receiveAll(sizeBytes)) return false;
        std::memcpy(&size, sizeBytes, sizeof size);
        if (!receiveBlock(size, file)) return false;
    }
    return true;
}

}  // namespace demos
