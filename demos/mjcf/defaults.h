/// <default>: what elements say that do not say it themselves.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "demos/mjcf/attributes.h"

namespace demos::mjcf {

class Defaults {
public:
    /// Of the <default>s in `root`, which may lie in each other: an inner one begins as the outer.
    Defaults(const Element& root, Diagnostics& diagnostics);

    /// The element with what its class says, or else `childclass` (of the <body>s around it), or
    /// else the outermost class.
    Attributes of(const Element& element, const std::string& childclass) const;
    /// As if it were called otherwise: <connect> and <weld> have the defaults of <equality>.
    Attributes of(const Element& element, const std::string& childclass,
                  const std::string& called) const;
    /// The childclass for what is in `body`: its own, or that from around it.
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
