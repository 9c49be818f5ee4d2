/// Reads a .glb from its bytes alone, as another program would.
#pragma once
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace demos::test {

struct Glb {
    nlohmann::json json;
    std::vector<std::uint8_t> binary;

    const nlohmann::json& node(const std::string& name) const {
        static const nlohmann::json none;
        for (const nlohmann::json& node : json["nodes"])
            if (node["name"] == name) return node;
        ADD_FAILURE() << "no node '" << name << "'";
        return none;
    }

    int numberOf(const std::string& name) const {
        for (std::size_t i = 0; i < json["nodes"].size(); ++i)
            if (json["nodes"][i]["name"] == name) return static_cast<int>(i);
        return -1;
    }

    /// The numbers of an accessor, `width` per element; Number: its component type.
    template <class Number>
    std::vector<Number> numbers(int accessor, std::size_t width) const {
        const nlohmann::json& a = json["accessors"][accessor];
        const nlohmann::json& view = json["bufferViews"][a["bufferView"].get<int>()];
        std::vector<Number> values(a["count"].get<std::size_t>() * width);
        const std::size_t offset = view["byteOffset"], bytes = view["byteLength"];
        EXPECT_EQ(bytes, values.size() * sizeof(Number));
        EXPECT_LE(offset + bytes, binary.size());
        EXPECT_EQ(offset % 4, 0u);
        std::memcpy(values.data(), binary.data() + offset, bytes);
        return values;
    }

    /// The animation's values for a node's path; empty if it has none. `input`: its times.
    std::vector<float> motion(int node, const std::string& path,
                              std::vector<float>* input = nullptr) const {
        if (!json.contains("animations")) return {};
        const nlohmann::json& animation = json["animations"][0];
        for (const nlohmann::json& channel : animation["channels"]) {
            if (channel["target"]["node"] != node || channel["target"]["path"] != path) continue;
            const nlohmann::json& sampler = animation["samplers"][channel["sampler"].get<int>()];
            EXPECT_EQ(sampler["interpolation"], "LINEAR");
            if (input) *input = numbers<float>(sampler["input"], 1);
            return numbers<float>(sampler["output"], path == "rotation" ? 4 : 3);
        }
        return {};
    }
};

inline std::uint32_t wordAt(std::span<const std::uint8_t> bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value |= static_cast<std::uint32_t>(bytes[at + i]) << (8 * i);
    return value;
}

/// Also checks the container: magic, version, lengths, order, padding.
inline Glb readGlb(std::span<const std::uint8_t> bytes) {
    Glb glb;
    if (bytes.size() < 28 || bytes.size() != wordAt(bytes, 8)) {
        ADD_FAILURE() << bytes.size() << " bytes do not say their own number";
        return glb;
    }
    EXPECT_EQ(std::string(bytes.begin(), bytes.begin() + 4), "glTF");
    EXPECT_EQ(wordAt(bytes, 4), 2u);
    const std::size_t length = wordAt(bytes, 12), binary = 20 + length;
    EXPECT_EQ(length % 4, 0u);
    EXPECT_EQ(wordAt(bytes, 16), 0x4e4f534au);
    glb.json = nlohmann::json::parse(bytes.begin() + 20,
                                     bytes.begin() + static_cast<std::ptrdiff_t>(binary));
    const std::size_t rest = wordAt(bytes, binary);
    EXPECT_EQ(rest % 4, 0u);
    EXPECT_EQ(wordAt(bytes, binary + 4), 0x004e4942u);
    EXPECT_EQ(bytes.size(), binary + 8 + rest);
    glb.binary.assign(bytes.begin() + static_cast<std::ptrdiff_t>(binary) + 8, bytes.end());
    const std::size_t told = glb.json["buffers"][0]["byteLength"];
    EXPECT_LE(told, rest);
    EXPECT_LT(rest - told, 4u);
    return glb;
}

}  // namespace demos::test
