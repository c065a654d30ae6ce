"""_core.objects_of_type."""

import pytest
from evenload import compiled


class Plain:
    pass


class Derived(Plain):
    pass


def test_objects_of_a_type_and_of_those_derived_from_it_are_found():
    plain, derived = Plain(), Derived()
    others = [object(), Plain, [plain]]
    found = compiled.core().objects_of_type(Plain)
    assert any(each is plain for each in found) and any(each is derived for each in found)
    assert all(isinstance(each, Plain) for each in found)
    assert not any(each is other for each in found for other in others)
    assert [each for each in compiled.core().objects_of_type(Derived) if each is plain] == []


def test_it_asks_nothing_of_an_object_but_its_type():
    class Touchy:
        @property
        def __class__(self):
            raise RuntimeError("asked for its class")

    touchy = [Touchy(), Touchy()]
    assert len(compiled.core().objects_of_type(Touchy)) == len(touchy)


def test_what_is_no_type_is_refused():
    with pytest.raises(TypeError):
        compiled.core().objects_of_type(Plain())
