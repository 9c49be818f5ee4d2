/// An open file of the system's, by its number.
#pragma once

namespace render {

/// A file descriptor that closes itself. Always above 2: a program started with its standard
/// output closed would else be given number 1, and dup2 in the child would tread on it.
class Descriptor {
public:
    /// Takes over an open one. Where it is negative, Error: "cannot `purpose`: " and errno's words.
    Descriptor(int number, const char* purpose);
    ~Descriptor();
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int number() const { return number_; }  ///< above 2

private:
    int number_;
};

}  // namespace render
