#include "demos/text/file_content.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <span>

#include "demos/text/text_hash.h"

namespace demos {
namespace {

/// An ordinary file, open for reading.
class OpenFile {
public:
    explicit OpenFile(const std::filesystem::path& path)
        : file_(open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC)) {}
    ~OpenFile() {
        if (file_ >= 0) close(file_);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    /// 0 if it is none.
    std::uintmax_t size() const {
        struct stat info {};
        const bool ordinary = file_ >= 0 && fstat(file_, &info) == 0 && S_ISREG(info.st_mode);
        return ordinary ? static_cast<std::uintmax_t>(info.st_size) : 0;
    }
    /// The number of bytes read: fewer only at the end.
    std::size_t readInto(std::span<std::uint8_t> bytes) const {
        std::size_t at = 0;
        for (ssize_t got; at < bytes.size(); at += static_cast<std::size_t>(got))
            if ((got = read(file_, bytes.data() + at, bytes.size() - at)) <= 0) break;
        return at;
    }

private:
    int file_;
};

}  // namespace

std::vector<std::uint8_t> contentOf(const std::filesystem::path& path, std::uintmax_t most) {
    const OpenFile file(path);
    const std::uintmax_t size = file.size();
    std::vector<std::uint8_t> bytes;
    if (size == 0 || size > most) return bytes;
    bytes.resize(static_cast<std::size_t>(size));
    bytes.resize(file.readInto(bytes));
    return bytes;
}

std::vector<std::uint8_t> startOf(const std::filesystem::path& path, std::size_t most) {
    const OpenFile file(path);
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(std::min<std::uintmax_t>(file.size(), most)));
    bytes.resize(file.readInto(bytes));
    return bytes;
}

std::uint64_t hashOfFile(const std::filesystem::path& path, std::uintmax_t most) {
    constexpr std::size_t kPiece = 1 << 20;
    const OpenFile file(path);
    const std::uintmax_t size = file.size();
    if (size == 0 || size > most) return 0;
    std::vector<std::uint8_t> piece(static_cast<std::size_t>(std::min<std::uintmax_t>(size, kPiece)));
    TextHash hash;
    for (std::size_t got; (got = file.readInto(piece)) > 0;) hash.addPiece(std::span(piece).first(got));
    hash.endPieces();
    return hash.value();
}

}  // namespace demos
