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
    for (const Key& key : list) {
        const std::optional<double> value = keys.number(key.name, kAny);
        const std::string wrong = expressions.whyNoName(key.name);
        if (!wrong.empty())
            complaints.add(key.place, "a value is called '" + key.name + "': " + wrong);
        else  // known even if its number is wrong: that is told once
            expressions.define(key.name, value.value_or(1.0));
    }
}

}  // namespace demos
