// The cone through the ellipse c + a cos t + b sin t, in its own frame.
//
// Its dual quadric a aᵀ + b bᵀ - c cᵀ has the frame for eigenvectors and α², β², -γ² for eigenvalues, and stays finite
// where x lies in the ellipse's plane (there β = 0). Eigenvalues by Jacobi's rotations (Golub & Van Loan 2013, section
// 8.5), begun with c for an axis, so that small far ellipses keep all their digits.
#include "light/arc.glsl"

// Turns the axes p and q until the entry between them vanishes; r is the third axis.
void turn_away(inout float pp, inout float qq, inout float pq, inout float pr, inout float qr, inout vec3 p,
               inout vec3 q) {
    if (pq == 0.0) return;
    float h = (qq - pp) / (2.0 * pq);
    float t = (h >= 0.0 ? 1.0 : -1.0) / (abs(h) + sqrt(h * h + 1.0));
    float c = 1.0 / sqrt(t * t + 1.0);
    float s = t * c;
    pp -= t * pq;
    qq += t * pq;
    pq = 0.0;
    float r = pr;
    pr = c * r - s * qr;
    qr = s * r + c * qr;
    vec3 v = p;
    p = c * v - s * q;
    q = s * v + c * q;
}

vec3 perpendicular_to(vec3 v) {
    return normalize(abs(v.x) > abs(v.z) ? vec3(-v.y, v.x, 0.0) : vec3(0.0, -v.z, v.y));
}

// The whole cone; c is not zero.
Arc cone_arc(vec3 c, vec3 a, vec3 b) {
    float length_c = length(c);
    vec3 w = c / length_c;
    vec3 u = perpendicular_to(w);
    vec3 v = cross(w, u);
    vec3 A = vec3(dot(a, u), dot(a, v), dot(a, w));
    vec3 B = vec3(dot(b, u), dot(b, v), dot(b, w));
    vec3 diagonal = A * A + B * B - vec3(0.0, 0.0, length_c * length_c);
    float uv = A.x * A.y + B.x * B.y;
    float uw = A.x * A.z + B.x * B.z;
    float vw = A.y * A.z + B.y * B.z;
    for (int sweep = 0; sweep < 4; ++sweep) { // 3 do for all but the most slanted
        turn_away(diagonal.x, diagonal.z, uw, uv, vw, u, w);
        turn_away(diagonal.y, diagonal.z, vw, uv, uw, v, w);
        turn_away(diagonal.x, diagonal.y, uv, uw, vw, u, v);
    }
    // The negative eigenvalue last, the greatest first.
    mat3 axes = mat3(u, v, w);
    if (diagonal.x < diagonal.z) { diagonal = diagonal.zyx; axes = mat3(axes[2], axes[1], axes[0]); }
    if (diagonal.y < diagonal.z) { diagonal = diagonal.xzy; axes = mat3(axes[0], axes[2], axes[1]); }
    if (diagonal.x < diagonal.y) { diagonal = diagonal.yxz; axes = mat3(axes[1], axes[0], axes[2]); }
    axes[2] *= dot(axes[2], c) < 0.0 ? -1.0 : 1.0;
    axes[1] = cross(axes[2], axes[0]);
    vec3 size = sqrt(max(vec3(diagonal.xy, -diagonal.z), 0.0));
    bool is_open = size.y + size.z > 0.0; // not where x lies on the ellipse itself
    return Arc(axes, size, 0.0, is_open ? 2.0 * pi : 0.0);
}
