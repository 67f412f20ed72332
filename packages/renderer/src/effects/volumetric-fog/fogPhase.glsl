// Phase function of fog. Henyey and Greenstein 1941, Diffuse radiation in the galaxy
//? farol_phase(0.5, 0.0) == 0.07957747154594767
//? farol_phase(1.0, 0.5) == 0.477464829275686
// share of light that is scattered by an angle, per steradian
float farol_phase(const in float cosine, const in float anisotropy) {
  float squared = anisotropy * anisotropy;
  return 0.07957747154594767 * (1.0 - squared) / pow(max(1.0 + squared - 2.0 * anisotropy * cosine, 1e-4), 1.5);
}
