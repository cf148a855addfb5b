"""What a course installs elsewhere: archives for Gradescope, PrairieLearn, GitHub and students.

Each archive is a function of what is installed here and of the course's own choices, and its
bytes are the same whenever it is made.
"""
