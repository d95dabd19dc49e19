"""The exception of the package, and what it carries."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Optional


@dataclass(frozen=True)
class Diagnostic:
    """Something that went wrong or fell short, and what it is about."""

    code: str
    """"stage.what", stable across versions, such as "read.truncated"."""
    severity: str
    """"note", "warning" or "error"."""
    face: Optional[int]
    """1-based number of the face in the order of the file, or None."""
    entity: str
    """A file, "loop 2", "element 7"; empty where the face says it all."""
    message: str
    """One sentence."""
    hint: str
    """What can be done; may be empty."""

    def __str__(self) -> str:
        where = [f"face {self.face}"] if self.face is not None else []
        where += [self.entity] if self.entity else []
        hint = f" ({self.hint})" if self.hint else ""
        return f"{', '.join(where)}{': ' if where else ''}{self.message}{hint} [{self.code}]"


class BeadmeshError(Exception):
    """Raised where a step fails as a whole. Carries the fields of its diagnostic."""

    def __init__(self, code: str, severity: str = "error", face: Optional[int] = None, entity: str = "",
                 message: str = "", hint: str = "") -> None:
        self.diagnostic = Diagnostic(code, severity, face, entity, message, hint)
        super().__init__(str(self.diagnostic))

    @property
    def code(self) -> str:
        return self.diagnostic.code

    @property
    def face(self) -> Optional[int]:
        return self.diagnostic.face

    @property
    def entity(self) -> str:
        return self.diagnostic.entity

    @property
    def message(self) -> str:
        return self.diagnostic.message

    @property
    def hint(self) -> str:
        return self.diagnostic.hint

    def __reduce__(self):
        d = self.diagnostic
        return BeadmeshError, (d.code, d.severity, d.face, d.entity, d.message, d.hint)
