"""Wrong inputs of every kind, and the contract that holds for all of them."""
