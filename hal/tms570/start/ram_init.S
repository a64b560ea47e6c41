@ Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
@
@ The RAM of the processor before its first use, in registers alone: tested by the memory test hardware (TRM "Programmable
@ Built-In Self-Test": march 13N for single-port memories), then written with zeroes and a right ECC by the hardware of the
@ system module (TRM "auto-initialisation of on-chip RAM": global key, memory 0, wait for the end, global key off). The clock
@ is the oscillator's. `pbist_ram_groups` is a constant of the variant (image.cmake). [SRS_FW_004, SRS_FW_019]
    .syntax unified
    .arch armv7-r
    .arm

    .equ .Lsystem, 0xFFFFFF00
    .equ .Lmstgcr, 0x58
    .equ .Lminitgcr, 0x5C
    .equ .Lmsinena, 0x60
    .equ .Lmstcgstat, 0x68
    .equ .Ltest_on, 0x10A              @ with the clock of its ROM halved
    .equ .Ltest_off, 0x105
    .equ .Lkey_on, 0xA
    .equ .Lkey_off, 0x5
    .equ .Lram, 1
    .equ .Ltested, 1 << 0
    .equ .Ldone, 1 << 8
    .equ .Lpbist, 0xFFFFE400
    .equ .Llogger, 0x164
    .equ .Lactive, 0x180
    .equ .Loverride, 0x188
    .equ .Lfail_0, 0x190
    .equ .Lfail_1, 0x194
    .equ .Lrom, 0x1C0
    .equ .Lalgorithm, 0x1C4
    .equ .Lgroups_low, 0x1C8
    .equ .Lgroups_high, 0x1CC
    .equ .Lclocks_on, 3
    .equ .Lmarch_single_port, 8
    .equ .Lfrom_rom, 0x14              @ written last: starts
    .equ .Lerror_key, 0xFFFFF538       @ ESMEKR; its key to force is the same
    .equ .Lsettle, 64                  @ cycles of the bus until the controller of the test is there
    .equ .Lmost_test_looks, 0x80000    @ at most 2.2 million cycles (LC43x: 512 KiB); a look takes six or more
    .equ .Lfewest_test_looks, 0x200
    .equ .Lmost_looks, 0x10000         @ the hardware takes one cycle for a word of 64 bits: 64 Ki of them at the most

    .section .text.start_up, "ax", %progbits
    .global HardwareInitialiseRam
    .type HardwareInitialiseRam, %function
HardwareInitialiseRam:
    ldr r1, =.Lsystem
    ldr r3, =pbist_ram_groups
    cmp r3, #0
    beq 4f                             @ a controller whose groups are not known

    movw r0, #.Ltest_off
    str r0, [r1, #.Lmstgcr]
    mov r0, #.Lkey_off
    str r0, [r1, #.Lminitgcr]
    mov r0, #.Ltested
    str r0, [r1, #.Lmstcgstat]         @ of an earlier test
    movw r0, #.Ltest_on
    str r0, [r1, #.Lmstgcr]
    mov r0, #1
    str r0, [r1, #.Lmsinena]
    mov r2, #.Lsettle
1:  subs r2, r2, #1
    bne 1b
    ldr r2, =.Lpbist
    mov r0, #.Lclocks_on
    str r0, [r2, #.Lactive]
    mov r0, #.Lmarch_single_port
    str r0, [r2, #.Lalgorithm]
    str r3, [r2, #.Lgroups_low]
    mov r0, #0
    str r0, [r2, #.Lgroups_high]
    str r0, [r2, #.Loverride]
    mov r0, #.Lclocks_on
    str r0, [r2, #.Lrom]
    mov r0, #.Lfrom_rom
    str r0, [r2, #.Llogger]
    mov r3, #0
2:  ldr r0, [r1, #.Lmstcgstat]
    ands r0, r0, #.Ltested
    bne 3f
    add r3, r3, #1
    cmp r3, #.Lmost_test_looks
    bne 2b
3:  cmp r3, #.Lfewest_test_looks
    movlo r0, #0                       @ nothing was tested: its ROM was not ready (erratum PBIST#4 of older silicon)
    ldr r3, [r2, #.Lfail_0]
    cmp r3, #0
    movne r0, #0
    ldr r3, [r2, #.Lfail_1]
    cmp r3, #0
    movne r0, #0
    mov r3, #0
    str r3, [r2, #.Lactive]
    movw r3, #.Ltest_off
    str r3, [r1, #.Lmstgcr]
    cmp r0, #0                         @ 0: a defect, no end, or no test
    beq 7f

4:  mov r0, #.Lkey_on
    str r0, [r1, #.Lminitgcr]
    mov r0, #.Lram
    str r0, [r1, #.Lmsinena]
    ldr r2, =.Lmost_looks
5:  ldr r0, [r1, #.Lmstcgstat]
    ands r0, r0, #.Ldone
    bne 6f
    subs r2, r2, #1
    bne 5b
6:  mov r3, #.Lkey_off
    str r3, [r1, #.Lminitgcr]
    cmp r0, #0
    bne 8f
7:  ldr r1, =.Lerror_key               @ the caller stands still then: nERROR low, or nobody outside would know
    mov r2, #.Lkey_on
    str r2, [r1]
8:  bx lr                              @ r0: 0 if a test found a defect or a look was in vain to the last
    .size HardwareInitialiseRam, . - HardwareInitialiseRam
    .ltorg
    .section .note.GNU-stack, "", %progbits
    .end
