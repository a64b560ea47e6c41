// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CONFORMANCE_DICTIONARY_HPP
#define VERIFICATION_CONFORMANCE_DICTIONARY_HPP

#include "safety_core/contract/configuration.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::conformance
{

/// An object of 64 bits at the most.
struct ObjectValue
{
    std::uint32_t low;
    std::uint32_t high;
};

/// The mappable objects of all cases, ascending:
///   2000h, 2001h         8 bits, producer                  6010h, 6011h:01,02   8 bits, consumer
///   6200h, 6201h:01      32 bits, consumer                 6210h, 6211h:01,02   8 bits, producer
///   6300h, 6301h:01..08  8 x sub bits, consumer            6400h, 6401h:01..08  8 x sub bits, producer
///   6302h, 6303h          as many bits as the sub-index  6402h, 6403h          likewise, producer
///   6304h, 6305h:01..40   1 bit, consumer               6404h, 6405h:01..40   1 bit, producer
///   6621h, 6623h:01..08  8 bits, producer                  6631h, 6633h:01..08  8 bits, consumer
///   6700h                8 bits, in no mapping             7000h + s:01..04     32 bits, consumer, s = 0 to 63
/// The objects of one index lie one behind the other in memory. 6302h and the like have sub-indices 1, 2, 3, 4, 5, 7,
/// 9, 12, 13, 16, 20, 31, 32, 33, 60, 62, 63, 64.
class Dictionary
{
  public:
    static constexpr std::uint16_t kObjectCount = 661U;

    Dictionary() noexcept;
    /// @brief Every byte of every object becomes `fill`, and an object that was moved lies where it lay before.
    void Fill(std::uint8_t fill) noexcept;
    /// @brief An object lies from now on where another one does; no effect if there is none of the two.
    void Share(std::uint16_t index, std::uint8_t sub, std::uint16_t other_index, std::uint8_t other_sub) noexcept;
    void Put(std::uint16_t index, std::uint8_t sub, const ObjectValue& value) noexcept;
    [[nodiscard]] ObjectValue Get(std::uint16_t index, std::uint8_t sub) const noexcept;
    /// @brief Bytes of the object; 0 if there is none.
    [[nodiscard]] std::uint8_t Bytes(std::uint16_t index, std::uint8_t sub) const noexcept;
    /// @brief Where the object lies; null if there is none.
    [[nodiscard]] std::uint8_t* Place(std::uint16_t index, std::uint8_t sub) const noexcept;
    /// @brief Objects that found their place: kObjectCount.
    [[nodiscard]] std::uint16_t Count() const noexcept
    {
        return count_;
    }
    [[nodiscard]] const MappableObject* Objects() const noexcept
    {
        return objects_;
    }
    /// @brief FNV-1a over all objects.
    [[nodiscard]] std::uint32_t Digest() const noexcept;

  private:
    static constexpr std::size_t kPlaceBytes = 1820U;

    void Add(std::uint16_t index, std::uint8_t sub, std::uint8_t bits, MapAccess access) noexcept;
    void AddRange(std::uint16_t index, std::uint8_t last_sub, std::uint8_t bits, MapAccess access) noexcept;
    void AddSizes(std::uint16_t index, MapAccess access) noexcept;
    void AddBits(std::uint16_t index, MapAccess access) noexcept;
    [[nodiscard]] const MappableObject* Find(std::uint16_t index, std::uint8_t sub) const noexcept;

    MappableObject objects_[kObjectCount]{};
    std::uint8_t places_[kPlaceBytes]{};
    std::uint16_t count_{0U};
    std::uint16_t used_{0U};
};

} // namespace counterpoint::conformance

#endif
