// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_REGION_HPP
#define VERIFICATION_CAMPAIGN_REGION_HPP

#include <cstddef>
#include <cstdint>
#include <new>
#include <utility>

namespace counterpoint::campaign
{
/// Memory at one fixed address for everything that the device under test is made of, so that it is kept and brought
/// back by copying bytes, and so that a changed pointer leads to the same place in every run of every process. What
/// lies around it cannot be read or written: a wild access ends with an exception. [SRS_CMG_001]
class Region
{
  public:
    /// @brief Throws std::runtime_error where the address is taken.
    explicit Region(std::size_t capacity_bytes);
    ~Region();
    Region(const Region&) = delete;
    Region& operator=(const Region&) = delete;

    /// @brief Makes an object that lives as long as the region; it is not destroyed.
    template <typename Object, typename... Arguments> [[nodiscard]] Object& Make(Arguments&&... arguments)
    {
        return *::new (Take(sizeof(Object), alignof(Object))) Object{std::forward<Arguments>(arguments)...};
    }
    /// @brief Zero-filled elements of a type that can be copied as bytes.
    template <typename Element> [[nodiscard]] Element* MakeArray(const std::size_t count)
    {
        return static_cast<Element*>(Take(sizeof(Element) * count, alignof(Element)));
    }
    /// @brief Nothing more is made: memory that is not brought back cannot be read or written from now on, so that no
    /// experiment finds what another one left there. What is in use becomes whole pages.
    void Close();
    /// @brief Where it begins.
    [[nodiscard]] std::uint8_t* Bytes() const noexcept
    {
        return bytes_;
    }
    /// @brief Bytes that are in use.
    [[nodiscard]] std::size_t Size() const noexcept
    {
        return used_;
    }
    /// @brief Distance of an object of the region from its beginning.
    [[nodiscard]] std::size_t OffsetOf(const void* object) const noexcept;

  private:
    [[nodiscard]] void* Take(std::size_t size, std::size_t alignment);

    std::uint8_t* reserved_{nullptr};
    std::uint8_t* bytes_{nullptr};
    std::size_t capacity_;
    std::size_t used_{0U};
};
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_REGION_HPP
