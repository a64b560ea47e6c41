// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CANOPEN_GENERATE_RANDOM_DEVICE_HPP
#define TESTS_CANOPEN_GENERATE_RANDOM_DEVICE_HPP

#include <cstdint>
#include <string>

namespace counterpoint::generate::test
{
/// Numbers that follow from a seed on every machine (splitmix64).
class Random
{
  public:
    explicit Random(const std::uint64_t seed) noexcept : state_(seed)
    {
    }
    std::uint64_t Next() noexcept
    {
        state_ += 0x9E3779B97F4A7C15U;
        std::uint64_t mixed = state_;
        mixed = (mixed ^ (mixed >> 30U)) * 0xBF58476D1CE4E5B9U;
        mixed = (mixed ^ (mixed >> 27U)) * 0x94D049BB133111EBU;
        return mixed ^ (mixed >> 31U);
    }
    /// 0 to `count` - 1.
    std::uint32_t Below(const std::uint32_t count) noexcept
    {
        return static_cast<std::uint32_t>(Next() % count);
    }
    bool OneIn(const std::uint32_t count) noexcept
    {
        return Below(count) == 0U;
    }

  private:
    std::uint64_t state_;
};

/// A DCF that `counterpoint check` has no error for. Seeds whose rest by 4 is 0 have 128 mapping entries of one bit,
/// 1 has many SRDOs, 2 static mappings, 3 everything mixed.
[[nodiscard]] std::string RandomDevice(std::uint64_t seed);

/// Objects beside the safety configuration: all data types, unusual names, limits.
[[nodiscard]] std::string RandomObjects(Random& random);
/// A section of a variable or sub-index.
[[nodiscard]] std::string Section(const std::string& head, const std::string& name, std::uint32_t type,
                                  const std::string& access, const std::string& value, const std::string& more = "");
[[nodiscard]] std::string HexText(std::uint64_t value, int digits);
} // namespace counterpoint::generate::test

#endif // TESTS_CANOPEN_GENERATE_RANDOM_DEVICE_HPP
