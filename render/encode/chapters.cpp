// ffmpeg reads them from the argument itself, without a file. It holds 128 KiB: enough for the most
// and longest chapters that are allowed below.
#include "render/encode/chapters.h"

#include <algorithm>

namespace render {
namespace {

constexpr std::size_t kMostChapters = 255, kLongestName = 200;  // bytes

/// The name up to a whole character, in which nothing ends the line or has a meaning of its own.
std::string escaped(const std::string& name) {
    std::size_t length = std::min(name.size(), kLongestName);
    while (length > 0 && length < name.size() && (name[length] & 0xc0) == 0x80) --length;
    std::string text;
    for (const char c : name.substr(0, length)) {
        if (c == '=' || c == ';' || c == '#' || c == '\\') text += '\\';
        text += c == '\n' || c == '\r' || c == '\0' ? ' ' : c;
    }
    if (text.ends_with('\\')) text += ' ';  // else ffmpeg joins the next line
    return text;
}

}  // namespace

std::vector<std::string> chapterInput(std::span<const Chapter> chapters, int fps) {
    if (chapters.empty()) return {};
    std::string text = "data:text/plain,;FFMETADATA1\n";
    std::size_t count = 0;
    for (const Chapter& chapter : chapters) {
        if (chapter.end <= chapter.first || chapter.first < 0 || count == kMostChapters) continue;
        ++count;
        text += "[CHAPTER]\nTIMEBASE=1/" + std::to_string(fps) +
                "\nSTART=" + std::to_string(chapter.first) +
                "\nEND=" + std::to_string(chapter.end) + "\ntitle=" + escaped(chapter.name) + "\n";
    }
    return {"-f", "ffmetadata", "-i", text};
}

std::vector<std::string> chapterOutput(std::span<const Chapter> chapters, int input) {
    if (chapters.empty()) return {"-map_metadata", "-1"};  // which would take away names, too
    return {"-map_metadata", std::to_string(input), "-map_chapters", std::to_string(input)};
}

}  // namespace render
