"""The course's own lists: which results there are, and how a teacher's file is filled."""
