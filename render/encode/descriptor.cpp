#include "render/encode/descriptor.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string>

#include "render/encode/file.h"
#include "render/error.h"

namespace render {
namespace {

[[noreturn]] void fail(const char* purpose, int error) {
    throw Error(std::string("cannot ") + purpose + ": " + describeError(error));
}

}  // namespace

Descriptor::Descriptor(int number, const char* purpose) : number_(number) {
    if (number < 0) fail(purpose, errno);
    if (number > 2) return;
    number_ = ::fcntl(number, F_DUPFD_CLOEXEC, 3);
    const int error = errno;
    ::close(number);
    if (number_ < 0) fail(purpose, error);
}

Descriptor::~Descriptor() { ::close(number_); }

}  // namespace render
