/// What a page does that measures itself.
#pragma once

namespace demos {

/// Replaces the page by a <pre id="measured"> with base64 of JSON: an object per slide, see
/// measured_slides.cpp.
extern const char* const kMeasureScript;

}  // namespace demos
