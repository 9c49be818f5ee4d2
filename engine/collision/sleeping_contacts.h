/// Contacts of sleeping islands lie apart, as they were when the island fell asleep: nobody looks
/// for them, nobody solves them, and whoever wakes finds the impulses that carried it.
#pragma once
#include "engine/collision/contacts.h"

namespace engine {

/// From `contacts` to `asleep`: those of bodies that have fallen asleep.
void layDownContacts(const Bodies& bodies, ContactFinder& finder);

/// From `asleep` to `contacts`: those of bodies that have woken.
void takeUpContacts(const Bodies& bodies, ContactFinder& finder);

}  // namespace engine
