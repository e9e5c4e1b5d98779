# SPDX-License-Identifier: MIT
"""What a solve or a reference raises that did not come to its end, and what it warns of."""

from __future__ import annotations


class NumericalFailure(RuntimeError):
    """A scheme or a reference that did not come to its end.

    The message names the scheme, the step and the time. Of a solve that stopped at a step they are attributes, too;
    otherwise these are None.
    """

    scheme: str | None
    step: int | None
    time: float | None

    def __init__(self, message: str, scheme: str | None = None, step: int | None = None, time: float | None = None):
        super().__init__(message)
        self.scheme, self.step, self.time = scheme, step, time


class DoubtfulResult(UserWarning):
    """Numbers of a solve that deserve distrust; the text says why. ``fdebench solve`` prints the same."""
