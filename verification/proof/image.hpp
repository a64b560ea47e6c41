// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_PROOF_IMAGE_HPP
#define VERIFICATION_PROOF_IMAGE_HPP

#include "verification/proof/world.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::proof
{

/// 128 bits: among 10^8 states the chance that two share one is below 10^-22.
using Key = std::array<std::uint64_t, 2U>;

/// What makes two states one.
enum class Sight : std::uint8_t
{
    kBytes, ///< All bytes are alike, times as ages.
    kShown, ///< All that is shown is alike, and model and witness stand alike.
};

/// A state, and something that tells two of one key apart.
struct Marked
{
    Key key;
    std::uint64_t mark;
};

/// Makes the key of a state. By its bytes: every byte of both channels, their storage and the objects, and all of model
/// and witness; but times count as ages, cut where every limit has passed, and what only counts is left out or cut.
/// Which words these are is found by running the channels, not by reading them: an instant is what moves with the
/// counter's start, a counter what is equal to what is shown. By what is shown: the same without the bytes of channels
/// and storage.
class Image
{
  public:
    /// @brief Drives the world through a few thousand letters, twice. Empty, or why the words cannot be told apart.
    [[nodiscard]] std::string Learn(World& world, const std::vector<Letter>& letters, std::uint32_t base_us);
    [[nodiscard]] Marked MarkedOf(const World& world, Sight sight);
    /// @brief How many words count as ages, and how many bytes are counters.
    [[nodiscard]] std::string Summary() const;

  private:
    enum class Rule : std::uint8_t
    {
        kAsItIs,
        kInstant, ///< Its age.
        kElapsed, ///< Cut.
        kBudget,  ///< One value once it is below zero.
        kOrdinal, ///< Whether it is 0.
        kLeftOut,
    };

    void Read(const World& world);
    void AddBytes(std::uint32_t now_us);
    void AddShown(const World& world);
    void Collect(const World& world);
    void NarrowDown(const World& world);
    [[nodiscard]] std::uint32_t Word(std::size_t word) const;

    std::vector<std::uint8_t> bytes_;
    std::vector<Rule> rules_;
    std::vector<std::size_t> half_words_; ///< Where the error counts are.
    std::vector<std::uint32_t> key_;

    // While it learns: words that may still be what they seem.
    std::vector<bool> cycles_;
    std::vector<bool> ordinals_;
    std::vector<bool> elapsed_;
    std::vector<bool> errors_;
};

} // namespace counterpoint::proof

#endif
