"""What every call raises that cannot do what was asked."""


class Error(RuntimeError):
    """A stable code, the place, and a sentence for a person.

    code     "camera.outside_store"
    where    the argument, the file and line, the flag
    message  what was wrong and what mends it
    """

    def __init__(self, code, where, message):
        super().__init__(f"{code} {where}: {message}" if where else f"{code}: {message}")
        self.code, self.where, self.message = code, where, message

    def __reduce__(self):
        return type(self), (self.code, self.where, self.message)
