#include "demos/text/file_content.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace demos {

std::vector<std::uint8_t> contentOf(const std::filesystem::path& path, std::uintmax_t most) {
    std::vector<std::uint8_t> bytes;
    const int file = open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) return bytes;
    struct stat info {};
    if (fstat(file, &info) == 0 && S_ISREG(info.st_mode) &&
        static_cast<std::uintmax_t>(info.st_size) <= most) {
        bytes.resize(static_cast<std::size_t>(info.st_size));
        std::size_t at = 0;
        for (ssize_t got; at < bytes.size(); at += static_cast<std::size_t>(got))
            if ((got = read(file, bytes.data() + at, bytes.size() - at)) <= 0) break;
        bytes.resize(at);
    }
    close(file);
    return bytes;
}

}  // namespace demos
