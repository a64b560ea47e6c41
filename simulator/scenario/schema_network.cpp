// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/scenario/names.hpp"
#include "simulator/scenario/network_names.hpp"

// Scenarios with managers. An event or an expectation is a section named like its word. [SRS_MGR_012, SRS_SIM_047]
namespace counterpoint::simulator
{
namespace
{
using T = ValueType;
constexpr Range kNone{0U, 0U};
constexpr Range kNodes{1U, 127U};
constexpr Range kSrdos{1U, 64U};
constexpr Range kNumbers{0U, 0xFFFFFFFFU};
constexpr Range kIdentifiers{0U, 0x7FFU};

const KeySpec kDevice{"node", T::kNumber, kNodes, nullptr, nullptr, kNeeded, "33", "a device of the scenario"};
const KeySpec kSlave{"node",  T::kNumber, kNodes, nullptr,
                     nullptr, kNeeded,    "33",   "a node of the manager's network, or of the scenario"};
const KeySpec kOneManager{"node",  T::kNumber, kNodes, nullptr,
                          nullptr, nullptr,    "127",  "node-ID of a manager; default: the first one"};
const KeySpec kManager{"manager", T::kNumber, kNodes, nullptr,
                       nullptr,   nullptr,    "127",  "node-ID of the manager that is asked; default: the first one"};
const KeySpec kSrdo{"srdo",  T::kNumber, kSrdos, nullptr,
                    nullptr, "1",        "1",    "number of an SRDO that the device consumes"};
const KeySpec kEvery{"every", T::kLasting, kNone, nullptr, nullptr, "1 ms", "2 ms", "time between two frames"};
const KeySpec kUntil{"until", T::kDuration, kNone, nullptr, nullptr, kNeeded, "5 s", "when it is over"};
const KeySpec kBack{"until", T::kDuration, kNone, nullptr,
                    nullptr, kNeeded,      "5 s", "when it is back, within the scenario"};
const KeySpec kAt{"at",    T::kDuration, kNone, nullptr,
                  nullptr, nullptr,      "4 s", "when it is looked at; default: the end"};

SectionSpec Event(const char* const name, std::vector<KeySpec> keys, const char* const meaning)
{
    return {name, "an event", {"network.events"}, std::move(keys), meaning};
}

SectionSpec Expected(const char* const name, std::vector<KeySpec> keys, const char* const meaning)
{
    return {name, "an expectation", {"network.expect"}, std::move(keys), meaning};
}

KeySpec Is(std::string (*words)(), const char* const example, const char* const meaning)
{
    return {"is", T::kWord, kNone, words, nullptr, kNeeded, example, meaning};
}

KeySpec IsText(const char* const example, const char* const meaning)
{
    return {"is", T::kText, kNone, nullptr, nullptr, kNeeded, example, meaning};
}
} // namespace

namespace
{
const std::vector<SectionSpec> kNetworkSections{
    {"network",
     "a scenario of a network",
     {},
     {
         {"title", T::kText, kNone, nullptr, nullptr, kNeeded, "A slave is pulled", "shown to people"},
         {"description", T::kParagraph, kNone, nullptr, nullptr, nullptr, "It comes back.", "shown to people"},
         {"bitrate",
          T::kNumber,
          {10000U, 1000000U},
          nullptr,
          nullptr,
          "500000",
          "250000",
          "bit/s: 10000, 20000, 50000, 100000, 125000, 250000, 500000, 800000, 1000000"},
         {"duration", T::kLasting, kNone, nullptr, nullptr, kNeeded, "8 s", "simulated time"},
         {"managers", T::kMaps, kNone, nullptr, "network.managers", kNeeded, "[{network: chain.yaml}]",
          "network managers, one or more: the key that makes a file such a scenario"},
         {"devices", T::kMaps, kNone, nullptr, "network.devices", nullptr, "[{node: 33, dcf: actuator.dcf}]",
          "whole devices: kernel, channels and services"},
         {"events", T::kMaps, kNone, nullptr, "network.events", nullptr, "[{at: 3 s, do: pull, node: 33}]",
          "what happens to them"},
         {"expect", T::kMaps, kNone, nullptr, "network.expect", nullptr, "[{that: state, node: 33, is: operational}]",
          "what has to come out"},
     },
     "The whole file, when it has the key managers: a network of whole devices under the manager of docs/manager.md. "
     "Options other than --html, --json, --candump and --quiet are not for it."},
    {"network.managers",
     "a manager",
     {},
     {
         {"network", T::kText, kNone, nullptr, nullptr, kNeeded, "chain.yaml",
          "its network file, relative to this file"},
         {"node", T::kNumber, kNodes, nullptr, nullptr, nullptr, "126", "its node-ID instead of the file's"},
         {"at", T::kDuration, kNone, nullptr, nullptr, "0 s", "2 s", "when it is switched on"},
     },
     "A network manager; each has a node-ID of its own."},
    {"network.devices",
     "a device",
     {},
     {
         {"node", T::kNumber, kNodes, nullptr, nullptr, kNeeded, "33", "its node-ID, whatever the DCF says"},
         {"dcf", T::kText, kNone, nullptr, nullptr, kNeeded, "actuator.dcf", "what it is, relative to this file"},
         {"serial", T::kNumber, kNumbers, nullptr, nullptr, nullptr, "77", "1018h:04 instead of the DCF's"},
         {"at", T::kDuration, kNone, nullptr, nullptr, "0 s", "2 s", "when it is switched on"},
     },
     "A device of a DCF; each node-ID once."},
    {"network.events",
     "an event",
     {},
     {
         {"at", T::kDuration, kNone, nullptr, nullptr, kNeeded, "3 s", "when, before the end of the scenario"},
         {"do", T::kWord, kNone, &WordsOf<kNetworkActionWords>, nullptr, kNeeded, "pull", "what happens"},
     },
     "Every event; its other keys follow from what it does. One that would change nothing is refused: an insert of a "
     "device that is there, an order to a manager that is not."},
    Event("network.pull", {kDevice}, "The device disappears."),
    Event("network.insert", {kDevice}, "A device that was pulled comes back."),
    Event("network.reset", {kDevice}, "Its supply blinks; nobody commanded it."),
    Event("network.replace",
          {kDevice, {"serial", T::kNumber, kNumbers, nullptr, nullptr, kNeeded, "77", "1018h:04 of the other one"}},
          "Another device of its kind takes its place, also that of a pulled one."),
    Event("network.duplicate", {kDevice}, "A second device with its node-ID comes."),
    Event("network.store",
          {kDevice,
           {"object", T::kObject, kNone, nullptr, nullptr, kNeeded, "0x1017:00", "an object that the device has"},
           {"value", T::kNumber, kNumbers, nullptr, nullptr, kNeeded, "0", "what stands there from then on"}},
          "Somebody writes into the device, unseen by the manager."),
    Event("network.acknowledge", {kDevice, kSrdo}, "Its acknowledge input for this SRDO is pressed."),
    Event(
        "network.emcy_storm",
        {{"node", T::kNumber, kNodes, nullptr, nullptr, kNeeded, "2", "whose emergencies, whether it is there or not"},
         {"code", T::kNumber, {0U, 0xFFFFU}, nullptr, nullptr, "0x1000", "0x8130", "emergency error code"},
         kEvery,
         kUntil},
        "Emergency messages, one after the other."),
    Event("network.babble",
          {{"identifier", T::kNumber, kIdentifiers, nullptr, nullptr, kNeeded, "0x001", "COB-ID of the frames"},
           kEvery,
           kUntil},
          "A defective device sends frames of eight zeros."),
    Event("network.send",
          {{"identifier", T::kNumber, kIdentifiers, nullptr, nullptr, kNeeded, "0x000", "COB-ID of the frame"},
           {"data", T::kText, kNone, nullptr, nullptr, nullptr, "01 21", "up to 8 bytes of two hexadecimal digits"},
           {"every", T::kLasting, kNone, nullptr, nullptr, nullptr, "100 ms", "again each; with 'until'"},
           {"until", T::kDuration, kNone, nullptr, nullptr, nullptr, "5 s", "when it is over; with 'every'"}},
          "A frame of somebody else."),
    Event("network.order",
          {{"order", T::kText, kNone, nullptr, nullptr, kNeeded, "start 33", "an order of docs/manager.md that acts"},
           kOneManager},
          "An order to a manager."),
    Event("network.kill_manager",
          {{"node", T::kNumber, kNodes, nullptr, nullptr, kNeeded, "127", "node-ID of a manager"}},
          "It loses its supply for good."),
    Event("network.bus_off", {kOneManager, kBack}, "The controller of a manager is bus-off."),
    Event("network.no_controller", {kOneManager, kBack}, "The controller of a manager does not start."),
    {"network.expect",
     "an expectation",
     {},
     {
         {"that", T::kWord, kNone, &WordsOf<kNetworkExpectationWords>, nullptr, kNeeded, "state", "what is looked at"},
     },
     "Every expectation; its other keys follow from what it looks at. One that holds, or does not, whatever happens is "
     "refused."},
    Expected("network.state",
             {kSlave, Is(&WordsOf<kFoundStates>, "operational", "as the manager heard it last"), kAt, kManager},
             "The state of a node as the manager knows it."),
    Expected("network.device",
             {kDevice, Is(&WordsOf<kFoundDevices>, "operational", "as it is; absent: not there"), kAt},
             "The state of a device as it is."),
    Expected("network.letter", {kSlave, Is(&WordsOf<kFoundLetters>, "O", "the letter of CiA 302-2"), kAt, kManager},
             "How the start-up of a slave ended; profile cia302."),
    Expected("network.code", {kSlave, IsText("5", "a NodeState of el6751, an nStatus of plc_designer"), kAt, kManager},
             "The code of a slave; profiles el6751 and plc_designer."),
    Expected("network.gate", {kSlave, Is(&WordsOf<kFoundGates>, "open", "what the gate says"), kAt, kManager},
             "The verification of a safety slave."),
    Expected("network.finding",
             {kSlave, IsText("\"0x1018:04\"", "the object that is wrong; none: none is"), kAt, kManager},
             "What the start-up or the verification of a slave found."),
    Expected("network.output", {kDevice, Is(&WordsOf<kFoundOutputs>, "closed", "its output"), kSrdo, kAt},
             "The output of an SRDO that the device consumes."),
};
const std::vector<KeySpec> kEventKeys{
    Is(&WordsOf<kFoundEvents>, "boot_up", "the event, as in the log of docs/manager.md"),
    {"node", T::kNumber, kNodes, nullptr, nullptr, nullptr, "33", "of this node; default: of any"},
    {"from", T::kDuration, kNone, nullptr, nullptr, "0 s", "3 s", "not before"},
    {"until", T::kDuration, kNone, nullptr, nullptr, nullptr, "3300 ms", "not after; default: the end"},
    kManager};
} // namespace

std::vector<SectionSpec> NetworkSections()
{
    std::vector<SectionSpec> all = kNetworkSections;
    all.push_back(Expected("network.event", kEventKeys,
                           "The manager told such an event in this window; of guarding only for who is guarded."));
    all.push_back(Expected("network.no_event", kEventKeys,
                           "The manager told no such event in this window; of guarding only for who is guarded."));
    all.push_back(Expected("network.active",
                           {Is(&WordsOf<kYesWords>, "true", "whether it is the active master"), kAt, kManager},
                           "Whether a flying master commands the network; another manager does while it is there."));
    all.push_back(Expected("network.flying", {IsText("3 4", "numbers of its events so far, or none"), kAt, kManager},
                           "What the election told a flying master: 1 slave, 2 forces the negotiation, 3 begins it, 4 "
                           "master, 5 configuration error."));
    return all;
}
} // namespace counterpoint::simulator
