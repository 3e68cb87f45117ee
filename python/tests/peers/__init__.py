"""Other multibody engines, driven from the same resolved scenario as Kingpost.

``tree`` reads a resolved scenario into plain numbers, ``loads`` gives its forces, ``states`` makes seeded
random states, ``mujoco_peer`` and ``pinocchio_peer`` build the same model in each engine. Nothing here
imports Kingpost, so agreement is between independent derivations of the equations of motion.
"""
