// Makes lit materials shade light by light, with three's own functions: to count lights, or because the host changed
// these functions.
// Farol
#define FAROL_ONE_BY_ONE
