"""Damaged files from good ones, the same for the same seed: bytes changed, removed, repeated, moved, or taken from another file;
extreme numbers; truncation."""

import random
import re

NUMBERS = [b"0", b"-1", b"1e308", b"-1e-320", b"nan", b"inf", b"4294967296", b"99999999999999999999", b"0x7f", b""]
WORDS = [bytes(4), b"\xff" * 4, b"\xff\xff\xff\x7f", b"\0\0\0\x80", b"\1\0\0\0", b"\xff" * 8, b"\0\0\0\0\1\0\0\0"]


def change_bytes(rng, data, _):
    for _ in range(rng.choice((1, 1, 2, 8))):
        data[rng.randrange(len(data))] = rng.randrange(256)


def flip_bit(rng, data, _):
    data[rng.randrange(len(data))] ^= 1 << rng.randrange(8)


def span(rng, data):
    start = rng.randrange(len(data))
    return start, min(len(data), start + rng.choice((1, 2, 4, 16, 64, 256)))


def leave_out(rng, data, _):
    start, end = span(rng, data)
    del data[start:end]


def repeat(rng, data, _):
    start, end = span(rng, data)
    data[start:start] = data[start:end] * rng.choice((1, 2, 50))


def move(rng, data, _):
    start, end = span(rng, data)
    piece = data[start:end]
    del data[start:end]
    to = rng.randrange(len(data) + 1)
    data[to:to] = piece


def cut_off(rng, data, _):
    del data[rng.randrange(len(data)):]


def take_from_another(rng, data, others):
    other = rng.choice(others)
    if other:
        start, end = span(rng, other)
        to = rng.randrange(len(data))
        data[to:to + rng.choice((0, end - start))] = other[start:end]


def make_number_extreme(rng, data, _):
    numbers = list(re.finditer(rb"-?\d+(\.\d+)?", data))
    if numbers:
        place = rng.choice(numbers)
        data[place.start():place.end()] = rng.choice(NUMBERS)


def make_word_extreme(rng, data, _):
    start = rng.randrange(len(data))
    word = rng.choice(WORDS)
    data[start:start + len(word)] = word


WAYS = [change_bytes, flip_bit, leave_out, repeat, move, cut_off, take_from_another, make_number_extreme, make_word_extreme]
LARGEST = 16384  # [bytes], as in scripts/fuzz.sh


def damaged(seeds, count, seed):
    """`count` files: the good ones first, then each a good one damaged in one to four ways."""
    rng = random.Random(seed)
    yield from seeds[:count]
    for _ in range(count - len(seeds)):
        data = bytearray(rng.choice(seeds))
        for _ in range(rng.choice((1, 1, 2, 4))):
            if data:
                rng.choice(WAYS)(rng, data, seeds)
        yield bytes(data[:LARGEST])
