/// The scenes that have passed and not changed since: passed.json in the folder of the results.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace demos {

class PassCache {
public:
    /// A file that is missing or invalid gives an empty cache.
    explicit PassCache(std::filesystem::path file);

    bool has(const std::string& scene, std::uint64_t fingerprint) const;
    void add(const std::string& scene, std::uint64_t fingerprint);
    void remove(const std::string& scene);
    /// Throws render::Error.
    void write() const;

private:
    std::filesystem::path file_;
    std::map<std::string, std::uint64_t> passed_;
};

}  // namespace demos
