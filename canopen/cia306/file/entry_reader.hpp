// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_FILE_ENTRY_READER_HPP
#define CANOPEN_CIA306_FILE_ENTRY_READER_HPP

#include "canopen/cia306/file/device.hpp"
#include "canopen/cia306/text/ini_document.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace counterpoint::cia306
{
/// Reads the keys of one section; every refusal names file and line.
class SectionReader
{
  public:
    /// All of them outlive it; warnings are added to `warnings`.
    SectionReader(const std::string& file, const IniSection& section, std::vector<Finding>& warnings) noexcept;

    /// The key of a number or word; null where it is missing or empty. A comment behind its value is told.
    [[nodiscard]] const IniKey* Find(std::string_view key) const;
    /// The number at `key`, nothing where the key is missing or empty. Throws InputError where it is none or above max.
    [[nodiscard]] std::optional<std::uint64_t> NumberAt(std::string_view key, std::uint64_t max) const;
    /// The flag (0 or 1) at `key`; nothing where the key is missing or empty.
    [[nodiscard]] std::optional<bool> FlagAt(std::string_view key) const;
    /// The text at `key` and its line.
    [[nodiscard]] Text TextAt(std::string_view key) const;
    /// The place of the value at `key`; of the section where the key is missing or empty. [SRS_EDS_036]
    [[nodiscard]] Place PlaceAt(std::string_view key) const;
    /// The object type at `key`; a variable where the key is missing or empty.
    [[nodiscard]] ObjectType ObjectTypeAt(std::string_view key) const;
    /// The access right at `key`; kUnknown where the key is missing or empty.
    [[nodiscard]] Access AccessAt(std::string_view key) const;
    /// Whether ObjFlags say that a download of the configuration leaves it alone (bit 0). [SRS_MGR_322]
    [[nodiscard]] bool IsDownloadRefused() const;
    /// Everything that says something about the data element.
    [[nodiscard]] Entry ReadEntry(std::uint16_t index, std::uint8_t sub) const;

    /// Warns of each key that is none of these and near to one of them. [SRS_EDS_037]
    void WarnOfSlips(const std::vector<std::string>& known) const;

    /// Throws InputError for the value of this key.
    [[noreturn]] void Refuse(const IniKey& key, const std::string& expected) const;

  private:
    void ReadInvertedSrad(Entry& entry) const;

    const std::string* file_;
    const IniSection* section_;
    std::vector<Finding>* warnings_;
};

/// Takes comments behind the values and limits away and tells them, unless the type is one of text or not known: there
/// '#' and ';' belong to the value. [SRS_EDS_035]
void LeaveOutComments(Entry& entry, std::vector<Finding>& warnings);

/// A safety object of the device is no variable of its application: where the file lets it be mapped by an SRDO, it is
/// taken as one that cannot, and that is told. [SRS_EDS_555, SRS_EDS_730]
void LeaveOutOfSrdos(Entry& entry, std::vector<Finding>& warnings);

/// Warns of what files in use often have wrong: no type, no access, values that do not fit.
void WarnOfEntry(const Entry& entry, std::vector<Finding>& warnings);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_FILE_ENTRY_READER_HPP
