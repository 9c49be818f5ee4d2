/// Checked access to an element's attributes, its own and those of its default class. A wrong value
/// is reported and then treated as missing.
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
    /// Own values win. An orientation or a position of the class counts only if the element itself
    /// has none in any form.
    Attributes(const Element& element, const std::vector<Attribute>& ofClass,
               Diagnostics& diagnostics);

    const std::string& element() const { return element_; }
    const Spot& spot() const { return spot_; }
    bool has(std::string_view name) const { return find(name) != nullptr; }
    Spot spotOf(std::string_view name) const;  // the element's if it is missing

    std::string text(std::string_view name) const;  // empty if it is missing
    std::optional<double> number(std::string_view name, Range range);
    std::optional<int> whole(std::string_view name, Range range);
    /// `least` to `most` numbers.
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
