"""What Python runs first in every box: it becomes enter.py, which then is not compiled anew.

Python keeps no compiled form of a script, only of what a script imports; that saves 4 ms a box.
"""

import sys

if __name__ == "__main__":
    # What is imported lies beside this file; pathlib would cost 8 ms.
    sys.path.insert(0, sys.argv[0].rpartition("/")[0])
    __import__("enter").main(sys.argv[1:])
