// A thin film, as of oil on a wet street: light reflected off its face and off its back meets itself, and what is left
// depends on the colour and on the angle. parameters: thickness [nm], index of refraction, share of the light that each
// face reflects. The sum over all reflections to and fro in the film is Airy's. Its twin: oil.twin.cpp.
vec3 oil(float cosine, vec4 parameters) {
    float index = parameters.y;
    float inFilm = sqrt(1.0 - (1.0 - cosine * cosine) / (index * index));
    // Wavelengths of red, green and blue [nm]; the way to the back and up again, in waves
    vec3 waves = 2.0 * index * parameters.x * inFilm / vec3(610.0, 545.0, 450.0);
    vec3 turns = 0.5 * (waves - floor(waves));
    vec3 sine = vec3(sinCosTurns(turns.r).x, sinCosTurns(turns.g).x, sinCosTurns(turns.b).x);
    float r = parameters.z;
    vec3 finesse = 4.0 * r / ((1.0 - r) * (1.0 - r)) * sine * sine;
    return finesse / (1.0 + finesse);
}
