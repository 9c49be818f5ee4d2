// How much pictures differ that were drawn in different ways: compares every two of the given folders
// file by file and prints a Markdown table. For `tests/benchmark/gate`.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "render/difference.h"
#include "render/encode/png_read.h"

namespace {

namespace fs = std::filesystem;

constexpr int kLevels[] = {1, 2, 3, 4};  // windows are counted over each of these

/// The largest differences over all pictures that two folders have in common.
struct Pair {
    int pictures = 0, identical = 0;
    long differing = 0;  // pixels of one picture
    int largest = 0;     // levels
    int windows[std::size(kLevels)] = {};
    double ssim = 1.0;
    std::string worst;  // the picture with the lowest SSIM
};

render::Image read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return render::decodePng(std::vector<std::uint8_t>(std::istreambuf_iterator<char>(file), {}));
}

/// Paths relative to the folder, sorted by name.
std::set<fs::path> picturesIn(const fs::path& folder) {
    std::set<fs::path> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".png") names.insert(fs::relative(entry.path(), folder));
    return names;
}

void add(const fs::path& name, const render::Image& a, const render::Image& b, Pair& pair) {
    ++pair.pictures;
    pair.identical += a.pixels == b.pixels;
    for (std::size_t i = 0; i < std::size(kLevels); ++i) {
        const render::Difference d = render::compare(a, b, kLevels[i]);
        pair.differing = std::max(pair.differing, d.differing);
        pair.largest = std::max(pair.largest, d.largest);
        pair.windows[i] = std::max(pair.windows[i], d.worstWindow);
        if (d.worstSsim < pair.ssim) pair.ssim = d.worstSsim, pair.worst = name.string();
    }
}

Pair compared(const fs::path& a, const fs::path& b) {
    Pair pair;
    const std::set<fs::path> there = picturesIn(b);
    for (const fs::path& name : picturesIn(a))
        if (there.contains(name)) add(name, read(a / name), read(b / name), pair);
    return pair;
}

void print(const fs::path& a, const fs::path& b, const Pair& pair) {
    std::printf("| %s, %s | %d | %d | %ld | %d |", a.filename().c_str(), b.filename().c_str(),
                pair.pictures, pair.identical, pair.differing, pair.largest);
    for (const int window : pair.windows) std::printf(" %d |", window);
    std::printf(" %.4f %s |\n", pair.ssim, pair.worst.c_str());
}

void printHeader() {
    std::printf("| ways | pictures | identical | pixels of one that differ | levels |");
    for (const int levels : kLevels) std::printf(" window over %d |", levels);
    std::printf(" SSIM |\n| --- | --: | --: | --: | --: |");
    for (std::size_t i = 0; i < std::size(kLevels); ++i) std::printf(" --: |");
    std::printf(" --- |\n");
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc < 3) {
        std::fprintf(stderr, "gate_pairs FOLDER FOLDER...: needs two folders of pictures\n");
        return 2;
    }
    printHeader();
    for (int a = 1; a < argc; ++a)
        for (int b = a + 1; b < argc; ++b) print(argv[a], argv[b], compared(argv[a], argv[b]));
} catch (const std::exception& error) {
    std::fprintf(stderr, "gate_pairs: %s\n", error.what());
    return 1;
}
