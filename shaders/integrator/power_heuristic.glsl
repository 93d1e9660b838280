// The share of the integral that a point of density p answers for, where another could have come with density q: the
// power heuristic (Veach & Guibas 1995, section 5.2, β = 2).
float power_heuristic(float p, float q) {
    float odds = q / p;
    return 1.0 / (1.0 + odds * odds);
}

// The same over p: where p was chosen and the integrand is over q.
float power_heuristic_over(float p, float q) {
    float odds = q / p;
    return 1.0 / (odds + 1.0 / odds); // power_heuristic(p, q) * odds
}
