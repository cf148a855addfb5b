"""What runs inside a box: staged as single files, standard library only, knows no answers."""
