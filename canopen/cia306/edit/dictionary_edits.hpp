// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_EDIT_DICTIONARY_EDITS_HPP
#define CANOPEN_CIA306_EDIT_DICTIONARY_EDITS_HPP

#include "canopen/cia306/file/device.hpp"
#include "canopen/cia306/text/ini_document.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace counterpoint::cia306
{
/// Keys of a section with their values, in the order of the file.
using SectionKeys = std::vector<std::pair<std::string, std::string>>;

/// A data element that a file is to get.
struct NewEntry
{
    std::uint8_t sub{0U};
    std::string name;
    std::uint16_t data_type{kUnsigned8};
    std::string access{"rw"};
    std::string default_value;
    std::string parameter_value{}; ///< Empty: none.
    SectionKeys more{};            ///< What stands behind PDOMapping.
};

/// An object that a file is to get. One of type kVar has one entry, others have them in the order of the sub-indices; a
/// sub-index 0 that is not among them is made from the greatest one.
struct NewObject
{
    std::uint16_t index{0U};
    std::string name;
    ObjectType type{ObjectType::kVar};
    std::vector<NewEntry> entries;
};

/// "1301" or "1301subA", as sections are named.
[[nodiscard]] std::string SectionOf(std::uint16_t index);
[[nodiscard]] std::string SectionOf(std::uint16_t index, std::uint8_t sub);

/// The sections of an object: by name, in the order of the file.
[[nodiscard]] std::vector<std::pair<std::string, SectionKeys>> SectionsOf(const NewObject& object);

/// The sections of the document that describe an object of it: head, sub-indices, names, values and the like.
[[nodiscard]] std::vector<std::string> SectionsIn(const IniDocument& document, const Object& object);

/// Objects and sub-indices to be added to a file, each behind what stands before it by index. Nothing else of the file
/// changes but its lists and counts. [SRS_NEW_011]
class DictionaryEdits
{
  public:
    /// Both live longer; the device was read from the document.
    DictionaryEdits(const IniDocument& document, const Device& device) noexcept;

    /// Whether the file has no such object, lists none, and gets none.
    [[nodiscard]] bool IsFree(std::uint16_t index) const;
    /// Adds an object; its index is free.
    void Add(const NewObject& object);
    /// Adds a sub-index to an array, and the array where there is none; what is there stays. Once for an array.
    void Ensure(std::uint16_t index, const std::string& name, const NewEntry& entry);
    /// Sets a key of a section that exists.
    void Set(const std::string& section, const std::string& key, const std::string& value);
    /// The document with all of that.
    [[nodiscard]] IniDocument Apply() const;

  private:
    [[nodiscard]] std::string LastSectionOf(const Object& object) const;
    [[nodiscard]] std::string PlaceOf(std::uint16_t index) const;
    void AddSub(const Object& array, const NewEntry& entry);
    void AddToLists(std::vector<KeyEdit>& keys, std::vector<SectionEdit>& sections) const;

    const IniDocument& document_;
    const Device& device_;
    std::vector<KeyEdit> keys_;
    std::map<std::uint16_t, std::vector<SectionEdit>> sections_; ///< By index: those of one place stand in this order.
    std::vector<std::uint16_t> added_;                           ///< Objects that the lists have to name.
};
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_EDIT_DICTIONARY_EDITS_HPP
