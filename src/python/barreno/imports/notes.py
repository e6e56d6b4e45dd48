# SPDX-License-Identifier: BSD-3-Clause
"""What is said of an import: each sentence once, with what it concerns and how often."""

NAMED = 3  # subjects that a sentence lists by name


class Notes:
    """Of three kinds: what carries over in another form, what is lost of the simulation, what has no effect on its answer."""

    def __init__(self):
        self.found, self.neutral = {}, []  # sentence: [lost, subjects, how often]

    def add(self, sentence, subject="", lost=False):
        """@param subject  what the sentence is about, in front of it"""
        kept = self.found.setdefault(sentence, [lost, [], 0])
        kept[0], kept[2] = kept[0] or lost, kept[2] + 1
        if subject and subject not in kept[1]:
            kept[1].append(subject)

    def lost(self, sentence, subject=""):
        """Something that moves, loads, breaks or ends the simulation."""
        self.add(sentence, subject, lost=True)

    def add_neutral(self, name):
        if name not in self.neutral:
            self.neutral.append(name)

    @property
    def count_lost(self):
        return sum(lost for lost, _, _ in self.found.values())

    @property
    def sentences(self):
        """Losses first."""
        ordered = sorted(self.found.items(), key=lambda item: not item[1][0])
        out = [with_subjects(sentence, subjects, count) for sentence, (_, subjects, count) in ordered]
        return out + ([f"Without effect on the answer, left out: {', '.join(self.neutral)}."] if self.neutral else [])


def with_subjects(sentence, subjects, count):
    if not subjects:
        return sentence if count == 1 else f"{sentence} ({count} times)"
    more = len(subjects) - NAMED
    names = ", ".join(subjects[:NAMED]) + (f" and {more} more" if more > 0 else "")
    return f"{names}: {sentence}" + (f" ({count} times)" if count > len(subjects) else "")
