/// Writes XML: elements with attributes and either text or child elements.
#pragma once
#include <deque>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace demos {

class XmlElement {
public:
    explicit XmlElement(std::string name) : name_(std::move(name)) {}

    /// The reference stays valid as long as this element does.
    XmlElement& add(std::string name) { return children_.emplace_back(std::move(name)); }
    void set(std::string name, std::string value) {
        attributes_.emplace_back(std::move(name), std::move(value));
    }
    void setText(std::string text) { text_ = std::move(text); }
    /// The element as a document, one element per line.
    std::string document() const;

private:
    void write(int depth, std::string& out) const;

    std::string name_, text_;
    std::vector<std::pair<std::string, std::string>> attributes_;
    std::deque<XmlElement> children_;
};

}  // namespace demos
