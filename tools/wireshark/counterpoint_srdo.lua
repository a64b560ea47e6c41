-- Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
-- Wireshark dissector for CANopen Safety (EN 50325-5): SRDO frames 101h to 180h and the global fail-safe command 001h on
-- SocketCAN captures. Install: copy into the folder of personal Lua plugins (Help, About, Folders), or
-- `tshark -X lua_script:counterpoint_srdo.lua`. All other frames stay with their dissectors, CANopen's among them.

local srdo = Proto("srdo", "CANopen Safety SRDO")
local gfc = Proto("gfc", "CANopen Safety GFC")

local FIRST_ID, LAST_ID, GFC_ID = 0x101, 0x180, 0x001
local NORMAL, INVERSE = 0, 1

local f = {
    number = ProtoField.uint8("srdo.number", "Number of the pair of identifiers", base.DEC),
    half = ProtoField.uint8("srdo.half", "Half", base.DEC, { [NORMAL] = "normal", [INVERSE] = "inverse" }),
    data = ProtoField.bytes("srdo.data", "Data"),
    partner = ProtoField.framenum("srdo.partner", "Other frame of the pair", base.NONE),
    inverted = ProtoField.bool("srdo.inverted", "Each bit is inverted"),
    srvt = ProtoField.double("srdo.srvt_ms", "Time from normal to inverse frame [ms]"),
    cycle = ProtoField.double("srdo.cycle_ms", "Time since the normal frame of the last valid pair [ms]"),
    valid = ProtoField.bool("srdo.valid", "Valid pair"),
    violation = ProtoField.string("srdo.violation", "Violation"),
}
srdo.fields = { f.number, f.half, f.data, f.partner, f.inverted, f.srvt, f.cycle, f.valid, f.violation }

local e_violation = ProtoExpert.new("srdo.expert", "SRDO violation", expert.group.PROTOCOL, expert.severity.ERROR)
srdo.experts = { e_violation }
gfc.fields = {}

srdo.prefs.srvt = Pref.uint("SRVT [ms]", 20, "Greatest time from normal to inverse frame; 0: not judged")
srdo.prefs.sct = Pref.uint("SCT [ms]", 0, "Greatest time from normal to normal frame; 0: not judged")
srdo.prefs.pairs = Pref.string("SCT/SRVT of single pairs", "",
    "By the identifier of the normal frame, in ms: 101:50/20 103:25/10")

local can_id = Field.new("can.id")
local can_remote = Field.new("can.flags.rtr")
local can_fd = Field.new("canfd.flags.brs") -- Every CAN FD frame has this flag, set or not, and no other frame.
local interface_name = Field.new("frame.interface_name")
local interface_index = Field.new("sll.ifindex") -- Of a capture of all interfaces (SLL2).

-- What is known about frames, by their number in the capture: filled while the capture is read for the first time.
local results = {}
-- By interface and number of the pair: the normal frame that waits for its inverse (pending), the time of the last valid pair (last),
-- whether nothing was wrong since (held: SCT is judged), whether an inverse frame of a discarded pair may come (remainder), whether
-- there was a frame before (is_begun).
local states = {}

function srdo.init()
    results = {}
    states = {}
end

-- Limits in milliseconds, 0 where there is none.
local function limits(number)
    local sct, srvt = srdo.prefs.sct, srdo.prefs.srvt
    for id, own_sct, own_srvt in srdo.prefs.pairs:gmatch("(%x+):(%d+)/(%d+)") do
        if tonumber(id, 16) == FIRST_ID + 2 * (number - 1) then
            sct, srvt = tonumber(own_sct), tonumber(own_srvt)
        end
    end
    return sct, srvt
end

-- Whether each bit of one string is inverted in the other, which is as long.
local function is_inverse(left, right)
    for place = 1, #left do
        if left:byte(place) + right:byte(place) ~= 0xFF then
            return false
        end
    end
    return true
end

-- Times are compared in whole microseconds: a limit itself is kept.
local function microseconds(time)
    -- As text a time of today would have lost all but four of its decimals.
    if type(time) ~= "number" then
        time = time.secs + time.nsecs / 1000000000
    end
    return math.floor(time * 1000000 + 0.5)
end

local function note(result, text)
    table.insert(result.violations, text)
end

-- Whatever frame comes behind it: SCT was over before.
local function judge_sct(state, result, frame, sct)
    local cycle = state.last and frame.time - state.last or 0
    if state.held and sct > 0 and cycle > sct * 1000 then
        note(result, string.format("SCT: %.3f ms since the last valid pair, limit %d ms", cycle / 1000, sct))
    end
end

local function take_normal(state, result, frame, sct)
    state.is_begun = true
    if state.last then
        result.cycle = (frame.time - state.last) / 1000
    end
    judge_sct(state, result, frame, sct)
    if #frame.data == 0 then
        note(result, "length: no data")
        state.pending = nil
        state.remainder = true
    elseif state.pending then
        note(result, string.format("normal twice: no inverse frame since frame %d", state.pending.number))
        state.pending = nil
        state.remainder = true
    else
        state.pending = frame
        state.remainder = false
    end
