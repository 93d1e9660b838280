// A mistake on purpose: the division by π is missing, of the diffuse lobe and so of most pixels.
vec3 f_lambert(vec3 albedo) { return albedo; }
