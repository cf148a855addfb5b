"""What is the least that a grade can take, and how far is the program from it?"""

FLOOR = """## The floor
"""
