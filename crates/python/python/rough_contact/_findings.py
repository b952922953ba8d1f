"""Findings: what may change a conclusion, as the command and the report say it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from html import escape
from typing import Any


@dataclass(frozen=True)
class Finding:
    """What may change a conclusion.

    Attributes
    ----------
    weight : str
        ``'check'``, it may change a conclusion; ``'note'``; ``'passed'``.
    subject : str
        What it is about.
    claim, text : str
        It in words.
    fact : object
        The same as data, as in the JSON.
    """

    weight: str
    subject: str
    claim: str
    text: str
    fact: Any

    @classmethod
    def _of(cls, json: dict[str, Any]) -> Finding:
        return cls(json["weight"], json["subject"], json["claim"], json["text"], json["fact"])

    def __str__(self) -> str:
        return f"{self.weight}: {self.claim} {self.text}".strip()


def findings_html(findings: Sequence[Finding]) -> str:
    """The findings that are open, as a list."""
    lines = [
        f"<li><b>{escape(f.weight)}: {escape(f.claim)}</b> {escape(f.text)}</li>"
        for f in findings
        if f.weight != "passed"
    ]
    return f"<ul>{''.join(lines)}</ul>" if lines else ""
