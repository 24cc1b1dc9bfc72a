"""Random programs: small models of what was generated, their text in the language, and strategies over them.

Nothing here uses clickgen: tokens and meanings are written down once more, from docs/language.md and
docs/click-facts.md.
"""
