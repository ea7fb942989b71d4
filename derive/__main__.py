"""``python -m chainrule.derive``."""

import sys

from chainrule.derive.write import main

if __name__ == "__main__":
    sys.exit(main())
