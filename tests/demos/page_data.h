/// What the script of a written page reads.
#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace demos::test {

inline nlohmann::json dataOf(const std::string& page) {
    const std::string mark = "id=\"data\">";
    const std::size_t begin = page.find(mark) + mark.size();
    return nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

}  // namespace demos::test
