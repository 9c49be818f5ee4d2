#include "demos/mjcf/defaults.h"

#include "demos/text/nearest.h"

namespace demos::mjcf {
namespace {

/// Later values replace earlier ones.
void overlay(const Element& element, std::vector<Attribute>& attributes) {
    for (const Attribute& own : element.attributes) {
        Attribute* before = nullptr;
        for (Attribute& attribute : attributes)
            if (attribute.name == own.name) before = &attribute;
        if (before)
            *before = own;
        else
            attributes.push_back(own);
    }
}

}  // namespace

Defaults::Defaults(const Element& root, Diagnostics& diagnostics) : diagnostics_(diagnostics) {
    classes_[main_];
    for (const Element& element : root.children) {
        if (element.name != "default") continue;
        if (const Attribute* name = element.find("class")) {
            classes_[name->value] = classes_[main_];
            main_ = name->value;
        }
        read(element, main_, Class(classes_[main_]));
    }
}

void Defaults::read(const Element& element, const std::string& name, const Class& outer) {
    Class own = outer;
    for (const Element& child : element.children)
        if (child.name != "default") overlay(child, own[child.name]);
    classes_[name] = own;
    for (const Element& child : element.children) {
        if (child.name != "default") continue;
        const Attribute* inner = child.find("class");
        if (!inner || inner->value.empty())
            diagnostics_.wrong(child.spot, "an inner <default> has no class; write class=\"NAME\"");
        else if (classes_.contains(inner->value))
            diagnostics_.wrong(inner->spot,
                               "two classes are called '" + inner->value + "'; rename one");
        else
            read(child, inner->value, own);
    }
}

std::string Defaults::known(const Attribute& name) const {
    if (classes_.contains(name.value)) return name.value;
    std::vector<std::string> names;
    for (const auto& [known, own] : classes_) names.push_back(known);
    diagnostics_.wrong(name.spot, "no default class is called '" + name.value + "'" +
                                      suggestion(name.value, names));
    return main_;
}

std::string Defaults::childclass(const Element& body, const std::string& around) const {
    const Attribute* own = body.find("childclass");
    return own ? known(*own) : around;
}

Attributes Defaults::of(const Element& element, const std::string& childclass) const {
    return of(element, childclass, element.name);
}

Attributes Defaults::of(const Element& element, const std::string& childclass,
                        const std::string& called) const {
    const Attribute* own = element.find("class");
    const std::string name = own ? known(*own) : childclass.empty() ? main_ : childclass;
    const Class& attributes = classes_.at(name);
    const auto found = attributes.find(called);
    static const std::vector<Attribute> kNone;
    return {element, found == attributes.end() ? kNone : found->second, diagnostics_};
}

}  // namespace demos::mjcf
