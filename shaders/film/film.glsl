// Sums of the film as floats.
#ifndef HYALITE_FILM_GLSL
#define HYALITE_FILM_GLSL
#include "shared/film.h"

vec3 filmColor(FilmColor sum) {
    return uintBitsToFloat(uvec3(filmValue(sum.red), filmValue(sum.green), filmValue(sum.blue)));
}
#endif
