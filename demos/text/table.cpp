#include "demos/text/table.h"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <cstdio>

#include "demos/text/complaints.h"
#include "demos/text/stop.h"
#include "render/error.h"

namespace demos {

Table::Table(std::string target, std::string_view columns) : target_(std::move(target)) {
    if (wanted()) text_ = std::string(columns) + "\n";
}

Table& Table::cell(double value) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value == 0.0 ? 0.0 : value);
    return cell(std::string_view(digits, static_cast<std::size_t>(end.ptr - digits)));
}

Table& Table::cell(std::string_view text) {
    if (rowBegun_) text_ += ',';
    rowBegun_ = true;
    text_ += text;
    return *this;
}

void Table::endRow() {
    text_ += '\n';
    rowBegun_ = false;
    ++rows_;
}

void Table::write() const {
    if (!wanted()) return;
    writeResult(target_, {reinterpret_cast<const std::uint8_t*>(text_.data()), text_.size()});
}

void writeResult(const std::string& target, std::span<const std::uint8_t> bytes,
                 render::Existing existing) {
    if (target == "-") {
        if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size() ||
            std::fflush(stdout) != 0)
            throw render::Error("cannot write to standard output: " + render::describeError(errno));
        return;
    }
    render::makeFolder(std::filesystem::path(target).parent_path());
    render::writeFileAtomically(target, bytes, existing);
}

std::filesystem::path placeOf(const std::string& target) {
    if (target == "-") return target;
    std::error_code ignored;
    return std::filesystem::weakly_canonical(std::filesystem::absolute(target, ignored), ignored);
}

void checkFree(const std::string& target, bool overwrite) {
    if (target == "-") return;
    std::error_code ignored;
    const auto status = std::filesystem::symlink_status(target, ignored);
    if (!std::filesystem::exists(status)) return;
    render::checkReplaceable(target);
    if (!overwrite)
        throw Stop(Exit::wouldOverwrite, fmt::format("'{}' already exists; --overwrite "
                                                     "replaces it",
                                                     printable(target)));
}

}  // namespace demos
