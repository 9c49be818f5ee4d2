/// The verdict as junit.xml, which CI servers show next to a change.
#pragma once
#include <string>

#include "demos/regression/verdict.h"

namespace demos {

/// A suite per scene; in it a case per expectation ("expect: drift of ..."), one for the physics
/// and one per picture, under the names that `impulse approve` takes ("stack@physics",
/// "stack@2.5").
///
/// A scene that was not run because nothing has changed has one skipped case; one that could not be
/// tested has one case with an error. The result is well-formed XML 1.0 whatever the texts contain,
/// and the same bytes for the same verdict: no times, no host names.
std::string junitXml(const TestVerdict& verdict);

}  // namespace demos
