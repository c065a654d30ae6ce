"""What Coin nodes of ours have in common."""

from pivy import coin


def unpickable():
    """A node after which nothing in its group is met by clicks, which are for what lies below."""
    node = coin.SoPickStyle()
    node.style = coin.SoPickStyle.UNPICKABLE
    return node


def unlit():
    """A node after which colours in its group are what they are, whatever light falls on them."""
    node = coin.SoLightModel()
    node.model = coin.SoLightModel.BASE_COLOR
    return node
