"""The digest of a file's contents: what tells one text from another."""

from __future__ import annotations

try:
    # The module hashlib loads OpenSSL first, which takes longer than a repeated check has.
    from _blake2 import blake2b
except ImportError:  # another Python
    from hashlib import blake2b

__all__ = ["blake2b", "digest_of"]


def digest_of(data: bytes) -> str:
    """Forty hexadecimal digits."""
    return blake2b(data, digest_size=20).hexdigest()