end

local function take_inverse(state, result, frame, sct, srvt)
    local normal = state.pending
    state.pending = nil
    -- The capture may begin within a pair.
    local is_cut = not state.is_begun and frame.since_begin <= srvt * 1000
    state.is_begun = true
    if not normal then
        judge_sct(state, result, frame, sct)
        if not state.remainder and not is_cut then
            note(result, "inverse first: no normal frame before it")
        end
        state.remainder = false
        return
    end
    local time = frame.time - normal.time
    result.partner, result.srvt = normal.number, time / 1000
    results[normal.number].partner = frame.number
    if #normal.data ~= #frame.data then
        note(result, string.format("length: %d bytes, the normal frame has %d", #frame.data, #normal.data))
    else
        result.inverted = is_inverse(normal.data, frame.data)
        if not result.inverted then
            note(result, "not inverse")
        end
    end
    if time < 0 then
        note(result, "its time is before that of the normal frame")
    elseif srvt > 0 and time > srvt * 1000 then
        note(result, string.format("SRVT: %.3f ms after the normal frame, limit %d ms", time / 1000, srvt))
    end
    result.valid = #result.violations == 0
    results[normal.number].valid = result.valid
    if result.valid then
        state.last = normal.time
        state.held = true
    end
end

-- The bus that a frame is of: pairs of two interfaces have nothing to do with each other.
local function bus_of_frame()
    local name, index = interface_name(), interface_index()
    return (name and tostring(name.value) or "") .. "/" .. (index and tostring(index.value) or "")
end

-- Once for each frame, in the order of the capture.
local function analyse(number, half, frame)
    local key = bus_of_frame() .. "/" .. number
    local state = states[key] or {}
    states[key] = state
    local result = { violations = {} }
    results[frame.number] = result
    local sct, srvt = limits(number)
    -- A normal frame whose SRVT is over does not wait any longer.
    if not frame.is_remote and state.pending and srvt > 0 and half == NORMAL and frame.time - state.pending.time > srvt * 1000 then
        note(result, string.format("SRVT: no inverse frame within %d ms after frame %d", srvt, state.pending.number))
        state.pending = nil
    end
    if frame.is_remote then
        note(result, "remote frame: nobody counts it")
        return
    end
    if half == NORMAL then
        take_normal(state, result, frame, sct)
    else
        take_inverse(state, result, frame, sct, srvt)
    end
    state.held = state.held and #result.violations == 0
end

local function show(tree, result)
    if result.partner then
        tree:add(f.partner, result.partner):set_generated()
    end
    for _, name in ipairs({ "inverted", "srvt", "cycle", "valid" }) do
        if result[name] ~= nil then
            tree:add(f[name], result[name]):set_generated()
        end
    end
    for _, text in ipairs(result.violations) do
        tree:add(f.violation, text):set_generated():add_proto_expert_info(e_violation, text)
    end
end

function srdo.dissector(buffer, pinfo, root)
    if can_fd() ~= nil then
        return 0 -- A CAN FD frame never counts.
    end
    local id = can_id().value
    local number = math.floor((id - FIRST_ID) / 2) + 1
    local half = (id - FIRST_ID) % 2
    local flag = can_remote()
    local is_remote = flag ~= nil and flag.value
    if not pinfo.visited then
        analyse(number, half, {
            number = pinfo.number, time = microseconds(pinfo.abs_ts), since_begin = microseconds(pinfo.rel_ts),
            data = buffer:raw(), is_remote = is_remote })
    end
    local result = results[pinfo.number] or { violations = {} }
    local tree = root:add(srdo, buffer())
    tree:add(f.number, number):set_generated()
    tree:add(f.half, half):set_generated()
    if buffer:len() > 0 then
        tree:add(f.data, buffer())
    end
    show(tree, result)
    local name = half == NORMAL and "normal" or "inverse"
    local text = string.format("SRDO %03Xh %s", id, name)
    if result.srvt then
        text = text .. string.format(" of frame %d, %.3f ms", result.partner, result.srvt)
    end
    for _, violation in ipairs(result.violations) do
        text = text .. " [" .. violation .. "]"
    end
    pinfo.cols.protocol = "SRDO"
    pinfo.cols.info = text
    tree:append_text(string.format(" %03Xh, %s", id, name))
    return buffer:len()
end

-- Only a plain frame without data is the command.
function gfc.dissector(buffer, pinfo, root)
    local remote = can_remote()
    if buffer:len() > 0 or can_fd() ~= nil or (remote ~= nil and remote.value) then
        return 0
    end
    root:add(gfc, buffer())
    pinfo.cols.protocol = "GFC"
    pinfo.cols.info = "Global fail-safe command"
    return 0
end

local can_ids = DissectorTable.get("can.id")
for id = FIRST_ID, LAST_ID do
    can_ids:add(id, srdo)
end
can_ids:add(GFC_ID, gfc)
