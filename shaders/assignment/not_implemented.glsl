// The value of a function whose body is still to be written: magenta, and counted, so that no check takes it for
// an answer. Take the components that you need: not_implemented().xyz.
int not_implemented_calls = 0; // in this invocation

vec4 not_implemented() {
    not_implemented_calls += 1;
    return vec4(1.0, 0.0, 1.0, 1.0);
}
