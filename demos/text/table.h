/// Tables of numbers, and the writing of results.
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "render/encode/file.h"

namespace demos {

/// Rows of comma-separated values; a number reads back to the same value.
class Table {
public:
    /// `target`: a file, "-" for standard output, or empty for a table that is not wanted.
    Table(std::string target, std::string_view columns);

    bool wanted() const { return !target_.empty(); }
    const std::string& target() const { return target_; }

    Table& cell(double value);
    Table& cell(std::string_view text);
    template <class Vector>
    Table& cells(const Vector& v) {
        return cell(v.x()).cell(v.y()).cell(v.z());
    }
    void endRow();
    long rows() const { return rows_; }
    const std::string& text() const { return text_; }
    /// Writes to the target, completely or not at all. Throws render::Error.
    void write() const;

private:
    std::string target_, text_;
    bool rowBegun_ = false;
    long rows_ = 0;
};

/// Writes to a file (completely or not at all; its folder is created) or to "-". Throws
/// render::Error, and render::AlreadyThere for a file that is kept.
void writeResult(const std::string& target, std::span<const std::uint8_t> bytes,
                 render::Existing existing = render::Existing::replaced);

/// What --overwrite means for an existing file.
inline render::Existing existingFiles(bool overwrite) {
    return overwrite ? render::Existing::replaced : render::Existing::kept;
}

/// The same path for two names of one file, which need not exist; "-" stays as it is.
std::filesystem::path placeOf(const std::string& target);

/// Throws Stop (wouldOverwrite) if the file exists.
void checkFree(const std::string& target, bool overwrite);

}  // namespace demos
