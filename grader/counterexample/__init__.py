"""How a failing check gets the smallest input that shows it, and how that is shown again."""
