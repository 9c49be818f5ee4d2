// [values]: names for the scene's expressions

#include "demos/scene/read_parts.h"

namespace demos {
namespace {

constexpr Range kAny{-1e15, 1e15};
constexpr std::size_t kMost = 1000;

}  // namespace

void readValues(Keys& top, Expressions& expressions, Complaints& complaints) {
    const Value* table = top.any("values");
    if (!table) return;
    Keys keys = top.inner(*table, "[values]");
    const std::vector<Key>& list = keys.others(kAny);
    if (list.size() > kMost) {
        keys.complain(list[kMost].name, "more than 1000 values; leave some out");
        return;
    }
    for (const Key& key : list) expressions.announce(key.name);
    for (const Key& key : list) {
        expressions.withdraw(key.name);  // of itself it is not later
        const std::string wrong = expressions.whyNoName(key.name);
        if (!wrong.empty()) {
            complaints.add(key.place, "a value is called '" + shown(key.name) + "': " + wrong);
            continue;
        }
        // Known even if its number is wrong: that is told once.
        expressions.define(key.name, keys.number(key.name, kAny).value_or(1.0));
    }
}

}  // namespace demos
