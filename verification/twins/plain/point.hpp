// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TWINS_PLAIN_POINT_HPP
#define VERIFICATION_TWINS_PLAIN_POINT_HPP

#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::twins::plain
{

/// How a place can be wrong, whatever it says.
enum class Slip : std::uint8_t
{
    kNone,
    kAlways,
    kNever,
    kOpposite,
    kLeftOut,
    kZero,
    kOneMore,
    kOneLess,
    kAllOnes,
    kLimitRefused,
    kOnlyBelow,
    kSumOfInstants,
    kAThousandth,
    kOneSuffices,
    kBothNeeded,
    kExactlyOne,
    kDown,
    kDifference,
    kQuotient,
    kSumInstead,
    kOnlyFirst,
    kWithoutFirst,
    kTheGreater,
    kTheOther,
    kOrInstead,
    kAndInstead,
};

/// A place of the plain channel where a requirement says something. One at a time is wrong.
class Point
{
  public:
    Point(const char* requirement, const char* what, std::vector<Slip> slips);
    Point(const Point&) = delete;
    Point& operator=(const Point&) = delete;
    [[nodiscard]] const char* Requirement() const noexcept
    {
        return requirement_;
    }
    [[nodiscard]] std::string Text(Slip slip) const;
    [[nodiscard]] const std::vector<Slip>& Slips() const noexcept
    {
        return slips_;
    }
    /// @brief From now on this one is wrong, no other.
    void Break(Slip slip) const noexcept
    {
        broken = this;
        how = slip;
    }
    /// @brief Every point, in a fixed order.
    [[nodiscard]] static std::vector<const Point*>& All();

  protected:
    ~Point() = default;
    [[nodiscard]] static std::uint64_t Ones() noexcept;
    [[nodiscard]] Slip Now() const noexcept
    {
        return (broken == this) ? how : Slip::kNone;
    }

  private:
    inline static const Point* broken{nullptr};
    inline static Slip how{Slip::kNone};

    const char* requirement_;
    const char* what_;
    std::vector<Slip> slips_;
};

/// Whether something holds.
class Decision final : public Point
{
  public:
    Decision(const char* requirement, const char* what)
        : Point{requirement, what, {Slip::kAlways, Slip::kNever, Slip::kOpposite}}
    {
    }
    [[nodiscard]] bool operator()(bool is_true) const noexcept
    {
        const Slip slip = Now();
        return (slip == Slip::kNone) ? is_true : ((slip == Slip::kOpposite) ? (!is_true) : (slip == Slip::kAlways));
    }
};

/// Something that is to be done.
class Act final : public Point
{
  public:
    Act(const char* requirement, const char* what) : Point{requirement, what, {Slip::kLeftOut}}
    {
    }
    [[nodiscard]] bool operator()() const noexcept
    {
        return Now() == Slip::kNone;
    }
};

/// A value: a number, a mask, a member of an enumeration.
class Number final : public Point
{
  public:
    Number(const char* requirement, const char* what)
        : Point{requirement, what, {Slip::kZero, Slip::kOneMore, Slip::kOneLess, Slip::kAllOnes}}
    {
    }
    template <typename T> [[nodiscard]] T operator()(T value) const noexcept
    {
        const auto was = static_cast<std::uint64_t>(value);
        const Slip slip = Now();
        if (slip == Slip::kZero)
        {
            return static_cast<T>(0U);
        }
        if (slip == Slip::kOneMore)
        {
            return static_cast<T>(was + 1U);
        }
        if (slip == Slip::kOneLess)
        {
            return static_cast<T>(was - 1U);
        }
        if (slip == Slip::kAllOnes)
        {
            return static_cast<T>(Ones());
        }
        return value;
    }
};

/// Two things that are needed both.
class Both final : public Point
{
  public:
    Both(const char* requirement, const char* what) : Point{requirement, what, {Slip::kOneSuffices, Slip::kExactlyOne}}
    {
    }
    [[nodiscard]] bool operator()(bool one, bool other) const noexcept
    {
        const Slip slip = Now();
        return (slip == Slip::kNone) ? (one && other)
                                     : ((slip == Slip::kOneSuffices) ? (one || other) : (one != other));
    }
};

/// Two things of which one suffices.
class Either final : public Point
{
  public:
    Either(const char* requirement, const char* what) : Point{requirement, what, {Slip::kBothNeeded, Slip::kExactlyOne}}
    {
    }
    [[nodiscard]] bool operator()(bool one, bool other) const noexcept
    {
        const Slip slip = Now();
        return (slip == Slip::kNone) ? (one || other) : ((slip == Slip::kBothNeeded) ? (one && other) : (one != other));
    }
};

/// Something that is counted up by one.
class Counter final : public Point
{
  public:
    Counter(const char* requirement, const char* what) : Point{requirement, what, {Slip::kLeftOut, Slip::kDown}}
    {
    }
    template <typename T> [[nodiscard]] T operator()(T value) const noexcept
    {
        const Slip slip = Now();
        return (slip == Slip::kLeftOut) ? value : static_cast<T>((slip == Slip::kDown) ? (value - 1U) : (value + 1U));
    }
};

/// A sum of two.
class Sum final : public Point
{
  public:
    Sum(const char* requirement, const char* what) : Point{requirement, what, {Slip::kDifference}}
    {
    }
    [[nodiscard]] std::uint32_t operator()(std::uint32_t one, std::uint32_t other) const noexcept
    {
        return (Now() == Slip::kDifference) ? (one - other) : (one + other);
    }
};

/// The exclusive or of two.
class ExclusiveOr final : public Point
{
  public:
    ExclusiveOr(const char* requirement, const char* what)
        : Point{requirement, what, {Slip::kOrInstead, Slip::kAndInstead}}
    {
    }
    [[nodiscard]] std::uint32_t operator()(std::uint32_t one, std::uint32_t other) const noexcept
    {
        const Slip slip = Now();
        if (slip == Slip::kOrInstead)
        {
            return one | other;
        }
        return (slip == Slip::kAndInstead) ? (one & other) : (one ^ other);
    }
};

/// What is left of one number without another.
class Difference final : public Point
{
  public:
    Difference(const char* requirement, const char* what) : Point{requirement, what, {Slip::kSumInstead}}
    {
    }
    [[nodiscard]] std::uint32_t operator()(std::uint32_t one, std::uint32_t other) const noexcept
    {
        return (Now() == Slip::kSumInstead) ? (one + other) : (one - other);
    }
};

/// The lesser of two: what is told, cut to the room.
class Lesser final : public Point
{
  public:
    Lesser(const char* requirement, const char* what)
        : Point{requirement, what, {Slip::kTheGreater, Slip::kTheOther, Slip::kZero}}
    {
    }
    [[nodiscard]] std::uint32_t operator()(std::uint32_t told, std::uint32_t room) const noexcept
    {
        const Slip slip = Now();
        if (slip == Slip::kZero)
        {
            return 0U;
        }
        if (slip == Slip::kTheOther)
        {
            return room;
        }
        return ((told < room) != (slip == Slip::kTheGreater)) ? told : room;
    }
};

/// Which ones of a row, numbered from 0, it is about: all of them.
class Each final : public Point
{
  public:
    Each(const char* requirement, const char* what) : Point{requirement, what, {Slip::kOnlyFirst, Slip::kWithoutFirst}}
    {
    }
    [[nodiscard]] bool operator()(std::uint32_t number) const noexcept
    {
        const Slip slip = Now();
        return (slip == Slip::kNone) || ((number == 0U) == (slip == Slip::kOnlyFirst));
    }
};

/// A product of two.
class Product final : public Point
{
  public:
    Product(const char* requirement, const char* what) : Point{requirement, what, {Slip::kQuotient, Slip::kZero}}
    {
    }
    [[nodiscard]] std::uint32_t operator()(std::uint32_t one, std::uint32_t other) const noexcept
    {
        const Slip slip = Now();
        return (slip == Slip::kZero) ? 0U : ((slip == Slip::kQuotient) ? (one / other) : (one * other));
    }
};

/// A slot that is named: the one that is meant.
class Place final : public Point
{
  public:
    Place(const char* requirement, const char* what) : Point{requirement, what, {Slip::kZero}}
    {
    }
    template <typename T> [[nodiscard]] T operator()(T slot) const noexcept
    {
        return (Now() == Slip::kZero) ? T{0U} : slot;
    }
};

/// A time in microseconds of one in milliseconds.
class Milliseconds final : public Point
{
  public:
    Milliseconds(const char* requirement, const char* what)
        : Point{requirement, what, {Slip::kZero, Slip::kOneMore, Slip::kOneLess, Slip::kAThousandth}}
    {
    }
    [[nodiscard]] std::uint32_t operator()(std::uint32_t ms) const noexcept
    {
        const Slip slip = Now();
        if (slip == Slip::kZero)
        {
            return 0U;
        }
        if (slip == Slip::kOneMore)
        {
            return ms * 1001U;
        }
        if (slip == Slip::kOneLess)
        {
            return ms * 999U;
        }
        if (slip == Slip::kAThousandth)
        {
            return ms / 1000U;
        }
        return ms * 1000U;
    }
};

/// Whether more time than a limit has elapsed. The limit itself is accepted. [SRS_TIME_004]
class Limit final : public Point
{
  public:
    Limit(const char* requirement, const char* what)
        : Point{requirement,
                what,
                {Slip::kAlways, Slip::kNever, Slip::kOpposite, Slip::kLimitRefused, Slip::kOnlyBelow,
                 Slip::kSumOfInstants}}
    {
    }
    [[nodiscard]] bool operator()(std::uint32_t now, std::uint32_t then, std::uint32_t limit) const noexcept
    {
        const std::uint32_t elapsed = now - then;
        const Slip slip = Now();
        if (slip == Slip::kAlways)
        {
            return true;
        }
        if (slip == Slip::kNever)
        {
            return false;
        }
        if (slip == Slip::kOpposite)
        {
            return elapsed <= limit;
        }
        if (slip == Slip::kLimitRefused)
        {
            return elapsed >= limit;
        }
        if (slip == Slip::kOnlyBelow)
        {
            return elapsed < limit;
        }
        if (slip == Slip::kSumOfInstants)
        {
            return (now + then) > limit;
        }
        return elapsed > limit;
    }
};

} // namespace counterpoint::twins::plain

#endif
