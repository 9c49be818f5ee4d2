/// Checked access to an element's attributes, its own and those of its default class. Values that
/// are wrong are reported, and are then as if not given.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "demos/mjcf/xml_tree.h"
#include "demos/scene/keys.h"

namespace demos::mjcf {

class Attributes {
public:
    /// Own values win; of the ways to say an orientation, or a place, those of the class count only
    /// where the element says none itself.
    Attributes(const Element& element, const std::vector<Attribute>& ofClass,
               Diagnostics& diagnostics);

    const std::string& element() const { return element_; }
    const Spot& spot() const { return spot_; }
    bool has(std::string_view name) const { return find(name) != nullptr; }
    Spot spotOf(std::string_view name) const;  // the element's where it is not given

    std::string text(std::string_view name) const;  // empty where it is not given
    std::optional<double> number(std::string_view name, Range range);
    std::optional<int> whole(std::string_view name, Range range);
    /// From `least` to `most` of them.
    std::optional<std::vector<double>> numbers(std::string_view name, std::size_t least,
                                               std::size_t most, Range range);
    std::optional<Vec3> vector(std::string_view name, Range range);
    std::optional<std::string> word(std::string_view name, const std::vector<std::string>& words);
    std::optional<bool> truth(std::string_view name);

    void wrong(std::string_view name, const std::string& what);
    void note(std::string_view name, const std::string& what);

private:
    const Attribute* find(std::string_view name) const;

    std::string element_;
    Spot spot_;
    std::vector<Attribute> all_;
    Diagnostics& diagnostics_;
};

}  // namespace demos::mjcf
