"""The dialect in which a rung is an if."""
