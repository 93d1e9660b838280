// The rays that x sends to each light, as visibility() counts them (rays_per_light).
const int towards_light = 0; // to the point of the light's choice
const int along_brdf = 1;    // in the direction of the BRDF's choice
