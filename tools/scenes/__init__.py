"""The bundled scenes of assets/scenes/, each made by one module from numbers that a person can read.

Every module that makes a scene has FILE (its name in assets/scenes/) and make() (its text).
"""
