/// Complete messages between a worker and its parent through a socket.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace demos {

enum class MessageKind : std::uint32_t {
    ready,     // worker: the renderer's name
    orders,    // parent: the wanted frames, one byte each
    state,     // simulating process: a state of the frame
    frame,     // worker: a picture
    orphaned,  // worker: the simulating process has ended
    diverged,  // worker: the line for the user
    failed     // worker: the line for the user
};

struct Message {
    MessageKind kind = MessageKind::failed;
    std::int32_t frame = 0;
    std::uint64_t stateHash = 0;
    std::vector<std::uint8_t> first, second;  // of a picture: PNG and raw RGBA; else a text, empty
    std::vector<std::vector<std::uint8_t>> data;  // of a picture: files of the data passes
    std::string incident;  // of a picture: of the simulation until then (Player::incident)
    std::string notes;     // of the last picture: what else to know of the run, a line each

    std::string text() const { return {first.begin(), first.end()}; }
    static Message ofText(MessageKind kind, const std::string& text);
};

/// One end of a socket; its destructor closes it.
class Channel {
public:
    explicit Channel(int socket) : socket_(socket) {}
    ~Channel();
    Channel(Channel&& other) noexcept;
    Channel& operator=(Channel&& other) noexcept;

    /// False: the other side is gone, or will see the end of this channel and wait no longer.
    bool send(const Message& message);
    /// False: the other side is gone.
    bool receive(Message& message);
    void close();

private:
    bool sendAll(std::span<const std::uint8_t> bytes);
    bool receiveBlock(std::uint64_t size, std::vector<std::uint8_t>& block);
    bool receiveAll(std::span<std::uint8_t> bytes);
    int socket_ = -1;
};

}  // namespace demos
