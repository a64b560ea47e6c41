// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_INJECTION_RAM_HPP
#define VERIFICATION_INJECTION_RAM_HPP

#include "verification/injection/digest.hpp"
#include "verification/injection/outside.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace counterpoint::injection
{

/// Of each byte of RAM: the bits that were read as 0, the ones that were read as 1, and whether it was written.
struct Accesses
{
    std::vector<std::uint8_t> zeros{};
    std::vector<std::uint8_t> ones{};
    std::vector<bool> is_written{};
};

/// Addresses: begin of the RAM, end of the variables, end of the stack.
struct RamLayout
{
    std::uint32_t begin;
    std::uint32_t live;
    std::uint32_t top;
};

/// @brief Whole pages of zeros. Throws std::runtime_error where there is no memory.
[[nodiscard]] std::uint8_t* Allocate(std::uint32_t bytes);

/// The RAM of the emulated processor, with a bit that may be stuck.
class Ram
{
  public:
    /// @brief `places`: where the objects of the application lie.
    Ram(const RamLayout& layout, std::uint32_t bytes, std::uint32_t places);

    [[nodiscard]] std::uint8_t* First()
    {
        return first_;
    }
    [[nodiscard]] std::uint32_t Bytes() const
    {
        return bytes_;
    }
    [[nodiscard]] std::vector<std::uint8_t> Content() const;
    /// @brief No bit is stuck any more.
    void Restore(const std::vector<std::uint8_t>& content);
    /// @brief Whether variables, and the stack above `stack`, are as then.
    [[nodiscard]] bool Equals(const std::vector<std::uint8_t>& content, std::uint32_t stack);
    void Add(Digest& to, std::uint32_t stack) const;

    void Flip(std::uint32_t address, std::uint32_t bit);
    /// @brief From now on this bit reads as `value`.
    void Stick(std::uint32_t address, std::uint32_t bit, bool value);
    [[nodiscard]] bool IsStuck() const
    {
        return stuck_at_ != 0U;
    }
    /// @brief The bit that is stuck is what it reads as.
    void Force();

    /// @brief Reads and writes are noted there; nullptr: not any more.
    void NoteIn(Accesses* accesses);
    /// @brief The place of this address in Accesses.
    [[nodiscard]] std::uint32_t PlaceOf(const std::uint32_t address) const
    {
        return address - layout_.begin;
    }
    void OnRead(std::uint32_t address, std::uint32_t bytes);
    void OnWrite(std::uint32_t address, std::uint32_t bytes);

    [[nodiscard]] std::array<ObjectPair, 3> Objects() const;
    void WriteObjects(std::uint32_t object, const ObjectPair& values);

  private:
    [[nodiscard]] std::uint8_t* At(const std::uint32_t address) const
    {
        return first_ + PlaceOf(address);
    }
    [[nodiscard]] bool Has(std::uint32_t address, std::uint32_t bytes) const;

    RamLayout layout_;
    std::uint32_t bytes_;
    std::uint32_t places_;
    std::uint8_t* first_;
    Accesses* noted_{nullptr};
    std::uint32_t stuck_at_{0U}; ///< 0: no bit is.
    std::uint8_t stuck_mask_{0U};
    std::uint8_t stuck_value_{0U};
};

} // namespace counterpoint::injection

#endif
