"""Which one source file is in what a student handed in?"""
