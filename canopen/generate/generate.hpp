// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_GENERATE_GENERATE_HPP
#define CANOPEN_GENERATE_GENERATE_HPP

#include "canopen/cia306/file/device.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace counterpoint::generate
{
constexpr const char* kHeaderName = "object_dictionary.hpp";
constexpr const char* kSourceName = "object_dictionary.cpp";

/// What the command line says about the generated code.
struct GenerateOptions
{
    std::string name_space; ///< Checked by ProblemOfNamespace.
    std::optional<std::uint8_t> node_id;
};

/// The two files, and what is told about them.
struct GeneratedCode
{
    std::string header;
    std::string source;
    std::size_t entry_count{0U};    ///< Entries of the table.
    std::size_t variable_count{0U}; ///< Variables that the kernel maps.
    std::size_t srdo_count{0U};
    std::size_t stored_bytes{0U};
    std::size_t constant_bytes{0U};
    std::vector<cia306::Finding> warnings; ///< Beyond those of the check.
};

/// The code of a device. `text` is that of the file, for its CRC. Throws InputError for what cannot be generated.
/// [SRS_GEN_001, SRS_GEN_003, SRS_GEN_004, SRS_GEN_005, SRS_GEN_006, SRS_GEN_007, SRS_GEN_008, SRS_GEN_009,
/// SRS_GEN_010, SRS_GEN_011, SRS_GEN_012, SRS_GEN_013, SRS_GEN_014]
[[nodiscard]] GeneratedCode Generate(const cia306::Device& device, std::string_view text,
                                     const GenerateOptions& options);

/// Whether Generate made this text, in whatever version. [SRS_GEN_018]
[[nodiscard]] bool IsGenerated(std::string_view text) noexcept;

/// What is wrong with the name of a namespace (`a::b` is one); empty: nothing. [SRS_GEN_003]
[[nodiscard]] std::string ProblemOfNamespace(const std::string& name);

/// The name of a namespace made from the name of a file. [SRS_GEN_012]
[[nodiscard]] std::string NamespaceOf(const std::string& file);
} // namespace counterpoint::generate

#endif // CANOPEN_GENERATE_GENERATE_HPP
