// Numbers that every chapter shares.
const float pi = 3.14159265358979323846;
