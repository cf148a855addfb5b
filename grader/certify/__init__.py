"""Is the grader itself right? Grades the corpus of right and wrong submissions."""
