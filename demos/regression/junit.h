/// The verdict as junit.xml, which CI servers show beside a change.
#pragma once
#include <string>

#include "demos/regression/verdict.h"

namespace demos {

/// A suite per scene; in it a case per expectation ("expect: drift of ..."), one of the physics and
/// one per picture, under the names that `impulse approve` takes ("stack@physics", "stack@2.5").
///
/// A scene that was not played, since nothing has changed, has one case, skipped; one that could
/// not be tested has one case, an error. Well-formed XML 1.0 whatever the texts hold, and the same
/// bytes for the same verdict: no times, no hosts.
std::string junitXml(const TestVerdict& verdict);

}  // namespace demos
