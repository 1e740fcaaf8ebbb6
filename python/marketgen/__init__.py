"""MarketGen's Python side: what only Python libraries can do, for the C++ program."""
