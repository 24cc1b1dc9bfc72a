"""CLICK as a machine: its memory banks, limits, system points. Below every stage; knows none of them."""
