"""The families of scenes that `scenes/generate` writes, grouped by what moves in them."""
from families import arms, fleets, mobile, peers

FAMILIES = {family.name: family for module in (mobile, arms, peers, fleets)
            for family in module.FAMILIES}
