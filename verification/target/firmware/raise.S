@ Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
@
@ std::uint32_t RaiseInterrupt(), RaiseFastInterrupt(): enters a handler of start_up.S as the processor does for an
@ interrupt. 1 if every register that an interrupted program may use is what it was.
    .syntax unified
    .arch armv7-r
    .fpu vfpv3-d16
    .arm
    .section .text.raise, "ax", %progbits

    .macro raise name, mode, handler
    .global \name
    .type \name, %function
\name:
    push {r3-r11, lr}
    vpush {d8-d15}
    mrs r4, cpsr
    ldr r5, =1f + 4                    @ where the program would have gone on, and one instruction more
    cps #\mode
    msr spsr_cxsf, r4
    mov lr, r5
    ldr r6, =0x01234567
    mvn r7, r6
    vmov d0, r6, r7
    vmov d7, r7, r6
    mov r0, r6
    mov r1, r7
    mov r2, r6
    mov r3, r7
    mov r12, r6
    b \handler
1:  mrs r8, cpsr
    eor r9, r4, r8
    bic r9, r9, #0xF0000000            @ conditions
    eor r10, r0, r6
    orr r9, r9, r10
    eor r10, r1, r7
    orr r9, r9, r10
    eor r10, r2, r6
    orr r9, r9, r10
    eor r10, r3, r7
    orr r9, r9, r10
    eor r10, r12, r6
    orr r9, r9, r10
    vmov r0, r1, d0
    vmov r2, r3, d7
    eor r10, r0, r6
    orr r9, r9, r10
    eor r10, r1, r7
    orr r9, r9, r10
    eor r10, r2, r7
    orr r9, r9, r10
    eor r10, r3, r6
    orr r9, r9, r10
    cmp r9, #0
    moveq r0, #1
    movne r0, #0
    vpop {d8-d15}
    pop {r3-r11, pc}
    .size \name, . - \name
    .endm

    raise RaiseInterrupt, 0x12, Interrupt
    raise RaiseFastInterrupt, 0x11, FastInterrupt
    .ltorg
    .section .note.GNU-stack, "", %progbits
    .end
