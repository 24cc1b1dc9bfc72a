"""Random programs: small models of the generated programs, their text in the language, and strategies for them.

Nothing here uses clickgen: tokens and meanings are written down again, from docs/language.md and
docs/click-facts.md.
"""
