/// DejaVu Sans, embedded at build time.
#pragma once

namespace render {

const unsigned char* fontBytes();

}  // namespace render
