/// Contacts of sleeping islands are stored separately, unchanged since the island fell asleep. They
/// are neither detected nor solved; a body that wakes gets back the impulses that supported it.
#pragma once
#include "engine/collision/contacts.h"

namespace engine {

/// Moves contacts of bodies that have fallen asleep from `contacts` to `asleep`.
void layDownContacts(const Bodies& bodies, ContactFinder& finder);

/// Moves contacts of bodies that have woken from `asleep` to `contacts`.
void takeUpContacts(const Bodies& bodies, ContactFinder& finder);

}  // namespace engine
