"""What the pages of every browser have: waiting for a condition."""

import time


class Waits:
    """For a class whose `value(expression)` evaluates JavaScript in its page."""

    def wait_for(self, expression, seconds=60):
        """Until it is true; the seconds that took."""
        begin = time.monotonic()
        while not self.value(expression):
            if time.monotonic() - begin > seconds:
                raise RuntimeError(f"after {seconds} s this is still not so: {expression}")
            time.sleep(0.05)
        return time.monotonic() - begin
