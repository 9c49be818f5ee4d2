#include "demos/export/replay_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "demos/export/replay_json.h"
#include "demos/text/page_text.h"
#include "demos/text/script_safe.h"

namespace demos {
namespace {

std::string leftOf(const Recording& recording, const ReplayShare& share) {
    std::string left;
    if (share.contacts < mostContacts(recording))
        left = fmt::format("the {} strongest contacts of a frame", share.contacts);
    if (share.every > 1)
        left += fmt::format("{}every {}{} frame", left.empty() ? "" : ", ", share.every,
                            share.every % 10 == 2 ? "nd" : "th");
    return left.empty() ? left : "large run: " + left + " only";
}

}  // namespace

ReplayPage replayPage(const Recording& recording, std::size_t bytes) {
    constexpr std::size_t kFewContacts = 64;
    const PageText text = replayPageText();
    for (ReplayShare share{1, mostContacts(recording)};;) {
        const std::string left = leftOf(recording, share);
        nlohmann::ordered_json json = replayJson(recording, share);
        json["left"] = left;
        std::string html = text.before + scriptSafe(json) + text.after;
        if (html.size() <= bytes || recording.frames.size() <= 2 * share.every)
            return {std::move(html), left};
        if (share.contacts > kFewContacts)
            share.contacts = std::max(share.contacts / 2, kFewContacts);
        else
            share.every *= 2;
    }
}

}  // namespace demos
