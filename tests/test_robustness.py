"""stub"""
ROBUSTNESS: dict = {}
