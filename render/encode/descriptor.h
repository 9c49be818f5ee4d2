/// An open file descriptor.
#pragma once

namespace render {

/// A file descriptor that closes itself. It is always above 2: in a program started with its
/// standard output closed it could be number 1, which dup2 in the child would overwrite.
class Descriptor {
public:
    /// Takes over an open one. Throws Error if it is negative: "cannot `purpose`: " and the text of
    /// errno.
    Descriptor(int number, const char* purpose);
    ~Descriptor();
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int number() const { return number_; }  ///< above 2

private:
    int number_;
};

}  // namespace render
