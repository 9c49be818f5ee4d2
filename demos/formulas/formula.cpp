#include "demos/formulas/formula.h"

#include <duktape.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <string_view>

#include "demos/formulas/katex_text.h"
#include "demos/formulas/mathml.h"
#include "demos/text/complaints.h"
#include "demos/text/put_text.h"

namespace demos {
namespace {

// 2000 bytes need 6 MB at most; macros that grow without end reach the limit after a second.
constexpr std::size_t kMostMemory = 16u << 20;

// Returns "<span ..." or, for an invalid formula, "POSITION WHAT". Duktape has all of ES5; KaTeX
// needs one more function.
constexpr const char* kCall = R"js(
if (!Array.prototype.fill)
    Array.prototype.fill = function (value) {
        for (var i = 0; i < this.length; ++i) this[i] = value;
        return this;
    };
function refuse(asked) {
    throw new katex.ParseError(asked.command + ' is not allowed in a formula');
}
function mathMl(tex, display) {
    try {
        return katex.renderToString(tex, {output: 'mathml', displayMode: display, strict: 'ignore',
                                          trust: refuse, maxExpand: 1000});
    } catch (error) {
        if (!(error instanceof katex.ParseError)) throw error;
        return (error.position || 0) + ' ' + error.message;
    }
}
)js";

/// The header of each memory block: its size.
struct alignas(std::max_align_t) Block {
    std::size_t bytes;
};

void* allocate(void* used, duk_size_t bytes) {
    std::size_t& sum = *static_cast<std::size_t*>(used);
    if (bytes > kMostMemory || sum + bytes > kMostMemory) return nullptr;
    auto* block = static_cast<Block*>(std::malloc(sizeof(Block) + bytes));
    if (!block) return nullptr;
    block->bytes = bytes;
    sum += bytes;
    return block + 1;
}

void release(void* used, void* memory) {
    if (!memory) return;
    Block* block = static_cast<Block*>(memory) - 1;
    *static_cast<std::size_t*>(used) -= block->bytes;
    std::free(block);
}

void* reallocate(void* used, void* memory, duk_size_t bytes) {
    if (!memory) return allocate(used, bytes);
    std::size_t& sum = *static_cast<std::size_t*>(used);
    Block* block = static_cast<Block*>(memory) - 1;
    const std::size_t before = block->bytes;
    if (bytes > kMostMemory || sum - before + bytes > kMostMemory) return nullptr;
    block = static_cast<Block*>(std::realloc(block, sizeof(Block) + bytes));
    if (!block) return nullptr;
    block->bytes = bytes;
    sum += bytes - before;
    return block + 1;
}

/// Duktape calls it only for errors outside of protected calls; all calls below are protected.
void failed(void*, const char* message) {
    putError(std::string("KaTeX: ") + (message ? message : "failed"));
    std::abort();
}

struct Asked {
    std::string_view tex;
    bool display;
};

// The two protected functions: Duktape leaves them by longjmp, so they have no objects with
// destructors.

duk_ret_t load(duk_context* context, void*) {
    const std::string_view katex = katexText();
    duk_push_string(context, "katex.js");
    duk_compile_lstring_filename(context, 0, katex.data(), katex.size());
    duk_call(context, 0);
    duk_eval_string(context, kCall);
    return 0;
}

duk_ret_t ask(duk_context* context, void* what) {
    const Asked& asked = *static_cast<const Asked*>(what);
    duk_get_global_string(context, "mathMl");
    duk_push_lstring(context, asked.tex.data(), asked.tex.size());
    duk_push_boolean(context, asked.display);
    duk_call(context, 2);
    return 1;
}

/// KaTeX, loaded once, when it is first needed.
class Katex {
public:
    Katex() : context_(duk_create_heap(allocate, reallocate, release, &used_, failed)) {
        if (!context_ || duk_safe_call(context_, load, nullptr, 0, 1) != DUK_EXEC_SUCCESS)
            failed(nullptr, context_ ? duk_safe_to_string(context_, -1) : "out of memory");
        duk_pop(context_);
    }
    ~Katex() { duk_destroy_heap(context_); }
    Katex(const Katex&) = delete;
    Katex& operator=(const Katex&) = delete;

    /// The result of mathMl(); empty if it ran out of memory or nested too deep.
    std::string answer(Asked asked) {
        const bool good = duk_safe_call(context_, ask, &asked, 0, 1) == DUK_EXEC_SUCCESS;
        duk_size_t size = 0;
        const char* text = good ? duk_get_lstring(context_, -1, &size) : nullptr;
        std::string result(text ? text : "", size);
        duk_pop(context_);
        return result;
    }

private:
    std::size_t used_ = 0;  // bytes
    duk_context* context_;
};

/// The byte at which the n-th character begins.
std::size_t byteOf(const std::string& text, std::size_t n) {
    std::size_t at = 0;
    for (; at < text.size(); ++at) {
        const bool begins = (static_cast<unsigned char>(text[at]) & 0xc0u) != 0x80u;
        if (begins && n-- == 0) break;
    }
    return at;
}

/// KaTeX reports "KaTeX parse error: WHAT at position 3: x^2^3". The position is removed: the
/// caller, which knows the file, reports it.
std::string withoutPlace(std::string what) {
    constexpr std::string_view kPrefix = "KaTeX parse error: ";
    if (what.starts_with(kPrefix)) what.erase(0, kPrefix.size());
    for (const char* place : {" at position ", " at end of input: "})
        what.resize(std::min(what.size(), what.rfind(place)));
    return what;
}

[[noreturn]] void refuseFormula(const std::string& tex, const std::string& answer) {
    std::size_t place = 0;
    const char* end = answer.data() + answer.size();
    const char* rest = std::from_chars(answer.data(), end, place).ptr;
    throw FormulaError(byteOf(tex, place), withoutPlace(std::string(rest + 1, end)));
}

/// Refuses long formulas, control bytes and invalid UTF-8.
void checkText(const std::string& tex) {
    if (tex.size() > kLongestFormula)
        throw FormulaError(0, "the formula has " + std::to_string(tex.size()) +
                                  " bytes; it should have at most " +
                                  std::to_string(kLongestFormula));
    std::string plain = tex;
    for (char& c : plain)
        if (c == '\n' || c == '\r' || c == '\t') c = ' ';
    const std::string safe = printable(plain);
    const auto differs = std::mismatch(plain.begin(), plain.end(), safe.begin(), safe.end()).first;
    if (differs != plain.end())
        throw FormulaError(static_cast<std::size_t>(differs - plain.begin()),
                           "a control byte, or a byte that is not UTF-8; take it out");
}

}  // namespace

std::string mathMlOf(const std::string& tex, bool display) {
    checkText(tex);
    static Katex katex;
    const std::string answer = katex.answer({tex, display});
    if (answer.empty())
        throw FormulaError(0, "the formula grows or nests too far; make it simpler");
    if (answer.front() != '<') refuseFormula(tex, answer);
    return browserMathMl(answer, tex, display);
}

}  // namespace demos
