// solution by_a_double_loop
vec2 in_cell(int i, int side, vec2 u) {
    int row = i / side;
    return vec2(float(i - row * side) + u.x, float(row) + u.y) * (1.0 / float(side));
}
float E_stratified(int side, float seed) {
    float mean = 0.0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            int i = y * side + x;
            mean += E_of_sample((vec2(x, y) + random_2d(seed, i)) / float(side)) / float(side * side);
        }
    return mean;
}
// solution by_real_numbers
vec2 in_cell(int i, int side, vec2 u) {
    float s = float(side), row = floor((float(i) + 0.5) / s);
    return vec2(float(i) - row * s, row) / s + u / s;
}
float E_stratified(int side, float seed) {
    float mean = 0.0;
    for (int i = 0; i < side * side; ++i)
        mean += (E_of_sample(in_cell(i, side, random_2d(seed, i))) - mean) / float(i + 1);
    return mean;
}
// mistake not_divided
vec2 in_cell(int i, int side, vec2 u) { return (vec2(i % side, i / side) + u); }
float E_stratified(int side, float seed) {
    float sum = 0.0;
    for (int i = 0; i < side * side; ++i) sum += E_of_sample(in_cell(i, side, random_2d(seed, i)));
    return sum / float(side * side);
}
// mistake u_not_scaled
vec2 in_cell(int i, int side, vec2 u) { return vec2(i % side, i / side) / float(side) + u; }
float E_stratified(int side, float seed) {
    float sum = 0.0;
    for (int i = 0; i < side * side; ++i) sum += E_of_sample(in_cell(i, side, random_2d(seed, i)));
    return sum / float(side * side);
}
// mistake middle_of_the_cell
vec2 in_cell(int i, int side, vec2 u) { return (vec2(i % side, i / side) + 0.5) / float(side); }
float E_stratified(int side, float seed) {
    float sum = 0.0;
    for (int i = 0; i < side * side; ++i) sum += E_of_sample(in_cell(i, side, random_2d(seed, i)));
    return sum / float(side * side);
}
// mistake corner_of_the_cell
vec2 in_cell(int i, int side, vec2 u) { return (vec2(i % side, i / side)) / float(side); }
float E_stratified(int side, float seed) {
    float sum = 0.0;
    for (int i = 0; i < side * side; ++i) sum += E_of_sample(in_cell(i, side, random_2d(seed, i)));
    return sum / float(side * side);
}
// mistake rows_and_columns_exchanged
vec2 in_cell(int i, int side, vec2 u) { return (vec2(i / side, i % side) + u) / float(side); }
float E_stratified(int side, float seed) {
    float sum = 0.0;
    for (int i = 0; i < side * side; ++i) sum += E_of_sample(in_cell(i, side, random_2d(seed, i)));
    return sum / float(side * side);
}
// mistake same_row_and_column
vec2 in_cell(int i, int side, vec2 u) { return (vec2(i % side, i % side) + u) / float(side); }
float E_stratified(int side, float seed) {
    float sum = 0.0;
    for (int i = 0; i < side * side; ++i) sum += E_of_sample(in_cell(i, side, random_2d(seed, i)));
    return sum / float(side * side);
}
// mistake no_cells
vec2 in_cell(int i, int side, vec2 u) { return (vec2(i % side, i / side) + u) / float(side); }
float E_stratified(int side, float seed) {
    float sum = 0.0;
    for (int i = 0; i < side * side; ++i) sum += E_of_sample(random_2d(seed, i));
    return sum / float(side * side);
}
// mistake same_number_in_all
vec2 in_cell(int i, int side, vec2 u) { return (vec2(i % side, i / side) + u) / float(side); }
float E_stratified(int side, float seed) {
    float sum = 0.0;
    for (int i = 0; i < side * side; ++i) sum += E_of_sample(in_cell(i, side, random_2d(seed, 0)));
    return sum / float(side * side);
}
// mistake one_row
vec2 in_cell(int i, int side, vec2 u) { return (vec2(i % side, i / side) + u) / float(side); }
float E_stratified(int side, float seed) {
    float sum = 0.0;
    for (int i = 0; i < side; ++i) sum += E_of_sample(in_cell(i, side, random_2d(seed, i)));
    return sum / float(side);
}
// mistake divided_by_side
vec2 in_cell(int i, int side, vec2 u) { return (vec2(i % side, i / side) + u) / float(side); }
float E_stratified(int side, float seed) {
    float sum = 0.0;
    for (int i = 0; i < side * side; ++i) sum += E_of_sample(in_cell(i, side, random_2d(seed, i)));
    return sum / float(side);
}
