/// Several files that appear together, or none of them.
#pragma once
#include <deque>

#include "render/encode/descriptor.h"
#include "render/encode/file.h"

namespace render {

/// Each file is complete under its temporary name before the first one is renamed, so that a full
/// disk leaves none.
class FilesTogether {
public:
    explicit FilesTogether(Existing existing) : existing_(existing) {}
    /// Removes what has not been published.
    ~FilesTogether();
    FilesTogether(const FilesTogether&) = delete;
    FilesTogether& operator=(const FilesTogether&) = delete;

    /// Writes a file under its temporary name. Throws Error.
    void add(const NamedBytes& file);
    /// Renames all. Throws AlreadyThere or Error; files that did not exist before are then removed.
    void publish();

private:
    struct Held {
        std::filesystem::path path;
        Descriptor lock;
        Held(const std::filesystem::path& target, int number)
            : path(target), lock(number, "hold a file") {}
    };
    Existing existing_;
    std::deque<Held> held_;
    std::size_t published_ = 0;
};

}  // namespace render
