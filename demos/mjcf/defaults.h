/// <default>: values of attributes that elements do not set themselves.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "demos/mjcf/attributes.h"

namespace demos::mjcf {

class Defaults {
public:
    /// Reads the <default>s in `root`, which may be nested: an inner one inherits from the outer.
    Defaults(const Element& root, Diagnostics& diagnostics);

    /// The element with the defaults of its class, else of `childclass` (from the <body>s around
    /// it), else of the outermost class.
    Attributes of(const Element& element, const std::string& childclass) const;
    /// With the defaults of another element name: <connect> and <weld> use those of <equality>.
    Attributes of(const Element& element, const std::string& childclass,
                  const std::string& called) const;
    /// The childclass for the contents of `body`: its own, or else `around`.
    std::string childclass(const Element& body, const std::string& around) const;

private:
    using Class = std::map<std::string, std::vector<Attribute>>;  // by element

    void read(const Element& element, const std::string& name, const Class& outer);
    std::string known(const Attribute& name) const;

    std::map<std::string, Class> classes_;
    std::string main_ = "main";
    Diagnostics& diagnostics_;
};

}  // namespace demos::mjcf
