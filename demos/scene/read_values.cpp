// [values]: names for the scene's expressions

#include "demos/scene/table_readers.h"

namespace demos {
namespace {

constexpr Range kNamedValue{-1e15, 1e15};
constexpr std::size_t kMostNamedValues = 1000;

}  // namespace

void readValues(Keys& top, Expressions& expressions, Complaints& complaints) {
    const Value* table = top.any("values");
    if (!table) return;
    Keys keys = top.inner(*table, "[values]");
    const std::vector<Key>& list = keys.others(kNamedValue);
    if (list.size() > kMostNamedValues) {
        keys.complain(list[kMostNamedValues].name, "more than 1000 values; leave some out");
        return;
    }
    for (const Key& key : list) expressions.announce(key.name);
    for (const Key& key : list) {
        expressions.withdraw(key.name);  // in its own expression it does not count as a later one
        const std::string wrong = expressions.whyNoName(key.name);
        if (!wrong.empty()) {
            complaints.add(key.place, "a value is called '" + shown(key.name) + "': " + wrong);
            continue;
        }
        // Defined even if its number is wrong, so that only this error is reported.
        expressions.define(key.name, keys.number(key.name, kNamedValue).value_or(1.0));
    }
}

}  // namespace demos
