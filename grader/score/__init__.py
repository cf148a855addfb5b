"""What are the findings worth, by which rubric?"""
