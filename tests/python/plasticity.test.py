"""Plastic strains as Python sees them."""

import copy

import package
from claims import claim, main

import numpy as np
import perimpact


@claim("plastic strains are those of particles that were crushed, and 0 without plasticity")
def strains(test):
    setup = copy.deepcopy(package.SETUP)
    elastic = perimpact.Simulation(setup)
    elastic.run(until=15e-6)
    test.assertTrue((elastic.bodies["plate"].plastic_strains == 0).all())
    # a blow of 32 m/s on this plate makes some hundred MPa
    setup["bodies"]["plate"]["material"] |= {"plasticity": {"surface": "von-mises", "compressive_strength": 100e6}}
    simulation = perimpact.Simulation(setup)
    simulation.run(until=9e-6)
    plate = simulation.bodies["plate"]
    strains = plate.plastic_strains
    test.assertEqual(strains.shape, (len(plate.occupied),))
    test.assertGreater(strains.max(), 0)
    test.assertTrue((strains[~plate.occupied] == 0).all())
    # the cylinder reaches the edge y = 30 mm after 7 us: waves of 5.4 km/s have gone 11 mm, and stresses reach a horizon of 15 mm further
    test.assertGreater(plate.references[strains > 0][:, 1].min(), 0)
    simulation.run(until=20e-6)
    test.assertGreater(simulation.history["plate.plastic_dissipation [J]"][-1], 0)


main()
