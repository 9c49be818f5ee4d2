#include "demos/slides/scratch_folder.h"

#include <stdlib.h>

#include <cerrno>

#include "render/encode/file.h"
#include "render/error.h"

namespace demos {

ScratchFolder::ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "impulse_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
        throw render::Error("cannot make '" + name + "': " + render::describeError(errno));
    path_ = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

}  // namespace demos
