// V(x, y): 1 where nothing stands between x and the emitter's point, 0 where something does.
//
// For now every emitter is seen from everywhere: shadows are the next chapter, and this is their place.

float visibility(vec3 x, vec3 wi, float distance) { return 1.0; }
