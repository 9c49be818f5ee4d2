#include "engine/collision/sleeping_contacts.h"

#include <algorithm>
#include <iterator>

namespace engine {
namespace {

/// Both lists stay sorted by pair.
template <class Which>
void move(std::vector<Contact>& from, std::vector<Contact>& to, Which which) {
    const auto before = static_cast<std::ptrdiff_t>(to.size());
    std::copy_if(from.begin(), from.end(), std::back_inserter(to), which);
    std::erase_if(from, which);
    std::inplace_merge(to.begin(), to.begin() + before, to.end(),
                       [](const Contact& l, const Contact& r) { return pairOf(l) < pairOf(r); });
}

}  // namespace

void layDownContacts(const Bodies& bodies, ContactFinder& finder) {
    move(finder.contacts, finder.asleep, [&](const Contact& c) {
        return bodies.isAsleep(c.a) || bodies.isAsleep(c.b);
    });
}

void takeUpContacts(const Bodies& bodies, ContactFinder& finder) {
    move(finder.asleep, finder.contacts, [&](const Contact& c) {
        return !bodies.isAsleep(c.a) && !bodies.isAsleep(c.b);
    });
}

}  // namespace engine
