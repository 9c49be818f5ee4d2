// Friction on bodies that turn (solver/riding_contacts.h).
#include "engine/solver/riding_contacts.h"

#include <gtest/gtest.h>

#include "tests/support/worlds.h"

namespace engine {
namespace {

Contact between(int a, int b) {
    Contact contact;
    contact.a = a, contact.b = b, contact.count = 1;
    contact.friction = 0.5;
    return contact;
}

// Bodies that wait in a sub-step have no lead, and those after them have theirs.
TEST(RidingContacts, LeadTheirRidersWhoeverWaits) {
    Bodies bodies;
    BodyDef disc = support::body(Shape::box({4, 1, 4}), {0, 0, 0});
    disc.kind = BodyKind::kinematic;
    disc.spin = {0, 1, 0};
    addBody(bodies, disc, 0);
    for (const double x : {1.0, -1.0}) addBody(bodies, support::body(Shape::box({1, 1, 1}), {x, 1, 0}), bodies.count());
    setSpans(bodies, support::kStep);
    const std::vector<Contact> contacts = {between(0, 1), between(0, 2)};
    DisjointSets islands;
    islands.reset(bodies.count());
    RidingContacts riding;
    riding.find(contacts, {}, bodies, islands);
    ASSERT_EQ(riding.list().size(), 2u);
    std::vector<Pose> before = bodies.poses;
    for (const int i : {1, 2}) bodies.poses[i].position.z() += 0.01;
    riding.begin(bodies, before);
    const Vec3 lead = riding.list()[1].lead;
    EXPECT_NEAR(lead.x(), 0.01, 1e-3);  // w x (rho - rho_0)
    bodies.acts[1] = 0;
    bodies.poses[2].position.z() += 0.01;
    riding.begin(bodies, before);
    EXPECT_EQ(riding.list()[0].lead, Vec3(0, 0, 0));
    EXPECT_NEAR((riding.list()[1].lead - lead).x(), 0.01, 1e-3);
}

}  // namespace
}  // namespace engine
