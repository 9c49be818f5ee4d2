// mp4: boxes (size, type) that fill the file: ftyp first, moov and mdat among the others
// webm: EBML header, then a Segment that fills the rest      gif: "GIF8" ... 0x3b
// webp: "RIFF" size "WEBP"                                    apng: signature ... IEND
#include "render/encode/film_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace render {
namespace {

using Offset = std::uint64_t;  // bytes

class FilmFile {
public:
    explicit FilmFile(int file) : file_(file) {
        struct stat status = {};
        if (::fstat(file, &status) == 0) size_ = static_cast<Offset>(status.st_size);
    }
    Offset size() const { return size_; }

    /// Empty if the file has fewer bytes.
    std::string text(Offset at, std::size_t count) const {
        std::string bytes(count, '\0');
        const bool within = at <= size_ && count <= size_ - at;
        const auto place = static_cast<off_t>(at);
        if (!within || ::pread(file_, bytes.data(), count, place) != static_cast<ssize_t>(count))
            return {};
        return bytes;
    }

    /// Big-endian; 0 past the end.
    Offset number(Offset at, std::size_t count) const {
        Offset value = 0;
        for (const char c : text(at, count)) value = value << 8 | static_cast<unsigned char>(c);
        return value;
    }

private:
    int file_;
    Offset size_ = 0;
};

bool mp4IsWhole(const FilmFile& film) {
    bool index = false, pictures = false;
    Offset at = 0;
    while (at < film.size()) {
        const std::string type = film.text(at + 4, 4);
        Offset length = film.number(at, 4);
        if (length == 1) length = film.number(at + 8, 8);
        if (type.empty() || length < 8 || length > film.size() - at) return false;
        if (at == 0 && type != "ftyp") return false;
        index = index || type == "moov";
        pictures = pictures || type == "mdat";
        at += length;
    }
    return index && pictures;
}

/// The length of an EBML element: the leading zeros of the first byte give the number of bytes that
/// follow it.
struct Length {
    Offset value = 0;
    std::size_t bytes = 0;  // 0: none
};

Length lengthAt(const FilmFile& film, Offset at) {
    const Offset first = film.number(at, 1);
    std::size_t bytes = 1;
    while (bytes <= 8 && (first & (0x100u >> bytes)) == 0) ++bytes;
    if (bytes > 8) return {};
    return {film.number(at, bytes) & ((Offset{1} << 7 * bytes) - 1), bytes};
}

bool webmIsWhole(const FilmFile& film) {
    constexpr Offset kHeader = 0x1a45dfa3, kSegment = 0x18538067;
    const Length header = lengthAt(film, 4);
    if (film.number(0, 4) != kHeader || header.bytes == 0) return false;
    const Offset segment = 4 + header.bytes + header.value;
    const Length content = lengthAt(film, segment + 4);
    return film.number(segment, 4) == kSegment && content.bytes > 0 && content.value > 0 &&
           segment + 4 + content.bytes + content.value == film.size();
}

bool webpIsWhole(const FilmFile& film) {
    Offset length = 0;  // little-endian
    for (Offset at = 8; at-- > 4;) length = length << 8 | film.number(at, 1);
    return film.text(0, 4) == "RIFF" && film.text(8, 4) == "WEBP" && length + 8 == film.size();
}

bool hasEnds(const FilmFile& film, std::string_view first, std::string_view last) {
    return film.size() >= first.size() + last.size() && film.text(0, first.size()) == first &&
           film.text(film.size() - last.size(), last.size()) == last;
}

}  // namespace

bool filmIsWhole(const VideoFormat& format, int file) {
    using namespace std::string_view_literals;
    const FilmFile film(file);
    switch (format.codec) {
        case Codec::h264:
            return mp4IsWhole(film);
        case Codec::vp9:
            return webmIsWhole(film);
        case Codec::gif:
            return hasEnds(film, "GIF8"sv, "\x3b"sv);
        case Codec::webp:
            return webpIsWhole(film);
        case Codec::apng:
            break;
    }
    return hasEnds(film, "\x89PNG\r\n\x1a\n"sv, "\0\0\0\0IEND\xae\x42\x60\x82"sv);
}

}  // namespace render
