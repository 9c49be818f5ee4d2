#include "demos/text/complaints.h"

#include <algorithm>
#include <charconv>
#include <tuple>
#include <utility>

namespace demos {
namespace {

constexpr std::size_t kMostLines = 20;

/// Whether the first two of several bytes are an overlong encoding, a UTF-16 surrogate, or beyond
/// U+10FFFF.
bool outsideUtf8(unsigned first, unsigned second) {
    return (first == 0xe0 && second < 0xa0) || (first == 0xed && second >= 0xa0) ||
           (first == 0xf0 && second < 0x90) || (first == 0xf4 && second >= 0x90);
}

/// The length in bytes of the UTF-8 character that begins here; 0 if it is not printable.
std::size_t characterLength(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(0);
    if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
    const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : first >= 0xc2 ? 2 : 0;
    if (length == 0 || first > 0xf4 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xc0u) != 0x80u) return 0;
    // U+0080..U+009F are control characters too: U+009B begins an escape sequence.
    if (first == 0xc2 && byte(1) < 0xa0) return 0;
    if (outsideUtf8(first, byte(1))) return 0;
    // U+FFFE and U+FFFF are not characters; XML allows neither.
    if (first == 0xef && byte(1) == 0xbf && byte(2) >= 0xbe) return 0;
    return length;
}

}  // namespace

std::string printable(std::string_view text) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string out;
    while (!text.empty()) {
        const std::size_t length = characterLength(text);
        if (length > 0) {
            out += text.substr(0, length);
            text.remove_prefix(length);
        } else {
            const auto byte = static_cast<unsigned char>(text[0]);
            out += "\\x";
            out += kDigits[byte >> 4];
            out += kDigits[byte & 15];
            text.remove_prefix(1);
        }
    }
    return out;
}

std::string shown(std::string_view text, std::size_t most) {
    std::size_t length = most;
    if (text.size() <= length) return std::string(text);
    // Go back to the start of a character, so that none is cut in half.
    while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xc0u) == 0x80u) --length;
    return std::string(text.substr(0, length)) + "...";
}

std::string numberText(double value) {
    char buffer[32];
    const double size = value < 0.0 ? -value : value;
    const bool plain = size >= 1e-5 && size < 1e9;  // 0.0001, not 1e-04
    const std::to_chars_result end =
        plain ? std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed)
              : std::to_chars(buffer, buffer + sizeof buffer, value);
    return std::string(buffer, end.ptr);
}

Complaints::Complaints(std::vector<std::string> options) : options_(std::move(options)) {}

int Complaints::addFile(std::string name) {
    files_.push_back(std::move(name));
    return static_cast<int>(files_.size()) - 1;
}

std::string Complaints::fileOf(Place place) const {
    return place.line > 0 ? files_[static_cast<std::size_t>(place.file)] : "";
}

void Complaints::add(Place place, std::string what) {
    complaints_.push_back({place, std::move(what)});
}

void Complaints::addAll(const Complaints& of, int file) {
    for (Complaint complaint : of.complaints_) {
        complaint.place.file = file;
        complaints_.push_back(std::move(complaint));
    }
}

std::string Complaints::lineOf(const Complaint& complaint) const {
    const Place& place = complaint.place;
    const std::string what = shown(complaint.what, kLongestMessage);
    if (place.line > 0)
        return printable(files_[static_cast<std::size_t>(place.file)] + ":" +
                         std::to_string(place.line) + ":" + std::to_string(place.column) + ": " +
                         what);
    const std::size_t option = static_cast<std::size_t>(place.column) - 1;
    return printable("--set " + shown(options_[option]) + ": " + what);
}

std::vector<std::string> Complaints::lines() const {
    std::vector<Complaint> sorted = complaints_;
    std::stable_sort(sorted.begin(), sorted.end(), [](const Complaint& a, const Complaint& b) {
        const bool fileA = a.place.line > 0, fileB = b.place.line > 0;
        return std::tie(fileA, a.place.file, a.place.line, a.place.column) <
               std::tie(fileB, b.place.file, b.place.line, b.place.column);
    });
    std::vector<std::string> all;
    for (const Complaint& complaint : sorted) {
        std::string line = lineOf(complaint);
        if (all.empty() || all.back() != line) all.push_back(std::move(line));
    }
    if (all.size() > kMostLines) {
        const std::size_t more = all.size() - kMostLines;
        all.resize(kMostLines);
        all.push_back("and " + std::to_string(more) + " more");
    }
    return all;
}

}  // namespace demos
