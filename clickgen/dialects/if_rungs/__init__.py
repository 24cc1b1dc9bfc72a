"""The dialect in which a rung is an ``if``."""

from clickgen.dialects.if_rungs.dialect import IfRungs

DIALECT = IfRungs()
"""What ``dialects/registry.py`` asks for."""
