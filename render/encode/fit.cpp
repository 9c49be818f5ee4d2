#include "render/encode/fit.h"

#include <array>
#include <cstdio>
#include <optional>
#include <vector>

namespace render {
namespace {

namespace fs = std::filesystem;

std::uint64_t bytesIn(const fs::path& path) {
    std::error_code missing;
    const std::uintmax_t bytes = fs::file_size(path, missing);
    return missing ? 0 : bytes;
}

class Search {
public:
    Search(const StoredFilm& film, const VideoFormat& format, const Fit& fit,
           const fs::path& output)
        : film_(film),
          format_(format),
          fit_(fit),
          output_(output),
          ladder_(ladderOf(format, film.source)) {}

    Fitted best() {
        if (const std::optional<Fitted> fitted = attempt(0)) return *fitted;
        const std::size_t last = ladder_.size() - 1;
        std::optional<Fitted> found;
        if (last > 0) found = attempt(last);  // if this one does not fit, none does
        if (!found) {
            throw Error("even " + describe(format_, ladder_[last]) + " takes " + bytesText(bytes_) +
                        ", more than " + bytesText(fit_.largestFile));
        }
        std::size_t low = 1, high = last;  // the first that fits is in [low, high]
        bool written = true;               // the file holds ladder_[high]
        while (low < high) {
            const std::size_t middle = (low + high) / 2;
            const std::optional<Fitted> fitted = attempt(middle);
            written = fitted.has_value();
            if (fitted) found = fitted;
            (fitted ? high : low) = fitted ? middle : middle + 1;
        }
        if (!written) found = attempt(high);  // writes the same bits again
        if (!found) throw Error("ffmpeg wrote a different film the second time; draw it again");
        return *found;
    }

private:
    bool tooLarge(std::uint64_t bytes) const {
        return fit_.largestFile > 0 && bytes > fit_.largestFile;
    }

    /// Encodes into output_; nothing if it does not fit.
    std::optional<Fitted> attempt(std::size_t rung) {
        const Encoding& encoding = ladder_[rung];
        fs::resize_file(output_, 0);  // else the size of the last attempt would be read
        Ffmpeg ffmpeg(
            restoreArguments(format_, film_.source, encoding, Ffmpeg::kSharedFile, output_),
            film_.patience, &film_.file);
        bool cancelled = false, passed = false;
        const bool whole = ffmpeg.finish([&] {
            cancelled = fit_.cancelled && fit_.cancelled();
            passed = rung + 1 < ladder_.size() && tooLarge(bytesIn(output_));
            return cancelled || passed;
        });
        if (cancelled) throw Cancelled("interrupted during encoding");
        if (!whole && !passed) throw Error(ffmpeg.complaint());
        bytes_ = bytesIn(output_);
        if (passed || tooLarge(bytes_)) {
            tellTooLarge(encoding, whole);
            return std::nullopt;
        }
        checkFrames(ffmpeg.framesWritten(), encoding.framesOf(film_.frames));
        return Fitted{encoding, bytes_};
    }

    void tellTooLarge(const Encoding& encoding, bool whole) const {
        if (!fit_.tell) return;
        fit_.tell(describe(format_, encoding) + ": " + (whole ? "" : "over ") + bytesText(bytes_) +
                  ", too large");
    }

    static void checkFrames(int written, int expected) {
        if (written == expected) return;
        throw Error("ffmpeg wrote " + std::to_string(written) + " of " + std::to_string(expected) +
                    " frames; draw it again");
    }

    const StoredFilm& film_;
    const VideoFormat& format_;
    const Fit& fit_;
    const fs::path& output_;
    std::vector<Encoding> ladder_;
    std::uint64_t bytes_ = 0;  // of the last attempt
};

}  // namespace

Fitted encodeToFit(const StoredFilm& film, const VideoFormat& format, const Fit& fit,
                   const fs::path& output) {
    return Search(film, format, fit, output).best();
}

std::string bytesText(std::uint64_t bytes) {
    constexpr std::array<const char*, 4> kUnits = {"kB", "MB", "GB", "TB"};
    if (bytes < 1000) return std::to_string(bytes) + " bytes";
    double value = static_cast<double>(bytes) / 1000.0;
    std::size_t unit = 0;
    for (; value >= 999.5 && unit + 1 < kUnits.size(); ++unit) value /= 1000.0;
    char text[32];
    std::snprintf(text, sizeof text, value < 9.95 ? "%.1f %s" : "%.0f %s", value, kUnits[unit]);
    return text;
}

}  // namespace render
