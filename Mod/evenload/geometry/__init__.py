"""Base geometry, models and stock: the floors that an operation clears, as regions."""
