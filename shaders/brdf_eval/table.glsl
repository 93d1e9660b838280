// One row of a table: three texels. Keep in sync with src/render/gpu/shader_evaluator.hpp.
uniform samplerBuffer rows;
uniform int row_count;

out vec4 answer;

int row_number() { return 256 * int(gl_FragCoord.y) + int(gl_FragCoord.x); }
vec4 row_part(int part) { return texelFetch(rows, 3 * row_number() + part); }
