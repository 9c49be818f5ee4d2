/// Values as bytes, for the state of a world: numbers from the low end, one after the other. What
/// is kept of a struct is listed once, for both directions, in its own member or next to it:
///   template <class Bytes> void keep(Bytes& bytes, Velocity& v) { bytes(v.linear, v.angular); }
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "engine/base/math.h"

namespace engine {

/// What writer and reader share: how values are taken apart into numbers.
template <class Own>
class StateBytes {
public:
    template <class... Values>
    void operator()(Values&... values) {
        (one(values), ...);
    }
    /// A number that must be in [least, most]; an index or an enumerator.
    template <class Value>
    void within(Value& value, int least, int most) {
        auto number = static_cast<std::int32_t>(value);
        own().number(number);
        if constexpr (Own::kReads) {
            own().require(number >= least && number <= most);
            value = static_cast<Value>(own().isGood() ? number : least);
        }
    }
    /// Lists with an item per body, joint ...: they have this size, or at most this size.
    template <class... Lists>
    void sized(std::size_t size, Lists&... lists) {
        (one(lists), ...);
        if constexpr (Own::kReads) (own().require(lists.size() == size), ...);
    }
    template <class... Lists>
    void upTo(std::size_t size, Lists&... lists) {
        (one(lists), ...);
        if constexpr (Own::kReads) (own().require(lists.size() <= size), ...);
    }

private:
    Own& own() { return static_cast<Own&>(*this); }

    template <class Value>
    void one(Value& value) {
        if constexpr (std::is_arithmetic_v<Value>)
            own().number(value);
        else if constexpr (std::is_array_v<Value>)
            for (auto& item : value) one(item);
        else if constexpr (requires { value.coeffs(); })
            one(value.coeffs());  // a rotation
        else if constexpr (requires { Value::SizeAtCompileTime; })
            for (int i = 0; i < Value::SizeAtCompileTime; ++i) own().number(value.data()[i]);
        else if constexpr (requires { value.keep(own()); })
            value.keep(own());
        else
            keep(own(), value);
    }
    void one(std::string& text) {
        std::vector<char> letters(text.begin(), text.end());
        own().list(letters);
        text.assign(letters.begin(), letters.end());
    }
    template <class Item, std::size_t kCount>
    void one(std::array<Item, kCount>& items) {
        for (Item& item : items) one(item);
    }
    template <class Item>
    void one(std::vector<Item>& items) {
        own().list(items);
    }
};

/// Overwrites `bytes` from `at` on, up to finish(). What they hold already needs no new memory.
class StateWriter : public StateBytes<StateWriter> {
public:
    static constexpr bool kReads = false;
    explicit StateWriter(std::vector<std::uint8_t>& bytes, std::size_t at = 0)
        : bytes_(bytes), used_(at) {}

    bool isGood() const { return true; }
    void require(bool) {}

    template <class Number>
    void number(const Number& value) {
        auto raw = std::bit_cast<std::array<std::uint8_t, sizeof(Number)>>(value);
        if constexpr (std::endian::native == std::endian::big)
            std::reverse(raw.begin(), raw.end());
        std::memcpy(next(sizeof value), raw.data(), sizeof value);
    }
    template <class Item>
    void list(std::vector<Item>& items) {
        number(static_cast<std::uint64_t>(items.size()));
        if constexpr (sizeof(Item) != 1)
            for (Item& item : items) (*this)(item);
        else if (!items.empty())
            std::memcpy(next(items.size()), items.data(), items.size());
    }
    /// Where the next writer of the same bytes begins; or, after the last one, cuts off what is older.
    std::size_t end() const { return used_; }
    void finish() { bytes_.resize(used_); }

private:
    std::uint8_t* next(std::size_t size) {
        if (bytes_.size() < used_ + size) bytes_.resize(2 * bytes_.size() + size + 4096);
        used_ += size;
        return bytes_.data() + used_ - size;
    }

    std::vector<std::uint8_t>& bytes_;
    std::size_t used_;
};

/// After the first value that cannot be, or that is missing, all others are read as zeros.
class StateReader : public StateBytes<StateReader> {
public:
    static constexpr bool kReads = true;
    explicit StateReader(std::span<const std::uint8_t> bytes) : left_(bytes) {}

    bool isGood() const { return good_; }
    bool isAtEnd() const { return left_.empty(); }
    std::span<const std::uint8_t> left() const { return left_; }
    void require(bool condition) { good_ = good_ && condition; }

    template <class Number>
    void number(Number& value) {
        require(left_.size() >= sizeof value);
        value = {};
        if (!good_) return;
        if constexpr (std::is_same_v<Number, bool>) {
            value = left_.front() != 0;
        } else {
            std::array<std::uint8_t, sizeof(Number)> raw;
            std::memcpy(raw.data(), left_.data(), raw.size());
            if constexpr (std::endian::native == std::endian::big)
                std::reverse(raw.begin(), raw.end());
            value = std::bit_cast<Number>(raw);
            if constexpr (std::is_floating_point_v<Number>) require(value == value);  // no NaN
        }
        left_ = left_.subspan(sizeof value);
    }
    /// Grows with what is really there: no size that a file claims takes memory.
    template <class Item>
    void list(std::vector<Item>& items) {
        std::uint64_t count = 0;
        number(count);
        items.clear();
        require(count <= left_.size());
        if (!good_) return;
        if constexpr (sizeof(Item) == 1) {
            items.resize(count);
            if (count > 0) std::memcpy(items.data(), left_.data(), count);
            left_ = left_.subspan(count);
            return;
        }
        items.reserve(count < left_.size() / sizeof(Item) ? count : left_.size() / sizeof(Item));
        for (std::uint64_t i = 0; i < count && good_; ++i) (*this)(items.emplace_back());
    }

private:
    std::span<const std::uint8_t> left_;
    bool good_ = true;
};

}  // namespace engine
