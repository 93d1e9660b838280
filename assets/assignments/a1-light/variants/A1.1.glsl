// solution by_the_frequency
float photon_energy(float lambda) {
    float frequency = light_speed / (lambda * metres_per_nm);
    return planck * frequency;
}
float photons_per_second(float Phi, float lambda) { return Phi * (lambda * 1e-9) / (planck * light_speed); }
float photons_of_your_laser() { return laser_power / photon_energy(laser_wavelength); }
// solution in_electron_volts
float photon_energy(float lambda) { return 1239.841984 / lambda * 1.602176634e-19; }
float photons_per_second(float Phi, float lambda) { return Phi * lambda * 5.03411657e15; }
float photons_of_your_laser() { return photons_per_second(1.0, laser_wavelength) * laser_power; }
// mistake nm_for_m
float photon_energy(float lambda) { return planck * light_speed / lambda; }
float photons_per_second(float Phi, float lambda) { return Phi / photon_energy(lambda); }
float photons_of_your_laser() { return photons_per_second(laser_power, laser_wavelength); }
// mistake wavelength_for_frequency
float photon_energy(float lambda) { return planck * lambda * metres_per_nm; }
float photons_per_second(float Phi, float lambda) { return Phi / photon_energy(lambda); }
float photons_of_your_laser() { return photons_per_second(laser_power, laser_wavelength); }
// mistake times_wavelength
float photon_energy(float lambda) { return planck * light_speed * lambda * metres_per_nm; }
float photons_per_second(float Phi, float lambda) { return Phi / photon_energy(lambda); }
float photons_of_your_laser() { return photons_per_second(laser_power, laser_wavelength); }
// mistake light_speed_missing
float photon_energy(float lambda) { return planck / (lambda * metres_per_nm); }
float photons_per_second(float Phi, float lambda) { return Phi / photon_energy(lambda); }
float photons_of_your_laser() { return photons_per_second(laser_power, laser_wavelength); }
// mistake reduced_planck
float photon_energy(float lambda) { return planck / (2.0 * pi) * light_speed / (lambda * metres_per_nm); }
float photons_per_second(float Phi, float lambda) { return Phi / photon_energy(lambda); }
float photons_of_your_laser() { return photons_per_second(laser_power, laser_wavelength); }
// mistake energy_of_all_photons
float photon_energy(float lambda) { return planck * light_speed / (lambda * metres_per_nm); }
float photons_per_second(float Phi, float lambda) { return Phi * photon_energy(lambda); }
float photons_of_your_laser() { return photons_per_second(laser_power, laser_wavelength); }
// mistake flux_missing
float photon_energy(float lambda) { return planck * light_speed / (lambda * metres_per_nm); }
float photons_per_second(float Phi, float lambda) { return 1.0 / photon_energy(lambda); }
float photons_of_your_laser() { return photons_per_second(laser_power, laser_wavelength); }
