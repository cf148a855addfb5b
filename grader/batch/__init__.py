"""How is a whole class graded, and what is kept of it?"""
