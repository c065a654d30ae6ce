"""Feeds and speeds that are suggested for an operation: what `evenload.optimise` finds within what
tool and machine stand, beside what is set now.
"""
