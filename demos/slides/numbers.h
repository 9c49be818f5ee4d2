/// Numbers from a slide's runs in its text: "it sinks by @{penetration}".
///
///   @{penetration}          a measure of the run (measures/summary.h), with its unit
///   @{2.drift:4}            of the second run, four significant digits; default: at most three
///   @{expect.1}             the measured value of the scene's first [[expect]]
///   @{body.box3.velocity}   position, velocity, spin (vectors); height, speed
///   @{joint.rod.impulse}    impulse (N s, of the last step), force (N), separation (m)
///   @{contacts.impulse}     sum of normal impulses of the last step (N s); points, largest
///   @{run.time}             time (s), steps, sweeps (of the last step), energy (J), hash
#pragma once
#include <stdexcept>
#include <string>
#include <vector>

#include "demos/slides/quantity.h"

namespace demos {

struct NumberName {
    int run = 1;
    std::string group;             // measure, expect, body, joint, contacts, run
    std::string of;                // which expectation (from 1), body or joint; else empty
    std::string field;             // "penetration", "velocity"; empty for an expectation
    int digits = 3;                // significant, 1..9
    Zeros zeros = Zeros::dropped;  // kept if the number of digits is given
};

/// An @{...} is invalid; `at`: the byte of the text where it begins.
class NumberError : public std::runtime_error {
public:
    NumberError(std::size_t at, const std::string& what) : runtime_error(what), at_(at) {}
    std::size_t at() const { return at_; }

private:
    std::size_t at_;
};

/// A text split at its numbers: words[0] numbers[0] words[1] ... words.back().
struct NumberedText {
    std::vector<std::string> words;  // one more than numbers
    std::vector<NumberName> numbers;
    std::vector<std::size_t> places;  // of each number: the byte of its @
    std::vector<std::size_t> ends;    // and the byte after its }
};

/// Throws NumberError for names that no run can have. It does not check whether a body of the name
/// exists, since it has no scene.
NumberedText numberedText(const std::string& text);

/// The text, whose parts are `parts`, with every byte of a number replaced by this letter, so that
/// names do not affect where formulas are found.
std::string maskedNumbers(const std::string& text, const NumberedText& parts, char letter);

}  // namespace demos
