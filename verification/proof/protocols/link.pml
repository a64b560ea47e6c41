/* Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0

   The supervision of the cross link on one CPU. The other CPU and the wire are everything that causality allows: any message
   that the other one may ever have composed comes at any time, any number of times, in any order, or never; and messages that
   are damaged or of another sender. Written from SRS_LNK_002 to SRS_LNK_006, SRS_LNK_011 and decision 0005.

   Time goes in cycles. The own message of a cycle has the cycle as its number and stamp. A message that comes was composed
   `c` cycles ago, echoes the own message of `e` cycles ago, and held that for `h` cycles. Time-out: 3 cycles. Each state lets in 86 inputs. */

#define TIMEOUT 3
#define OLDEST 5 /* No message is older. What is older still in the state is OLDEST + 1. */

#define LOST 0
#define WAITING 1
#define ALIVE 2

/* State. */
byte state = WAITING; /* as behind a start */
bool heard;     /* something of the other CPU since the start */
byte heard_age; /* cycles since the newest message heard was composed */
byte echoed;    /* cycles since the own message that the message taken last answers */
byte composed;  /* own messages since the start */

/* Observers. */
byte voice;     /* cycles since the message taken last was really composed */
byte started;   /* cycles since the start */
bool steady;    /* since contact each cycle brought an answer to the own message of two cycles ago */
bool answered;  /* in this cycle */

/* What comes; 0 between two steps. Not hidden: the verifier would not restore them between two choices. */
byte c, e, h, has_echo, sender;
hidden byte result, b_state, b_heard, b_heard_age, b_echoed, b_composed, is_next, is_fresh;

#define CYCLE 0
#define MESSAGE 1
#define START 2

/* What became of the message. */
#define NONE 0
#define TAKEN 1
#define REPEATED 2
#define OLD 3
#define LATE 4
#define CORRUPT 5

inline Older(age, limit)
{
    if :: age < limit -> age = age + 1 :: else -> skip fi
}

inline Keep()
{
    b_state = state; b_heard = heard; b_heard_age = heard_age; b_echoed = echoed; b_composed = composed; result = NONE
}

inline Tell(act)
{
    printf("T %d %d %d %d %d | %d %d %d %d %d %d | %d %d %d %d %d | %d %d %d %d\n",
        b_state, b_heard, b_heard_age, b_echoed, b_composed, act, c, e, h, has_echo, sender,
        state, heard, heard_age, echoed, composed, state, result, heard, (heard && (heard_age <= OLDEST) -> heard_age : 99))
}

inline Take()
{
    is_next = ((state == WAITING) || (c < heard_age));
    is_fresh = (has_echo && (e <= TIMEOUT) && (h <= e) && ((state != WAITING) || (e <= composed)));
#ifdef PLANTED_NO_ECHO
    is_fresh = has_echo;
#endif
#ifdef PLANTED_NO_SEQUENCE
    is_next = true;
#endif
#ifdef PLANTED_ANY_START
    is_fresh = (has_echo && (e <= TIMEOUT) && (h <= e));
#endif
    if
    :: !is_next && (c == heard_age) -> result = REPEATED
    :: !is_next && (c != heard_age) -> result = OLD
    :: is_next && !is_fresh -> result = LATE
    :: else -> result = TAKEN
    fi;
    /* Nothing is taken twice or behind a newer one, nothing that was said longer ago than the time-out, and contact does not
       begin by what was said before this start. */
    assert((result != TAKEN) || (state == WAITING) || (c < voice));
    assert((result != TAKEN) || (c <= TIMEOUT));
    assert((result != TAKEN) || (state != WAITING) || (c <= started));
    if
    :: is_next ->
        heard = true; heard_age = c;
        if
        :: is_fresh ->
            echoed = e; voice = c;
            answered = (answered || (e <= 2));
            if :: state == WAITING -> state = ALIVE; steady = true :: else -> skip fi
        :: else -> skip
        fi
    :: else -> skip
    fi
}

inline Cycle()
{
    steady = (steady && answered);
    answered = false;
#ifdef PLANTED_LATE_EXAMINE
    if :: (state == ALIVE) && (echoed > TIMEOUT + 1) -> state = LOST :: else -> skip fi;
#else
    if :: (state == ALIVE) && (echoed > TIMEOUT) -> state = LOST :: else -> skip fi;
#endif
    /* The voice that counts is never older than the time-out; a link that answers each cycle is never lost. */
    assert((state != ALIVE) || (voice <= TIMEOUT));
    assert(!steady || (state == ALIVE));
    Older(composed, OLDEST + 1); Older(started, OLDEST + 1);
    Older(voice, OLDEST + 1); Older(echoed, OLDEST + 1);
    if :: heard -> Older(heard_age, OLDEST + 1) :: else -> skip fi
}

inline Forget()
{
    c = 0; e = 0; h = 0; has_echo = 0; sender = 0
}

active proctype Cpu()
{
    do
    :: d_step { Keep(); Cycle(); assert((b_state != LOST) || (state == LOST)); Tell(CYCLE) }
    :: atomic { /* A message of the peer. It was composed behind the own message that it echoes, and held that since then at most. */
        if :: has_echo = 1 :: has_echo = 0 fi;
        select(c : 0 .. OLDEST);
        if
        :: has_echo -> select(e : 1 .. OLDEST); select(h : 0 .. (OLDEST + 1))
        :: else -> skip
        fi;
        if
        :: has_echo && ((c > e) || ((h > e - c) && (h != e + 1))) ->
            d_step { Forget() } /* Nobody could say this; more hold than time is a lie that is tried. */
        :: else ->
            d_step { Keep(); Take(); assert((b_state != LOST) || (state == LOST)); Tell(MESSAGE); Forget() }
        fi
    }
    :: atomic { /* Damaged, of another role, of another node: no effect. */
        e = 1; has_echo = 1;
        select(sender : 1 .. 3);
        d_step { Keep(); result = CORRUPT; Tell(MESSAGE); Forget() }
    }
    :: d_step {
        Keep();
        state = WAITING; heard = false; heard_age = 0; echoed = 0; composed = 0;
        voice = 0; started = 0; steady = false; answered = false;
        Tell(START)
    }
    od
}
