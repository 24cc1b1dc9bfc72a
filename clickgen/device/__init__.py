"""What a CLICK is: its memory banks, limits, system points. Below every stage; knows none of them."""
